#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/units.h"
#include "stepmill/plan/books.h"
#include "stepmill/plan/plan.h"
#include "support/occt_solids.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::box;
using test::cut;
using test::cylinder;
using test::kTol;

TopoDS_Shape alongY(double x, double z, double from_y, double radius, double length) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, from_y, z), gp::DY()), radius, length).Shape();
}

Plan planned(const TopoDS_Shape& shape) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    return planPart(test::part(shape), request, defaultToolLibrary(), defaultMachine(), kTol);
}

/// Depths of the setup's features, if each is a hole through which one drill alone goes.
std::vector<double> drilledDepths(const PlannedSetup& setup) {
    std::vector<double> depths_mm;
    for (const PlannedFeature& planned : setup.features) {
        EXPECT_EQ(planned.feature.feature_class, FeatureClass::HoleThrough) << planned.feature.id;
        EXPECT_EQ(planned.sequence.steps.size(), 1U) << planned.feature.id;
        for (const SequenceStep& step : planned.sequence.steps)
            EXPECT_EQ(step.role, Role::Drill) << planned.feature.id;
        depths_mm.push_back(planned.feature.depth_mm());
    }
    return depths_mm;
}

void expectNothingStays(const Plan& plan) {
    EXPECT_LT(plan.balance.residual_mm3, 0.01);
    EXPECT_TRUE(plan.complete(kTol));
}

TEST(CrossingHoles, AreEachDrilledInOneGo) {
    const TopoDS_Shape upright = cut(box(0, 0, 0, 40, 30, 30), cylinder(20, 15, -1, 4, 32));
    const Plan plan = planned(cut(upright, alongY(20, 12, -1, 3, 32)));
    ASSERT_EQ(plan.setups.size(), 2U);
    EXPECT_EQ(drilledDepths(plan.setups[0]), (std::vector<double>{30}));
    EXPECT_EQ(drilledDepths(plan.setups[1]), (std::vector<double>{30}));
    expectNothingStays(plan);
}

TEST(CrossingHoles, AHoleThatEndsInAWiderOneIsDrilledThroughItsWall) {
    const TopoDS_Shape upright = cut(box(0, 0, 0, 60, 60, 40), cylinder(30, 30, -1, 6, 42));
    const Plan plan = planned(cut(upright, alongY(30, 20, -1, 4, 31)));
    ASSERT_EQ(plan.setups.size(), 2U);
    const std::vector<double> depths_mm = drilledDepths(plan.setups[1]);
    ASSERT_EQ(depths_mm.size(), 1U);
    // To where the bore's wall is open over the hole's whole width.
    EXPECT_NEAR(depths_mm.front(), 30 - std::sqrt(36 - 16), 1e-3);
    expectNothingStays(plan);
}

TEST(CrossingHoles, AWiderTopDoesNotHideThatAHoleGoesOn) {
    const TopoDS_Shape upright = cut(box(0, 0, 0, 60, 60, 40), cylinder(30, 30, -1, 6, 42));
    const TopoDS_Shape counterbored = cut(cut(upright, alongY(30, 20, -1, 4, 31)), alongY(30, 20, -1, 7, 9));
    const Plan plan = planned(counterbored);
    ASSERT_EQ(plan.setups.size(), 2U);
    const std::vector<PlannedFeature>& across = plan.setups[1].features;
    ASSERT_EQ(across.size(), 2U);
    EXPECT_EQ(across[1].feature.feature_class, FeatureClass::HoleThrough);
    EXPECT_NEAR(across[1].feature.floor_z_mm, -30 + std::sqrt(36 - 16), 1e-3);
    ASSERT_TRUE(across[1].feature.room_below_mm);
    EXPECT_GT(*across[1].feature.room_below_mm, 4.5);
    expectNothingStays(plan);
}

TEST(CrossingHoles, WallsFarApartAreDrilledOneByOneNearOnesInOneGo) {
    const TopoDS_Shape channel = cut(box(0, 0, 0, 100, 50, 30), box(-1, 15, 10, 102, 20, 30));
    const Plan plan = planned(cut(cut(channel, alongY(20, 20, -1, 5, 60)), alongY(50, 20, -1, 4, 60)));
    ASSERT_EQ(plan.setups.size(), 2U);
    EXPECT_EQ(drilledDepths(plan.setups[1]), (std::vector<double>{50, 15, 15}));
    expectNothingStays(plan);
}

