// Which levels of a form cutter a wall can do without.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/toolpath/form_passes.h"
#include "support/tolerances.h"
#include "support/tool_makers.h"

namespace stepmill {
namespace {

using test::kTol;

constexpr double kDepthMm = 4;
constexpr double kBandMm = 0.025;
constexpr double kLevelMm = 0.125;
/// Of a corner of 1 mm for ridges of 0.02 mm.
const double kAlongMm = 2 * std::sqrt(2 * 0.02 - 0.02 * 0.02);
/// By so much each wall lies farther in at the floor.
const double kSteepMm = kDepthMm * std::tan(kPi / 6);
const double kFlatMm = kDepthMm * std::tan(kPi / 3);

Region twoWallsAt(double z_mm) {
    const double down = std::clamp(-z_mm / kDepthMm, 0.0, 1.0);
    return makeRectangle({20 + kSteepMm * down, 20}, {60 - kFlatMm * down, 50});
}

/// A pocket whose wall towards -x leans by 30 degrees from upright and whose wall towards +x by 60.
FormGround twoWallGround() {
    const Region block = makeRectangle({0, 0}, {80, 70});
    FormGround ground;
    ground.window = block;
    ground.must_stand = {{-kDepthMm - 2, -kDepthMm, block}};
    for (int i = 0; i < std::lround(kDepthMm / kBandMm); ++i) {
        const double bottom_mm = -kDepthMm + i * kBandMm;
        ground.must_stand.push_back(
            {bottom_mm, bottom_mm + kBandMm, subtract(block, twoWallsAt(bottom_mm), kTol)});
    }
    ground.stairs = {{-kDepthMm, 0, subtract(twoWallsAt(0), twoWallsAt(-kDepthMm), kTol)}};
    ground.obstacles = ground.must_stand;
    return ground;
}

/// Heights at which there is a pass along either wall, from above.
struct Passed {
    std::vector<double> steep_mm;
    std::vector<double> flat_mm;
};

Passed heightsPassed(double along_wall_mm) {
    const FormGround ground = twoWallGround();
    const FormBands bands(ground, kTol);
    const ToolAssembly tool = test::bullNoseMill(8, 1);
    const FormCentres centres(bands, tool);
    const CutterForm form(tool);
    StandingStairs stairs(ground, kTol);
    const toolpath::ShallowGround none;
    toolpath::FormPasses passes(centres, form, {3, 0.06, along_wall_mm}, none, kTol);
    Passed found;
    for (double z_mm = -kLevelMm; z_mm > -kDepthMm + kLevelMm / 2; z_mm -= kLevelMm) {
        const toolpath::FormLevel level = passes.at(z_mm, stairs, z_mm - kLevelMm);
        stairs.cut({z_mm, level.passes}, form);
        bool steep = false, flat = false;
        for (const Path& pass : level.passes)
            for (const auto& [from, segment] : eachEdge(pass)) {
                if (std::abs(from.x() - segment.to.x()) > 1e-6) continue;
                steep = steep || from.x() < 30;
                flat = flat || from.x() > 50;
            }
        if (steep) found.steep_mm.push_back(z_mm);
        if (flat) found.flat_mm.push_back(z_mm);
    }
    return found;
}

double farthestApart(const std::vector<double>& heights_mm) {
    double most_mm = 0;
    for (std::size_t i = 0; i + 1 < heights_mm.size(); ++i)
        most_mm = std::max(most_mm, heights_mm[i] - heights_mm[i + 1]);
    return most_mm;
}

TEST(FormPasses, PassEachLevelWhereNoneMayWait) {
    const Passed all = heightsPassed(0);
    EXPECT_NEAR(farthestApart(all.steep_mm), kLevelMm, 1e-9);
    EXPECT_NEAR(farthestApart(all.flat_mm), kLevelMm, 1e-9);
}

TEST(FormPasses, LeaveOutWhatTheSteepWallCanDoWithout) {
    const Passed some = heightsPassed(kAlongMm);
    // Two levels are 0.289 mm along the steep wall, one is 0.25 mm along the flat one, of 0.398 mm.
    EXPECT_NEAR(farthestApart(some.steep_mm), 2 * kLevelMm, 1e-9);
    EXPECT_NEAR(farthestApart(some.flat_mm), kLevelMm, 1e-9);
    EXPECT_LT(some.steep_mm.size(), some.flat_mm.size());
}

TEST(FormPasses, KeepNoFartherApartThanIsAskedFor) {
    EXPECT_NEAR(farthestApart(heightsPassed(0.295).steep_mm), 2 * kLevelMm, 1e-9);
    EXPECT_NEAR(farthestApart(heightsPassed(0.285).steep_mm), kLevelMm, 1e-9);
}

}  // namespace
}  // namespace stepmill
