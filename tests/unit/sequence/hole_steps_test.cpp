// Ways through a hole's tool DAG: spotted, drilled, drilled for a mill, brought to a fit.

#include <gtest/gtest.h>

#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/sizing.h"
#include "stepmill/sequence/spotting.h"
#include "support/hole_tool_makers.h"
#include "support/sample_feature.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

ToolSequence sequenceOf(const Feature& hole, std::vector<ToolAssembly> tools) {
    return sequenceTools(hole, makeLibrary(std::move(tools)), makeMachine(), inAluminium(), kTol);
}

using Ids = std::vector<std::string>;

/// A drill that is quick beside mills.
ToolAssembly quickDrill(double diameter_mm) {
    ToolAssembly drill = makeDrill(diameter_mm);
    drill.cutting.front().feed_mm_per_min = drill.cutting.front().plunge_feed_mm_per_min = 1000;
    return drill;
}

TEST(HoleSteps, ABoreWiderThanTheDrillIsDrilledForTheMill) {
    const ToolSequence sequence = sequenceOf(holeOf(20, 30, true), {quickDrill(12), makeMill(6, 600, 3)});
    ASSERT_EQ(toolsOf(sequence), (Ids{"DR12", "EM6"}));
    EXPECT_EQ(sequence.steps[0].role, Role::Drill);
    EXPECT_TRUE(sequence.residual.empty());
    // Through: the drill goes beyond the floor, and leaves nothing over it.
    EXPECT_EQ(sequence.steps[0].leaves.floors_mm, 0);
    const ToolSequence milled = sequenceOf(holeOf(20, 30, true), {makeMill(6, 600, 3)});
    EXPECT_LT(sequence.time_s, milled.time_s);
}

TEST(HoleSteps, AHoleWithSomethingStandingInItIsMilled) {
    Feature ring = holeOf(20, 30, true);
    ring.target = subtract(ring.target, makeCircle(Vec2(20, 20), 3), kTol);
    ring.obstruction = makeCircle(Vec2(20, 20), 3);
    ring.area_mm2 = area(ring.target);
    EXPECT_EQ(toolsOf(sequenceOf(ring, {makeSpot(6), quickDrill(12), makeMill(6, 600, 3)})), Ids{"EM6"});
}

TEST(HoleSteps, OverAFlatFloorTheNarrowerDrillStaysToo) {
    const Feature hole = holeOf(20, 30, false);
    const ToolSequence sequence = sequenceOf(hole, {quickDrill(12), makeMill(6, 600, 3)});
    ASSERT_EQ(toolsOf(sequence).front(), "DR12");
    double lowest_mm = 0;
    for (const Move& move : sequence.steps[0].path.moves)
        lowest_mm = std::min(lowest_mm, move.to.z());
    EXPECT_NEAR(lowest_mm, -30 + 0.1, 1e-9);
}

TEST(HoleSteps, TheMillAloneIsTakenWhereThatIsQuicker) {
    EXPECT_EQ(toolsOf(sequenceOf(holeOf(20, 3, true), {quickDrill(12), makeMill(10, 3000, 3)})), Ids{"EM10"});
}

TEST(HoleSteps, WallsThatAreFinishedAreNotDrilledFirst) {
    SequenceOptions options = inAluminium();
    options.finish.walls_mm = 0.2;
    const ToolSequence sequence =
        sequenceTools(holeOf(20, 30, true), makeLibrary({quickDrill(12), makeMill(10, 600, 3)}),
                      makeMachine(), options, kTol);
    EXPECT_EQ(sequence.no_allowance, "");
    EXPECT_EQ(sequence.steps.back().role, Role::Finish);
}

TEST(HoleSteps, ADrillIsSpottedFirstUnlessItCentresItself) {
    const ToolSequence spotted =
        sequenceOf(holeOf(8, 20, true), {makeSpot(6), makeDrill(8), makeMill(6, 100, 1)});
    EXPECT_EQ(toolsOf(spotted), (Ids{"SP6", "DR8"}));
    EXPECT_EQ(spotted.steps[0].role, Role::Spot);
    EXPECT_EQ(spotted.steps[0].holes, 1);
    EXPECT_EQ(toolsOf(sequenceOf(holeOf(8, 20, true), {makeSpot(6), selfCentringDrill(8)})), Ids{"DR8"});
    EXPECT_EQ(toolsOf(sequenceOf(holeOf(8, 20, true), {makeDrill(8)})), Ids{"DR8"})
        << "there is no spot drill";
}

