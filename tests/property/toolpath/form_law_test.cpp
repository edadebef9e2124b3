// Form cutters in random pockets whose walls lean or bend: a sampler that knows the walls' formula finds no
// gouge.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "stepmill/access/form_centres.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/toolpath/form_passes.h"
#include "support/dice.h"
#include "support/tolerances.h"
#include "support/tool_makers.h"

namespace stepmill::test {
namespace {

using test::kTol;
constexpr int kPockets = 40;
constexpr double kStockMm = 100;
/// Of what stood: ways that are joined or parted leave other skins.
constexpr double kSameShare = 1e-3;

/// A pocket round a rectangle: at height z it reaches `reachMm(z)` beyond it, less and less downwards.
struct LeaningPocket {
    enum class Wall { Straight, Hollow, Round };
    Wall wall = Wall::Straight;
    double half_x_mm = 0;
    double half_y_mm = 0;
    double reach_mm = 0;   ///< at the top, z = 0
    double inward_mm = 0;  ///< by so much less at the floor
    double depth_mm = 0;

    double reachMm(double z_mm) const {
        const double down = std::clamp(-z_mm / depth_mm, 0.0, 1.0);
        const double share = wall == Wall::Straight ? down
                             : wall == Wall::Hollow ? 1 - std::sqrt(1 - down * down)
                                                    : std::sqrt(1 - (1 - down) * (1 - down));
        return reach_mm - inward_mm * share;
    }

    Region at(double z_mm) const {
        const Vec2 half(half_x_mm + reachMm(z_mm), half_y_mm + reachMm(z_mm));
        const Vec2 middle(kStockMm / 2, kStockMm / 2);
        return makeRoundedRectangle(middle - half, middle + half, reachMm(z_mm));
    }

