// Heights at which form cutters go along walls.

#include <gtest/gtest.h>

#include <cmath>

#include "plan/forms/form_levels.h"
#include "stepmill/planar/region.h"
#include "support/tool_makers.h"

namespace stepmill {
namespace {

constexpr double kDepthMm = 4;
constexpr double kBandMm = 0.08;
constexpr double kScallopMm = 0.02;
constexpr double kStepDownMm = 2;

/// Bands of one wall that leans so much, as a sine from upright.
FormSite leaningWall(double lean) {
    FormSite site;
    for (int i = 0; i < std::lround(kDepthMm / kBandMm); ++i) {
        const double bottom_mm = -kDepthMm + i * kBandMm;
        site.ground.must_stand.push_back({bottom_mm, bottom_mm + kBandMm, makeRectangle({0, 0}, {10, 10})});
        site.leans.push_back({lean});
    }
    site.ground.stairs = {{-kDepthMm, 0, makeRectangle({10, 0}, {15, 10})}};
    site.feet_mm = {-kDepthMm};
    return site;
}

std::vector<double> levelsOf(double lean, const ToolAssembly& tool) {
    return formLevels(leaningWall(lean), tool, kStepDownMm, kScallopMm);
}

TEST(FormLevels, AreAsFarApartAsTheScallopAllowsAndNoFarther) {
    const ToolAssembly tool = test::bullNoseMill(12, 1);
    for (const double lean : {0.2, 0.5, 0.8}) {
        SCOPED_TRACE(lean);
        const std::vector<double> levels = levelsOf(lean, tool);
        const double most_mm = alongWallMm(1, kScallopMm) * std::sqrt(1 - lean * lean);
        ASSERT_GE(levels.size(), 3U);
        // Below the first, which is over the wall, and above the last, the foot.
        for (std::size_t i = 1; i + 2 < levels.size(); ++i) {
            EXPECT_LE(levels[i] - levels[i + 1], most_mm + 1e-9);
            EXPECT_GE(levels[i] - levels[i + 1], most_mm - 2e-4);
        }
    }
}

TEST(FormLevels, EndAtTheFootOfTheStairs) {
    const std::vector<double> levels = levelsOf(0.5, test::ballMill(6));
    EXPECT_NEAR(levels.back(), -kDepthMm, 1e-9);
}

}  // namespace
}  // namespace stepmill
