#include <gtest/gtest.h>

#include "stepmill/feature/hole_group.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/tapping.h"
#include "support/sample_feature.h"
#include "support/tap_makers.h"

namespace stepmill::test {
namespace {

/// A hole of 6.8 mm, so deep, flat or through.
Feature coreHole(double depth_mm, bool through = false) {
    Feature hole = makePocket(makeCircle(Vec2(20, 20), 3.4), depth_mm,
                              through ? FeatureClass::HoleThrough : FeatureClass::HoleBlind);
    hole.through = through;
    return hole;
}

TapStep tapped(const Feature& hole, const ToolAssembly& tap, double thread_depth_mm = 0) {
    const TapTask task{hole, hole.floor_z_mm, 0, thread_depth_mm, holeCentres(hole), 5};
    return tapStep(task, tap, tap.cutting.front(), makeMachine());
}

TEST(Tapping, LeavesAPitchBelowTheTipAndTheLeadBelowTheThread) {
    const TapStep made = tapped(coreHole(18), makeTap("M8"));
    ASSERT_TRUE(made.step) << made.trouble;
    EXPECT_DOUBLE_EQ(made.step->thread->tip_z_mm, -18 + 1.25);
    EXPECT_DOUBLE_EQ(made.step->thread->full_to_z_mm, -18 + 1.25 + 5);
}

TEST(Tapping, GoesNoDeeperThanAsked) {
    const TapStep made = tapped(coreHole(18), makeTap("M8"), 8);
    ASSERT_TRUE(made.step) << made.trouble;
    EXPECT_DOUBLE_EQ(made.step->thread->full_to_z_mm, -8);
    EXPECT_DOUBLE_EQ(made.step->thread->tip_z_mm, -13);
    const TapStep deep = tapped(coreHole(18), makeTap("M8"), 12);
    EXPECT_FALSE(deep.step);
    EXPECT_NE(deep.trouble.find("lets TAP M8 make 11.75 mm"), std::string::npos) << deep.trouble;
}

TEST(Tapping, TheDepthCountsFromTheTopOfThePartWhateverTheBlank) {
    Feature hole = coreHole(18);
    hole.top_z_mm = 0.5;
    const TapStep made = tapped(hole, makeTap("M8"), 8);
    ASSERT_TRUE(made.step) << made.trouble;
    EXPECT_DOUBLE_EQ(made.step->thread->full_to_z_mm, -8);
}

TEST(Tapping, ThroughAHoleTheLastTurnIsWhole) {
    const TapStep made = tapped(coreHole(10, true), makeTap("M8"));
    ASSERT_TRUE(made.step) << made.trouble;
    EXPECT_DOUBLE_EQ(made.step->thread->full_to_z_mm, -10);
    EXPECT_DOUBLE_EQ(made.step->thread->tip_z_mm, -10 - 5 - 1.25);
}

TEST(Tapping, AFixtureBelowMakesAThroughHoleABlindOne) {
    const Tolerances tol;
    const ToolAssembly tap = makeTap("M8");
    // Below a drill's way out, above a tap's.
    const std::vector<Fixture> parallel{{"parallel", makeRectangle(Vec2(10, 23.8), Vec2(30, 40)), -30, -15}};
    const Feature hole = asTapFinds(coreHole(10, true), tap, parallel, tol);
    EXPECT_FALSE(hole.through);
    EXPECT_TRUE(asTapFinds(coreHole(10, true), tap, {}, tol).through);
    const TapStep made = tapped(hole, tap);
    ASSERT_TRUE(made.step) << made.trouble;
    EXPECT_DOUBLE_EQ(made.step->thread->tip_z_mm, -10 + 1.25);
    EXPECT_DOUBLE_EQ(made.step->thread->full_to_z_mm, -10 + 1.25 + 5);
}

TEST(Tapping, ThePartBelowMakesAThroughHoleABlindOne) {
    const ToolAssembly tap = makeTap("M8");
    Feature into_another = coreHole(10, true);
    const double out_mm = into_another.floor_z_mm - deepestTapTipZ(into_another, tap, 0);
    into_another.room_below_mm = out_mm + 0.01;
    EXPECT_TRUE(asTapFinds(into_another, tap, {}, Tolerances{}).through);
    into_another.room_below_mm = out_mm - 0.01;
    EXPECT_FALSE(asTapFinds(into_another, tap, {}, Tolerances{}).through);
}

TEST(Tapping, TheFeedIsPitchTimesSpeedToTheLastDecimal) {
    for (const char* name : {"M8", "M5", "1/4-20 UNC", "#10-24"}) {
        const ToolAssembly tap = makeTap(name);
        Feature hole = coreHole(18);
        hole.target = makeCircle(Vec2(20, 20), (coreRange(*tap.thread).least_mm + 0.05) / 2);
        const TapStep made = tapped(hole, tap);
        ASSERT_TRUE(made.step) << name << ": " << made.trouble;
        EXPECT_EQ(made.step->path.feed_mm_per_min, tap.thread->pitch_mm * made.step->speed_rpm) << name;
        EXPECT_EQ(made.step->path.plunge_feed_mm_per_min, made.step->path.feed_mm_per_min) << name;
        EXPECT_EQ(made.step->speed_rpm, std::floor(made.step->speed_rpm)) << name;
    }
}

TEST(Tapping, TheSpindleTurnsNoFasterThanTheMachineAndItsAxes) {
    const ToolAssembly tap = makeTap("M8");
    CuttingData cutting = tap.cutting.front();
    cutting.speed_rpm = 1e5;
    Machine machine = makeMachine();
    EXPECT_EQ(tapSpeedRpm(tap, cutting, machine), 8000 / 1.25);
    machine.max_speed_rpm = 1234.5;
    EXPECT_EQ(tapSpeedRpm(tap, cutting, machine), 1234);
}

TEST(Tapping, GoesDownAndUpWithoutARapidInTheHole) {
    Feature hole = coreHole(18);
    hole.target.loops.push_back(makeCircle(Vec2(40, 20), 3.4).loops.front());
    const TapStep made = tapped(hole, makeTap("M8"));
    ASSERT_TRUE(made.step) << made.trouble;
    EXPECT_EQ(made.step->holes, 2);
    Vec3 from = made.step->path.start;
    int downs = 0;
    for (const Move& move : made.step->path.moves) {
        if (move.kind == MoveKind::Rapid) {
            EXPECT_GE(std::min(from.z(), move.to.z()), 0);
        } else {
            EXPECT_EQ(Vec2(from.head<2>()), Vec2(move.to.head<2>()));
            downs += move.to.z() < from.z();
        }
        from = move.to;
    }
    EXPECT_EQ(downs, 2);
    EXPECT_EQ(from.z(), 5);
}

TEST(Tapping, OtherDiametersAreNoCore) {
    Feature hole = coreHole(18);
    hole.target = makeCircle(Vec2(20, 20), 4);
    const TapStep made = tapped(hole, makeTap("M8"));
    EXPECT_FALSE(made.step);
    EXPECT_NE(made.trouble.find("the hole is 8 mm wide"), std::string::npos) << made.trouble;
}

TEST(Tapping, AHoleShallowerThanTheLeadIsNotTapped) {
    EXPECT_FALSE(tapped(coreHole(6), makeTap("M8")).step);
}

TEST(Tapping, AThickShankStaysOutOfTheHole) {
    ToolAssembly tap = makeTap("M8");
    tap.shank.diameter_mm = 8;
    const TapStep made = tapped(coreHole(30), tap);
    EXPECT_FALSE(made.step);
    EXPECT_NE(made.trouble.find("reaches 20 mm"), std::string::npos) << made.trouble;
    EXPECT_TRUE(tapped(coreHole(30), tap, 12).step);
}

TEST(Tapping, TheHolderKeepsOffAWallBesideTheHole) {
    Feature hole = coreHole(18);
    hole.obstacles.push_back({0, 50, makeRectangle(Vec2(30, 0), Vec2(40, 40))});
    ToolAssembly tap = makeTap("M8");
    EXPECT_TRUE(tapped(hole, tap).step);
    tap.holder = {{30, 40, 80}};
    tap.stick_out_mm = 40;
    const TapStep made = tapped(hole, tap);
    EXPECT_FALSE(made.step);
    EXPECT_NE(made.trouble.find("30 mm wide"), std::string::npos) << made.trouble;
}

TEST(Tapping, NoWallIsNearerThanTheTapIsWideThoughItsFlutesEndInTheHole) {
    Feature hole = coreHole(40);
    hole.obstacles.push_back({0, 50, makeRectangle(Vec2(23.8, 0), Vec2(40, 40))});
    ToolAssembly tap = makeTap("M8");
    tap.shank.diameter_mm = 6;
    const TapStep made = tapped(hole, tap);
    EXPECT_FALSE(made.step) << "on its way down it would cut into the wall";
    EXPECT_NE(made.trouble.find("8 mm wide"), std::string::npos) << made.trouble;
    hole.obstacles.back().section = makeRectangle(Vec2(24.2, 0), Vec2(40, 40));
    EXPECT_TRUE(tapped(hole, tap).step);
}

TEST(Tapping, AHoleIsBoredAsDeepAsItsLastToolMakesItWhole) {
    const Feature hole = coreHole(18);
    ToolLibrary library = makeLibrary({makeDrill(6.8), makeMill(6)});
    ToolSequence made;
    made.floor_z_mm = -18;
    EXPECT_FALSE(boredToZ(hole, made, library)) << "nothing makes it";
    SequenceStep drill;
    drill.tool_id = library.tools[0].id;
    drill.role = Role::Drill;
    made.steps = {drill};
    EXPECT_DOUBLE_EQ(*boredToZ(hole, made, library), -18 + pointLengthMm(library.tools[0]));
    SequenceStep mill;
    mill.tool_id = library.tools[1].id;
    made.steps.push_back(mill);
    EXPECT_DOUBLE_EQ(*boredToZ(hole, made, library), -18);
    Residual left;
    left.volume_mm3 = 5;
    left.reason = {Reason::TooDeep, {}};
    made.residual.push_back(left);
    EXPECT_FALSE(boredToZ(hole, made, library)) << "what stays narrows it";
}

}  // namespace
}  // namespace stepmill::test