    /// How far a point lies beyond the rectangle; negative inside.
    double beyond(const Vec2& p) const {
        const Vec2 off = (p - Vec2(kStockMm / 2, kStockMm / 2)).cwiseAbs() - Vec2(half_x_mm, half_y_mm);
        return off.maxCoeff() <= 0 ? off.maxCoeff() : off.cwiseMax(0).norm();
    }
};

LeaningPocket randomPocket(Dice& dice) {
    LeaningPocket pocket;
    pocket.wall =
        dice.oneOf({LeaningPocket::Wall::Straight, LeaningPocket::Wall::Hollow, LeaningPocket::Wall::Round});
    pocket.half_x_mm = dice.between(8, 20);
    pocket.half_y_mm = dice.between(8, 20);
    pocket.depth_mm = dice.between(2, 6, 0.5);
    pocket.inward_mm = dice.between(0.5, 4);
    pocket.reach_mm = pocket.inward_mm + dice.between(3.5, 6);
    return pocket;
}

Region blockLess(const Region& region) {
    return subtract(makeRectangle({0, 0}, {kStockMm, kStockMm}), region, kTol);
}

/// Layers of two millimetres at most, bands of `band_mm`; below the floor the block is whole.
FormGround groundOf(const LeaningPocket& pocket, double band_mm) {
    FormGround ground;
    ground.id = formGroundId("S1");
    ground.setup_id = "S1";
    ground.window = makeRectangle({-40, -40}, {kStockMm + 40, kStockMm + 40});
    const double floor = -pocket.depth_mm;
    ground.must_stand.push_back({floor - 5, floor, blockLess({})});
    for (double z = floor; z < -1e-9; z += band_mm)
        ground.must_stand.push_back({z, std::min(0.0, z + band_mm), blockLess(pocket.at(z))});
    ground.obstacles.push_back({floor - 5, floor, blockLess({})});
    for (double z = floor; z < -1e-9; z += 2) {
        const double top = std::min(0.0, z + 2);
        ground.stairs.push_back({z, top, subtract(pocket.at(top), pocket.at(z), kTol)});
        ground.obstacles.push_back({z, top, blockLess(pocket.at(z))});
    }
    return ground;
}

ToolAssembly randomCutter(Dice& dice) {
    switch (dice.below(3)) {
        case 0:
            return ballMill(dice.between(2, 8, 1));
        case 1:
            return bullNoseMill(dice.between(4, 10, 1), dice.between(0.5, 1.5, 0.25));
        default:
            return chamferMill(dice.between(6, 10, 1), dice.between(0, 2, 0.5),
                               dice.oneOf({60.0, 90.0, 120.0}));
    }
}

/// Radius of the cutter at a height over its tip, said in another way than the planner does.
double radiusOf(const ToolAssembly& tool, double height_mm) {
    const double full = tool.diameter_mm / 2;
    if (tool.type == ToolType::Chamfer)
        return std::min(full, tool.tip_diameter_mm / 2 +
                                  height_mm * std::tan(tool.included_angle_deg / 360 * 3.14159265358979));
    const double corner = tool.corner_radius_mm;
    return height_mm >= corner ? full : full - corner + corner * std::sin(std::acos(1 - height_mm / corner));
}

/// How deep the cutter is in the pocket's wall or floor with its tip there; negative: clear of it.
double gougeAt(const LeaningPocket& pocket, const ToolAssembly& tool, const Vec3& tip) {
    double worst = -pocket.depth_mm - tip.z();
    const double beyond = pocket.beyond(tip.head<2>());
    for (double z = tip.z(); z < 0; z += 0.02)
        worst = std::max(worst, beyond + radiusOf(tool, z - tip.z()) - pocket.reachMm(z));
    return worst;
}

double worstGouge(const LeaningPocket& pocket, const ToolAssembly& tool, const Toolpath& path) {
    double worst = -1e9;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const Segment flat{move.to.head<2>(), move.arc};
        const double way = length(Vec2(from.head<2>()), flat);
        const int steps = std::max(1, static_cast<int>(std::ceil(way / 0.5)));
        for (int i = 0; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            const Vec2 at = pointAt(from.head<2>(), flat, share);
            worst = std::max(
                worst, gougeAt(pocket, tool, {at.x(), at.y(), from.z() + share * (move.to.z() - from.z())}));
        }
        from = move.to;
    }
    return worst;
}

/// The levels at every band's end that the cutter finds something to do at.
/// \param along_wall_mm  how far passes may be apart; 0: no level is left out anywhere
std::vector<toolpath::FormLevel> levelsOf(const FormGround& ground, const ToolAssembly& tool,
                                          StandingStairs& stairs, double along_wall_mm = 0) {
    const FormBands bands(ground, kTol);
    const FormCentres centres(bands, tool);
    const CutterForm form(tool);
    const toolpath::ShallowGround none;
    toolpath::FormPasses passes(centres, form, {1.5, 0.03, along_wall_mm}, none, kTol);
    std::vector<toolpath::FormLevel> levels;
    for (std::size_t i = ground.must_stand.size(); i-- > 1;) {
        const double tip = ground.must_stand[i].bottom_z_mm;
        const std::optional<double> next =
            i > 1 ? std::optional(ground.must_stand[i - 1].bottom_z_mm) : std::nullopt;
        levels.push_back(passes.at(tip, stairs, next));
        stairs.cut({tip, levels.back().passes}, form);
    }
    return levels;
}

TEST(FormPasses, NeverGougeRandomLeaningPockets) {
    int with_passes = 0;
    for (int seed = 0; seed < kPockets; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(static_cast<std::uint64_t>(seed));
        const LeaningPocket pocket = randomPocket(dice);
        const ToolAssembly tool = randomCutter(dice);
        const FormGround ground = groundOf(pocket, dice.between(0.1, 0.4));
        StandingStairs stairs(ground, kTol);
        const double before_mm3 = stairs.volumeMm3();
        const std::vector<toolpath::FormLevel> levels = levelsOf(ground, tool, stairs);
        Machine machine;
        machine.rapid_mm_per_min = 5000;
        const auto [path, between] =
            toolpath::formPath({ground, 5, false}, levels, {}, tool, tool.cutting.front(), machine, kTol);
        for (const LevelWays& ways : between)
            stairs.cut(ways, CutterForm(tool));
        StandingStairs moved_over(ground, kTol);
        for (const LevelWays& ways : levelWays(path.start, path.moves))
            moved_over.cut(ways, CutterForm(tool));
        EXPECT_NEAR(moved_over.volumeMm3(), stairs.volumeMm3(), kSameShare * before_mm3);
        EXPECT_LE(stairs.volumeMm3(), before_mm3);
        if (path.moves.empty()) continue;
        ++with_passes;
        EXPECT_LE(worstGouge(pocket, tool, path), kTol.gouge_mm);
        EXPECT_EQ(path.moves.back().to.z(), 5);
    }
    EXPECT_GT(with_passes, kPockets / 2);
}

/// Of half of the pockets another cutter has been there before.
TEST(FormPasses, ArePassedNowhereInAStretchWhereNoneMayBe) {
    int ruled_out = 0;
    int with_passes = 0;
    for (int seed = 0; seed < kPockets / 2; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(static_cast<std::uint64_t>(seed));
        const LeaningPocket pocket = randomPocket(dice);
        const FormGround ground = groundOf(pocket, dice.between(0.1, 0.4));
        StandingStairs stairs(ground, kTol);
        if (dice.between(0, 1) < 0.5) levelsOf(ground, randomCutter(dice), stairs);
        const FormBands bands(ground, kTol);
        const ToolAssembly tool = randomCutter(dice);
        const FormCentres centres(bands, tool);
        const CutterForm form(tool);
        const toolpath::ShallowGround none;
        const std::size_t count = ground.must_stand.size();
        for (std::size_t size = 1; size < count; size *= 2)
            for (std::size_t first = 1; first + size <= count; first += size) {
                toolpath::FormPasses passes(centres, form, {1.5, 0.03, 0}, none, kTol);
                const double top_mm = ground.must_stand[first + size - 1].bottom_z_mm;
                if (passes.mayPass(top_mm, ground.must_stand[first].bottom_z_mm, stairs)) {
                    ++with_passes;
                    continue;
                }
                ++ruled_out;
                for (std::size_t i = first; i < first + size; ++i)
                    EXPECT_TRUE(
                        passes.at(ground.must_stand[i].bottom_z_mm, stairs, std::nullopt).passes.empty())
                        << "band " << i << " of " << first << " and " << size;
            }
    }
    EXPECT_GT(ruled_out, 100);
    EXPECT_GT(with_passes, 100);
}

double lengthOf(const std::vector<toolpath::FormLevel>& levels) {
    double sum_mm = 0;
    for (const toolpath::FormLevel& level : levels)
        for (const Path& pass : level.passes)
            sum_mm += length(pass);
    return sum_mm;
}

/// A left-out level costs ridges of a scallop, and the skin of a band where one more level would have had
/// another.
TEST(FormPasses, LeaveNoMoreThanRidgesWhereALevelIsLeftOut) {
    constexpr double kScallopMm = 0.02;
    constexpr double kBandMm = 0.04;
    constexpr int kFewPockets = kPockets / 4;
    int shorter = 0;
    for (int seed = 0; seed < kFewPockets; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(static_cast<std::uint64_t>(seed));
        const LeaningPocket pocket = randomPocket(dice);
        const ToolAssembly tool = dice.oneOf({ballMill(6), bullNoseMill(8, 1)});
        const FormGround ground = groundOf(pocket, kBandMm);
        StandingStairs all_levels(ground, kTol);
        StandingStairs some_levels = all_levels;
        const double along_mm =
            2 * std::sqrt(2 * tool.corner_radius_mm * kScallopMm - kScallopMm * kScallopMm);
        const double all_mm = lengthOf(levelsOf(ground, tool, all_levels));
        const double some_mm = lengthOf(levelsOf(ground, tool, some_levels, along_mm));
        EXPECT_LE(some_mm, all_mm * (1 + 1e-9));
        if (some_mm < 0.7 * all_mm) ++shorter;
        const double wall_mm2 = perimeter(pocket.at(0)) * std::hypot(pocket.depth_mm, pocket.inward_mm);
        EXPECT_LE(some_levels.volumeMm3(), all_levels.volumeMm3() + (kScallopMm + kBandMm) * wall_mm2);
    }
    EXPECT_GT(shorter, kFewPockets / 2);
}

TEST(FormPasses, OfABallTakeNearlyAllOffAWallOfFortyFiveDegrees) {
    LeaningPocket pocket;
    pocket.half_x_mm = pocket.half_y_mm = 15;
    pocket.depth_mm = pocket.inward_mm = 4;
    pocket.reach_mm = 8;
    const FormGround ground = groundOf(pocket, 0.05);
    StandingStairs stairs(ground, kTol);
    const double before_mm3 = stairs.volumeMm3();
    levelsOf(ground, ballMill(4), stairs);
    // In the corner at the floor a ball leaves what its own radius takes.
    EXPECT_LT(stairs.volumeMm3(), 0.15 * before_mm3);
}

}  // namespace
}  // namespace stepmill::test
