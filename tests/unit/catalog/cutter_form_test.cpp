// Radii of cutters over the height from their tips.

#include <gtest/gtest.h>

#include <cmath>

#include "stepmill/catalog/cutter_form.h"
#include "support/tool_makers.h"

namespace stepmill::test {
namespace {

TEST(CutterForm, OfAFlatEndMillIsAnUprightCylinder) {
    const CutterForm form(flatEndMill(10));
    EXPECT_EQ(form.radiusAt(0), 5);
    EXPECT_EQ(form.heightMm(), 0);
    EXPECT_EQ(form.radiusAt(-0.001), 0);
}

TEST(CutterForm, OfABallIsASphereThenAShank) {
    const CutterForm form(ballMill(6));
    EXPECT_EQ(form.radiusAt(0), 0);
    EXPECT_NEAR(form.radiusAt(1.5), std::sqrt(9 - 2.25), 1e-12);
    EXPECT_EQ(form.radiusAt(3), 3);
    EXPECT_EQ(form.radiusAt(20), 3);
}

TEST(CutterForm, OfABullNoseBeginsWithItsFlat) {
    const CutterForm form(bullNoseMill(12, 1));
    EXPECT_EQ(form.radiusAt(0), 5);
    EXPECT_NEAR(form.radiusAt(0.5), 5 + std::sqrt(0.75), 1e-12);
    EXPECT_EQ(form.heightMm(), 1);
}

TEST(CutterForm, OfAChamferMillIsACone) {
    const ToolAssembly tool = chamferMill(10, 2, 90);
    const CutterForm form(tool);
    EXPECT_EQ(form.radiusAt(0), 1);
    EXPECT_NEAR(form.radiusAt(2), 3, 1e-12);
    EXPECT_NEAR(form.heightMm(), 4, 1e-12);
    EXPECT_NEAR(flankLean(tool), std::sqrt(0.5), 1e-12);
}

}  // namespace
}  // namespace stepmill::test