TEST(HoleSteps, ASpotGuidesTheDrillAndLeavesTheEdge) {
    const Feature hole = holeOf(8, 20, true);
    const ToolAssembly spot = makeSpot(6);
    const double tip_z_mm = spotTipZ(hole, spot);
    EXPECT_NEAR(tip_z_mm, -kSpotShare * 3, 1e-12);
    EXPECT_NEAR(spotRadiusMm(hole, spot, tip_z_mm), kSpotShare * 3, 1e-12);
    EXPECT_NEAR(spotRadiusMm(hole, makeSpot(20), spotTipZ(hole, makeSpot(20))), kSpotShare * 4, 1e-12);
    EXPECT_FALSE(spotFits(holeOf(8, 1, false), makeSpot(8))) << "its tip would go below the floor";
}

TEST(HoleSteps, ASpotDrillKeepsOffWhatStandsBesideTheHole) {
    Feature hole = holeOf(4, 10, true);
    hole.obstacles.push_back(
        {0, 30, subtract(makeRectangle({0, 0}, {40, 40}), makeCircle({20, 20}, 5), kTol)});
    EXPECT_TRUE(spotFits(hole, makeSpot(8)));
    EXPECT_FALSE(spotFits(hole, makeSpot(12)));
}

SizingTask reaming(bool through) {
    return {holeOf(8, 20, through), *fitFrom("H7"), -20, 5};
}

TEST(HoleSteps, AReamerGoesOutOfAThroughHoleAndStaysOverABlindOnesEnd) {
    const ToolAssembly reamer = makeReamer(8.008);
    const SizingTask through = reaming(true);
    EXPECT_EQ(sizingTrouble(through, reamer), "");
    EXPECT_EQ(sizedToZ(through.hole, reamer, -20), -20);
    EXPECT_NEAR(sizerTipZ(through.hole, reamer, -20), -21.5, 1e-12);
    const SizingTask blind = reaming(false);
    EXPECT_EQ(sizingTrouble(blind, reamer), "");
    EXPECT_NEAR(sizedToZ(blind.hole, reamer, -20), -19, 1e-12);
    EXPECT_NEAR(sizerTipZ(blind.hole, reamer, -19), -20, 1e-12);
    EXPECT_NEAR(leftByLeadMm3(blind, reamer, 7.8), kPi / 4 * (64 - 7.8 * 7.8), 1e-9);
    EXPECT_EQ(leftByLeadMm3(through, reamer, 7.8), 0);
}

TEST(HoleSteps, AReamerMustHaveTheFitsDiameter) {
    EXPECT_EQ(sizingTrouble(reaming(true), makeReamer(8.02)),
              "RM is 8.0200 mm wide, H7 of 8 mm is 8.0000 to 8.0150 mm");
    ToolAssembly stubby = makeReamer(8.008);
    stubby.shank = {10, 15, 60};
    stubby.flute_length_mm = 15;
    EXPECT_EQ(sizingTrouble(reaming(true), stubby), "RM reaches 15 mm, its tip must go 21.5 mm deep");
}

TEST(HoleSteps, ReamersAndBoringHeadsTakeALittle) {
    const DiameterRange reamed = boreBefore(makeReamer(8), 8);
    EXPECT_NEAR(reamed.most_mm, 7.95, 1e-12);
    EXPECT_NEAR(reamed.least_mm, 7.73, 1e-12);
    ToolAssembly head = makeReamer(20);
    head.type = ToolType::Boring;
    EXPECT_NEAR(boreBefore(head, 20).least_mm, 19, 1e-12);
}

TEST(HoleSteps, DrillsForAReamerAreThoseThatLeaveItSomething) {
    Feature hole = holeOf(8, 20, true);
    EXPECT_FALSE(drillCheck(hole, makeTool("DR7_8", ToolType::Drill, 7.8, 300, 0), kTol).fits);
    hole.drilled = boreBefore(makeReamer(8), 8);
    EXPECT_TRUE(drillCheck(hole, makeTool("DR7_8", ToolType::Drill, 7.8, 300, 0), kTol).fits);
    EXPECT_FALSE(drillCheck(hole, makeDrill(8), kTol).fits);
}

}  // namespace
}  // namespace stepmill::test
