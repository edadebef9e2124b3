// Lines of form cutters over shallow ground of which the formula is known.

#include <gtest/gtest.h>

#include <cmath>

#include "stepmill/planar/boolean.h"
#include "stepmill/toolpath/surface_passes.h"
#include "support/dice.h"
#include "support/tolerances.h"
#include "support/tool_makers.h"

namespace stepmill::test {
namespace {

constexpr int kGrounds = 12;
constexpr double kScallopMm = 0.02;
constexpr double kBandMm = 0.02;
constexpr double kHalfMm = 50;
/// Of what is high where lines are: bands and pieces of lines rise so much, and heights are rounded.
constexpr double kSkinMm = kBandMm + 0.02;

/// A block under part of a ball, a dome or a dish, or under a plane that slopes; z = 0 at its highest place.
struct RoundedBlock {
    enum class Top { Dome, Dish, Slope };
    Top top = Top::Dome;
    double radius_mm = 0;  ///< of the ball
    double rim_mm = 0;     ///< of the circle within which it is so
    Vec2 rise = Vec2::Zero();

    double sagMm(double from_middle_mm) const {
        return radius_mm - std::sqrt(radius_mm * radius_mm - from_middle_mm * from_middle_mm);
    }
    double deepMm() const { return top == Top::Slope ? 2 * rise.norm() * rim_mm : sagMm(rim_mm); }
    double heightAt(const Vec2& p) const {
        if (p.norm() >= rim_mm) return top == Top::Dome ? -deepMm() : 0;
        switch (top) {
            case Top::Dome:
                return -sagMm(p.norm());
            case Top::Dish:
                return sagMm(p.norm()) - deepMm();
            default:
                return rise.dot(p) - rise.norm() * rim_mm;
        }
    }
    /// All that it covers at some height from that one up.
    Region from(double z_mm) const {
        const Region all = makeRectangle({-kHalfMm, -kHalfMm}, {kHalfMm, kHalfMm});
        const Region rim = makeCircle({0, 0}, rim_mm);
        if (top == Top::Slope) {
            const Vec2 up = rise.normalized();
            const Vec2 side(-up.y(), up.x());
            const Vec2 low = up * (z_mm / rise.norm() + rim_mm);
            const Path half{low - 200 * side,
                            {{low + 200 * side, std::nullopt},
                             {low + 200 * side + 200 * up, std::nullopt},
                             {low - 200 * side + 200 * up, std::nullopt},
                             {low - 200 * side, std::nullopt}}};
            return unite(subtract(all, rim, kTol), intersect(rim, Region{{reversed(half)}}, kTol), kTol);
        }
        const double sag = top == Top::Dome ? -z_mm : z_mm + deepMm();
        const double at_mm = std::sqrt(std::max(0.0, sag * (2 * radius_mm - sag)));
        if (at_mm < 1e-3) return top == Top::Dome ? Region{} : all;
        const Region circle = makeCircle({0, 0}, at_mm);
        return top == Top::Dome ? circle : subtract(all, circle, kTol);
    }
};

RoundedBlock randomBlock(Dice& dice) {
    RoundedBlock block;
    block.top = dice.oneOf({RoundedBlock::Top::Dome, RoundedBlock::Top::Dish, RoundedBlock::Top::Slope});
    block.radius_mm = dice.between(120, 300);
    block.rim_mm = dice.between(15, 25);
    const double turned = dice.between(0, 6.28);
    block.rise = dice.between(0.03, 0.2) * Vec2(std::cos(turned), std::sin(turned));
    return block;
}

FormGround roundGround(const RoundedBlock& block) {
    FormGround ground;
    ground.id = formGroundId("S1");
    ground.setup_id = "S1";
    ground.window = makeRectangle({-kHalfMm, -kHalfMm}, {kHalfMm, kHalfMm});
    const double deep_mm = block.deepMm();
    ground.must_stand.push_back({-deep_mm - 5, -deep_mm, ground.window});
    for (double z = -deep_mm; z < -1e-9; z += kBandMm)
        ground.must_stand.push_back({z, std::min(0.0, z + kBandMm), block.from(z)});
    ground.stairs.push_back({-deep_mm, 0, makeCircle({0, 0}, block.rim_mm)});
    return ground;
}

ToolAssembly randomRoundCutter(Dice& dice) {
    return dice.below(2) == 0 ? ballMill(dice.between(4, 10, 1))
                              : bullNoseMill(dice.between(6, 12, 1), dice.between(0.5, 2, 0.25));
}

/// The tip's lowest height over a place as the formula has it, looked at in points under the cutter.
double lowestTip(const RoundedBlock& block, const ToolAssembly& tool, const Vec2& at) {
    const double full = tool.diameter_mm / 2;
    const double corner = tool.corner_radius_mm;
    double lowest = -1e9;
    for (double out = 0; out < full; out += full / 40)
        for (int i = 0; i < 32; ++i) {
            const double turned = i * 0.19634954;
            const double beyond = std::max(0.0, out - (full - corner));
            const double over = corner - std::sqrt(std::max(0.0, corner * corner - beyond * beyond));
            const Vec2 under = at + out * Vec2(std::cos(turned), std::sin(turned));
            lowest = std::max(lowest, block.heightAt(under) - over);
        }
    return lowest;
}

/// Height over the ground that all ways leave at a place.
double leftAt(const RoundedBlock& block, const ToolAssembly& tool, const std::vector<SurfaceWay>& ways,
              const Vec2& at) {
    const double full = tool.diameter_mm / 2;
    const double corner = tool.corner_radius_mm;
    double least = 1e9;
    for (const SurfaceWay& way : ways)
        for (std::size_t i = 0; i + 1 < way.size(); ++i) {
            const Vec2 from = way[i].head<2>();
            const Vec2 by = way[i + 1].head<2>() - from;
            const int steps = 1 + static_cast<int>(by.norm() / 0.05);
            const double near = full + by.norm();
            if ((from - at).norm() > near) continue;
            for (int k = 0; k <= steps; ++k) {
                const double share = static_cast<double>(k) / steps;
                const double out = (from + share * by - at).norm();
                if (out >= full) continue;
                const double beyond = std::max(0.0, out - (full - corner));
                const double over = corner - std::sqrt(std::max(0.0, corner * corner - beyond * beyond));
                least = std::min(least, way[i].z() + share * (way[i + 1].z() - way[i].z()) + over);
            }
        }
    return least - block.heightAt(at);
}

TEST(SurfacePasses, KeepOffRoundGroundAndLeaveRidgesOfAScallop) {
    int with_lines = 0;
    for (int seed = 0; seed < kGrounds; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(static_cast<std::uint64_t>(seed));
        const RoundedBlock block = randomBlock(dice);
        const ToolAssembly tool = randomRoundCutter(dice);
        const FormGround ground = roundGround(block);
        const CutterForm form(tool);
        const FormFloor floor(ground, tool, kTol);
        const Region centres = offset(ground.window, -form.fullRadiusMm() - 0.01, kTol);
        const Region& stairs = ground.stairs.front().section;
        const toolpath::ShallowGround shallow(floor, form, stairs, stairs, centres, kTol);
        const std::vector<SurfaceWay> ways =
            toolpath::surfacePasses(shallow, floor, form, {kScallopMm, form.fullRadiusMm()}, kTol);
        if (ways.empty()) continue;
        ++with_lines;
        double worst = 1e9;
        for (const SurfaceWay& way : ways)
            for (std::size_t i = 0; i + 1 < way.size(); ++i)
                for (const double share : {0.0, 0.5})
                    if (dice.below(4) == 0) {
                        const Vec3 at = way[i] + share * (way[i + 1] - way[i]);
                        worst = std::min(worst, at.z() - lowestTip(block, tool, at.head<2>()));
                    }
        EXPECT_GE(worst, -kTol.gouge_mm);
        // Well inside the rim, at places off the grid of cells.
        std::vector<double> left;
        for (int i = 0; i < 60; ++i) {
            const double turned = dice.between(0, 6.28);
            const double out = dice.between(0, block.rim_mm / 3);
            left.push_back(leftAt(block, tool, ways, out * Vec2(std::cos(turned), std::sin(turned))));
        }
        std::sort(left.begin(), left.end());
        // The flat of a bull nose does not reach into a dish.
        const double flat_mm =
            block.top == RoundedBlock::Top::Dish ? block.sagMm(form.fullRadiusMm() - form.heightMm()) : 0;
        EXPECT_LE(left[left.size() * 9 / 10], kScallopMm + kSkinMm + flat_mm);
    }
    EXPECT_GT(with_lines, kGrounds / 2);
}

}  // namespace
}  // namespace stepmill::test