TEST(CrossingHoles, WhatNoHolderGetsToIsDrilledFromTheOtherSide) {
    const TopoDS_Shape tray = cut(box(0, 0, 0, 80, 60, 30), box(-1, 10, 12, 82, 40, 20));
    const Plan plan = planned(cut(tray, alongY(30, 20, -1, 3, 62)));
    ASSERT_EQ(plan.setups.size(), 3U);
    EXPECT_EQ(plan.setups[1].setup.axis, -plan.setups[2].setup.axis);
    EXPECT_EQ(drilledDepths(plan.setups[2]), (std::vector<double>{10}));
    EXPECT_EQ(plan.assignment.choices.size(), 2U);
    expectNothingStays(plan);
}

/// A tube with walls of 7 mm.
TopoDS_Shape tube(double radius_mm) {
    return cut(cylinder(0, 0, 0, radius_mm, 60), cylinder(0, 0, -1, radius_mm - 7, 62));
}

TEST(CrossingHoles, AFarWallsHoleStaysInTheBooksWhereNoHolderGetsToIt) {
    // From the near wall's outside it is 63 mm to the far one, the drill's holder stands 52 mm over its tip.
    const TopoDS_Shape drilled = cut(tube(35), alongY(0, 50, -40, 3, 80));
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.setup.axes = {-Vec3::UnitZ(), -Vec3::UnitY()};
    const Plan plan = planPart(test::part(drilled), request, defaultToolLibrary(), defaultMachine(), kTol);
    // The bore's air, seen from the side, must not be taken for that of the hole.
    EXPECT_NEAR(plan.balance.residual_mm3, kPi * 9 * 7, 5);
    EXPECT_FALSE(plan.complete(kTol));
}

TEST(CrossingHoles, AFarWallsHoleIsDrilledAsFarAsTheHolderLetsTheDrill) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.setup.axes = {-Vec3::UnitZ(), -Vec3::UnitY()};
    const Plan plan = planPart(test::part(cut(tube(25), alongY(0, 50, -30, 3, 60))), request,
                               defaultToolLibrary(), defaultMachine(), kTol);
    // Half a millimetre, and what the drill's point leaves.
    EXPECT_NEAR(plan.balance.residual_mm3, kPi * 9 * (0.5 + 2.0 / 3 * 3 / std::tan(degToRad(59))), 3);
}

TEST(CrossingHoles, AFarWallsWindowIsCutThroughTheNearOne) {
    const Plan plan = planned(cut(tube(25), box(-30, -6, 20, 60, 12, 25)));
    for (const PlannedSetup& setup : plan.setups)
        // What corners of the near one leave of the far one's are crumbs.
        for (const PlannedFeature& window : setup.features)
            EXPECT_TRUE(window.feature.area_mm2 < 1 || !window.sequence.steps.empty()) << window.feature.id;
    EXPECT_LT(plan.balance.residual_mm3, 1e-3 * plan.balance.stock_minus_part_mm3);
}

TEST(CrossingHoles, ATiltedOneLeavesTheBooksClosed) {
    const gp_Ax2 tilted(gp_Pnt(50, 20, 40), gp_Dir(-0.5, 0, -std::sqrt(0.75)));
    const TopoDS_Shape upright = cut(box(0, 0, 0, 60, 40, 30), cylinder(10, 20, -1, 3, 40));
    const Plan plan = planned(cut(upright, BRepPrimAPI_MakeCylinder(tilted, 3, 60).Shape()));
    ASSERT_EQ(plan.setups.size(), 2U);
    EXPECT_LT(plan.balance.gapShare(), 0.1 * kTol.volume_share);
    for (const PlannedSetup& setup : plan.setups)
        EXPECT_TRUE(closes(setup.balance, plan.balance.stock_minus_part_mm3, kTol)) << setup.setup.id;
}

}  // namespace
}  // namespace stepmill
