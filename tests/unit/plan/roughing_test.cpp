// Features as roughing sees them.

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/feature/describe_boundary.h"
#include "stepmill/plan/roughing.h"
#include "support/grounds.h"
#include "support/shape_makers.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using namespace test;

using test::kTol;
constexpr FinishAllowance kHalf{0.5, 0.5};

double allowanceMm3(const FeatureSet& found) {
    double sum_mm3 = 0;
    for (const Unplanned& entry : found.unplanned)
        if (entry.reason == Reason::Allowance) sum_mm3 += entry.volume_mm3;
    return sum_mm3;
}

double volumeMm3(const FeatureSet& found) {
    double sum_mm3 = 0;
    for (const Feature& feature : found.features)
        sum_mm3 += feature.volume_mm3;
    return sum_mm3;
}

/// 60 x 40, 10 deep, and in its floor 30 x 20, 5 deep.
FeatureSet pocketInPocket() {
    FeatureSet found;
    found.features.push_back(closedPocket(makeRectangle({0, 0}, {60, 40}), 10));
    Feature nested = closedPocket(makeRectangle({10, 10}, {40, 30}), 5);
    nested.id = "S1.F2";
    nested.parents = {"S1.F1"};
    nested.top_z_mm = -10;
    nested.floor_z_mm = -15;
    nested.obstacles.front().bottom_z_mm = -15;
    found.features.push_back(nested);
    for (Feature& feature : found.features)
        describeBoundary(feature, kTol);
    return found;
}

FeatureSet roughed(const FeatureSet& found, const FinishAllowance& leaves) {
    return withAllowance(found, leaves, defaultToolLibrary(), "aluminium", kTol);
}

TEST(WithAllowance, MovesWallsInAndFloorsUp) {
    const FeatureSet rough = roughed(pocketInPocket(), {0.5, 0.3});
    ASSERT_EQ(rough.features.size(), 2U);
    const Feature& outer = rough.features[0];
    EXPECT_NEAR(outer.area_mm2, 59 * 39, 1e-6);
    EXPECT_DOUBLE_EQ(outer.top_z_mm, 0);
    EXPECT_DOUBLE_EQ(outer.floor_z_mm, -9.7);
    const Feature& inner = rough.features[1];
    EXPECT_NEAR(inner.area_mm2, 29 * 19, 1e-6);
    EXPECT_DOUBLE_EQ(inner.top_z_mm, -9.7);  // it takes what the outer one leaves over its mouth
    EXPECT_DOUBLE_EQ(inner.floor_z_mm, -14.7);
}

TEST(WithAllowance, BooksWhatStays) {
    const FeatureSet whole = pocketInPocket();
    const FeatureSet rough = roughed(whole, kHalf);
    EXPECT_NEAR(volumeMm3(rough) + allowanceMm3(rough), volumeMm3(whole), 1e-6);
    EXPECT_GT(allowanceMm3(rough), 0);
}

TEST(WithAllowance, LeavesNoFeatureWhereAllIsAllowance) {
    FeatureSet found;
    found.features.push_back(closedPocket(makeRectangle({0, 0}, {60, 0.8}), 10));
    found.features.front().volume_mm3 = 480;
    const FeatureSet rough = roughed(found, kHalf);
    EXPECT_TRUE(rough.features.empty());
    EXPECT_NEAR(allowanceMm3(rough), 480, 1e-9);
}

TEST(WithAllowance, GivesTheChildrenOfAFeatureThatIsGoneItsPlace) {
    FeatureSet found = pocketInPocket();
    found.features[0].floor_z_mm = found.features[1].top_z_mm = -0.4;
    const FeatureSet rough = roughed(found, kHalf);
    ASSERT_EQ(rough.features.size(), 1U);
    EXPECT_TRUE(rough.features[0].parents.empty());
    EXPECT_DOUBLE_EQ(rough.features[0].top_z_mm, 0);
}

TEST(WithAllowance, MakesDrilledHolesToSize) {
    FeatureSet found;
    found.features.push_back(closedPocket(makeCircle({0, 0}, 4), 10));
    describeBoundary(found.features.front(), kTol);
    ASSERT_EQ(found.features.front().feature_class, FeatureClass::HoleBlind);
    const FeatureSet rough = roughed(found, kHalf);
    ASSERT_EQ(rough.features.size(), 1U);
    EXPECT_DOUBLE_EQ(rough.features[0].area_mm2, found.features[0].area_mm2);
    EXPECT_DOUBLE_EQ(rough.features[0].floor_z_mm, -10);
}

}  // namespace
}  // namespace stepmill
