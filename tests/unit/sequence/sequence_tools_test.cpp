#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <fmt/format.h>
#include "stepmill/feature/hole_group.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/edge_index.h"
#include "stepmill/sequence/drilling.h"

#include "support/sample_feature.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

using test::kTol;

const DagEdge* findEdge(const ToolSequence& sequence, const std::string& from, const std::string& to) {
    for (const DagEdge& edge : sequence.edges) {
        if (edge.from.name() == from && edge.to.name() == to) return &edge;
    }
    return nullptr;
}

SequenceOptions withSurrogates(SurrogateRule rule) {
    SequenceOptions options = inAluminium();
    options.surrogates = rule;
    return options;
}

TEST(SequenceTools, TakesTheOneToolThereIs) {
    const ToolSequence sequence =
        sequenceTools(makeIslandPocket(), makeLibrary({makeMill(10)}), makeMachine(), inAluminium(), kTol);
    EXPECT_EQ(toolsOf(sequence), std::vector<std::string>{"EM10"});
    EXPECT_TRUE(sequence.residual.empty());
    EXPECT_GT(sequence.time_s, 0);
    ASSERT_NE(findEdge(sequence, "", "EM10"), nullptr);
    EXPECT_DOUBLE_EQ(findEdge(sequence, "", "EM10")->time_s, sequence.time_s);
}

TEST(SequenceTools, RoughsWithALargeCutterWhenThatPays) {
    const Feature deep = makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(120, 90), 3), 20);
    const ToolLibrary library = makeLibrary({makeMill(6, 800, 2), makeMill(20, 2000, 5)});
    const ToolSequence sequence = sequenceTools(deep, library, makeMachine(), inAluminium(), kTol);
    EXPECT_EQ(toolsOf(sequence), (std::vector<std::string>{"EM20", "EM6"}));
    EXPECT_EQ(sequence.steps[0].role, Role::Rough);
    EXPECT_EQ(sequence.steps[1].role, Role::Rest);
    EXPECT_LT(sequence.time_s, findEdge(sequence, "", "EM6")->time_s);
    EXPECT_TRUE(sequence.residual.empty());
}

TEST(SequenceTools, ADearToolChangeKeepsItAtOneTool) {
    const Feature pocket = makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(60, 40), 3), 4);
    Machine machine = makeMachine();
    machine.tool_change_s = 100000;
    const ToolSequence sequence =
        sequenceTools(pocket, makeLibrary({makeMill(6), makeMill(16)}), machine, inAluminium(), kTol);
    EXPECT_EQ(toolsOf(sequence), std::vector<std::string>{"EM6"});
}

TEST(SequenceTools, LeavesTheCornersTheSmallestCutterCannotReach) {
    const double depth = 5;
    const Feature pocket = makePocket(makeRectangle(Vec2(0, 0), Vec2(60, 40)), depth);
    const ToolSequence sequence =
        sequenceTools(pocket, makeLibrary({makeMill(10), makeMill(6)}), makeMachine(), inAluminium(), kTol);
    ASSERT_EQ(sequence.residual.size(), 1U);
    EXPECT_EQ(sequence.residual[0].reason, Reason::CornerRadius);
    // Four cusps: the square over the radius less a quarter disc each.
    const double cusps_mm2 = 4 * 9 * (1 - kPi / 4);
    EXPECT_NEAR(sequence.residual[0].area_mm2, cusps_mm2, 0.01 * cusps_mm2);
    EXPECT_NEAR(residualVolumeMm3(sequence), cusps_mm2 * depth, 0.01 * cusps_mm2 * depth);
}

TEST(SequenceTools, NamesTheEndOfANeckThatNoPassReaches) {
    // Beside the island's corner the way narrows to the cutter's own width at x = 20. On paper its centre
    // gets there; passes end where the strip of centres is a sliver wide.
    const Region island = makeRoundedRectangle({16, 10}, {50, 28}, 4);
    const Feature pocket = makePocket(subtract(makeRectangle({0, 0}, {66, 30}), island, kTol), 2);
    Tolerances no_fit = kTol;
    no_fit.fit_mm = 0;  // else the neck is a slot, and the cutter goes along its middle
    const ToolSequence sequence =
        sequenceTools(pocket, makeLibrary({makeMill(2)}), makeMachine(), inAluminium(), no_fit);
    const auto names = [&](const Vec2& at) {
        return std::any_of(sequence.residual.begin(), sequence.residual.end(),
                           [&](const Residual& residual) { return contains(residual.region, at); });
    };
    EXPECT_TRUE(names({20.98, 29}));
    EXPECT_FALSE(names({20.8, 29}));
}

TEST(SequenceTools, NamesTheCutterThatWouldFitWhenNoneDoes) {
    const Feature slot = makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(40, 5), 2.5), 5);
    const ToolSequence sequence =
        sequenceTools(slot, makeLibrary({makeMill(10), makeMill(6)}), makeMachine(), inAluminium(), kTol);
    EXPECT_TRUE(sequence.steps.empty());
    EXPECT_EQ(sequence.lower_bound_s, 0);
    ASSERT_EQ(sequence.residual.size(), 1U);
    EXPECT_EQ(sequence.residual[0].reason, Reason::NoNarrowCutter);
    EXPECT_NE(sequence.residual[0].advice.find("5 mm"), std::string::npos) << sequence.residual[0].advice;
    EXPECT_DOUBLE_EQ(residualVolumeMm3(sequence), slot.volume_mm3);
}

TEST(SequenceTools, EndsAtTheDepthTheToolReachesWhereTheFloorIsTooDeep) {
    const Feature deep = makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(40, 40), 6), 80);
    ToolAssembly mill = makeMill(10);
    mill.holder.push_back({40, 60, 100});
    const ToolSequence sequence =
        sequenceTools(deep, makeLibrary({mill}), makeMachine(), inAluminium(), kTol);
    ASSERT_EQ(toolsOf(sequence), std::vector<std::string>{"EM10"});
    EXPECT_NEAR(sequence.floor_z_mm, -60, 1e-3);
    double deepest = 0;
    for (const Move& move : sequence.steps[0].path.moves)
        deepest = std::min(deepest, move.to.z());
    EXPECT_DOUBLE_EQ(deepest, sequence.floor_z_mm);
    ASSERT_EQ(sequence.residual.size(), 1U);
    EXPECT_EQ(sequence.residual[0].reason, Reason::TooDeep);
    EXPECT_NEAR(residualVolumeMm3(sequence), 20 * deep.area_mm2, 1e-2 * deep.area_mm2);
    EXPECT_NE(sequence.residual[0].advice.find("stick-out of 80 mm"), std::string::npos)
        << sequence.residual[0].advice;
}

TEST(SequenceTools, AToolItsHolderKeepsOffAWallMachinesTheRest) {
    // 30 mm deep; the holder, 30 mm wide and 25 mm over the tip, keeps 10 mm of the walls from the cutter.
    const Feature room = makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(200, 200), 5), 30);
    ToolAssembly mill = makeMill(10);
    mill.stick_out_mm = 25;
    mill.holder.push_back({30, 25, 80});
    const ToolSequence sequence =
        sequenceTools(room, makeLibrary({mill}), makeMachine(), inAluminium(), kTol);
    // Going down 25 of 30 mm everywhere machines less than 180 x 180 of 200 x 200 mm2 to the floor would:
    // 0.833 against 0.81, so the depth ends first here.
    ASSERT_EQ(sequence.steps.size(), 1U);
    EXPECT_NEAR(sequence.floor_z_mm, -25, 1e-3);

    mill.holder[0].diameter_mm = 20;
    const ToolSequence slimmer = sequenceTools(room, makeLibrary({mill}), makeMachine(), inAluminium(), kTol);
    ASSERT_EQ(slimmer.steps.size(), 1U);
    EXPECT_DOUBLE_EQ(slimmer.floor_z_mm, -30);
    EXPECT_TRUE(slimmer.tools[0].limited());
    ASSERT_EQ(slimmer.residual.size(), 1U);
    EXPECT_EQ(slimmer.residual[0].reason, Reason::HolderCollision);
    EXPECT_NE(slimmer.residual[0].advice.find("stick-out of 30 mm"), std::string::npos);
    // A frame 5 mm wide, its inner corners as round as the cutter, its outer ones as round as the pocket's.
    const double frame_mm2 = room.area_mm2 - (190.0 * 190.0 - (4 - kPi) * 25);
    EXPECT_NEAR(slimmer.residual[0].area_mm2, frame_mm2, 0.1);
    // The axis never comes nearer to the walls than the holder may.
    for (const Move& move : slimmer.steps[0].path.moves) {
        if (move.to.z() >= -5) continue;
        EXPECT_LE((move.to.head<2>() - Vec2(100, 100)).cwiseAbs().maxCoeff(), 90.0 + 1e-6);
    }
}

TEST(SequenceTools, AToolFreeEverywhereDoesWhatAnotherIsKeptOff) {
    const Feature room = makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(200, 200), 5), 30);
    ToolAssembly stubby = makeMill(8);
    stubby.stick_out_mm = 25;
    stubby.holder.push_back({20, 25, 80});
    const ToolSequence sequence =
        sequenceTools(room, makeLibrary({makeMill(10), stubby}), makeMachine(), inAluminium(), kTol);
    EXPECT_EQ(toolsOf(sequence), std::vector<std::string>{"EM10"});
    EXPECT_TRUE(sequence.residual.empty());
    ASSERT_TRUE(sequence.tools[1].surrogates());
    const WithSurrogates& held_off = *sequence.tools[1].surrogates();
    ASSERT_EQ(held_off.lumps.size(), 1U) << "a frame along the walls";
    EXPECT_EQ(held_off.lumps[0].surrogates, std::vector<std::string>{"EM10"});
    EXPECT_NE(held_off.lumps[0].reason.find("20 mm wide"), std::string::npos);
}

/// 100 x 60 mm, 8 mm deep; a boss 30 mm high, up to the stock's top, stands 2 mm behind the middle of one
/// long wall.
Feature makePocketBesideABoss(double corner_radius_mm = 5) {
    Feature pocket = makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(100, 60), corner_radius_mm), 8);
    pocket.top_z_mm = -30;
    pocket.floor_z_mm = -38;
    pocket.obstacles = {{-38, -30, pocket.obstruction}, {-30, 0, makeRectangle(Vec2(40, -15), Vec2(60, -2))}};
    pocket.min_corner_radius_mm = corner_radius_mm;
    return pocket;
}

/// Cuts fast, but its holder does not pass the boss.
ToolAssembly makeStubbyMill(double diameter_mm, double feed) {
    ToolAssembly mill = inHolder(makeMill(diameter_mm, feed), 20, 40, 60);
    mill.id = "stubby " + mill.id;
    return mill;
}

TEST(SequenceTools, ItsChoicesNeedNothingItWasMadeFrom) {
    auto library = std::make_unique<ToolLibrary>(makeLibrary({makeStubbyMill(10, 4000), makeMill(6, 600)}));
    auto machine = std::make_unique<Machine>(makeMachine());
    const ToolSequence sequence =
        sequenceTools(makePocketBesideABoss(), *library, *machine, inAluminium(), kTol);
    library.reset();
    machine.reset();
    const ToolSequence again = withChoice(sequence, 0);
    EXPECT_EQ(toolsOf(again), (std::vector<std::string>{"stubby EM10", "EM6"}));
    EXPECT_EQ(again.time_s, sequence.time_s);
}

TEST(SequenceTools, ASurrogateClearsWhatTheHolderKeepsOff) {
    const ToolSequence sequence =
        sequenceTools(makePocketBesideABoss(), makeLibrary({makeStubbyMill(10, 4000), makeMill(6, 600)}),
                      makeMachine(), inAluminium(), kTol);
    ASSERT_EQ(toolsOf(sequence), (std::vector<std::string>{"stubby EM10", "EM6"}));
    EXPECT_EQ(sequence.steps[0].role, Role::Rough);
    EXPECT_EQ(sequence.steps[1].role, Role::Surrogate);
    EXPECT_TRUE(sequence.residual.empty());
    ASSERT_TRUE(sequence.tools[0].surrogates());
    const std::vector<BlockedLump>& lumps = sequence.tools[0].surrogates()->lumps;
    ASSERT_EQ(lumps.size(), 1U);
    EXPECT_EQ(lumps[0].surrogates, std::vector<std::string>{"EM6"});
    const DagEdge* edge = findEdge(sequence, "", "stubby EM10");
    ASSERT_NE(edge, nullptr);
    ASSERT_EQ(edge->surrogates.size(), 1U);
    EXPECT_EQ(edge->surrogates[0].tool, "EM6");
    EXPECT_NEAR(edge->surrogates[0].area_mm2, lumps[0].area_mm2, 1e-9);
    EXPECT_LE(sequence.time_s, edge->time_s) << "of the quickest patterns";
    const double changes_s = 2 * makeMachine().tool_change_s;
    EXPECT_NEAR(edge->time_s, edge->totals.time_s() + edge->surrogates[0].totals.time_s() + changes_s, 1e-9);
}

/// How many rapids below that height bring a cutter into the region.
int rapidsInto(const Region& standing, double top_z_mm, const Toolpath& path, double radius_mm) {
    const EdgeIndex edges(standing);
    int count = 0;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const bool down = move.to.z() <= from.z() && move.to.z() < top_z_mm;
        const Edge way = edgeOf(from, move);
        if (move.kind == MoveKind::Rapid && down && edges.anyNearer(way, radius_mm - kTol.guard_mm)) ++count;
        from = move.to;
    }
    return count;
}

TEST(SequenceTools, ASurrogatesRapidsKeepOffWhatStandsAroundTheFeature) {
    // Open towards the boss, whose stock may stand out by 1.5 mm.
    Feature pocket = makePocketBesideABoss();
    const Region boss = makeRectangle(Vec2(40, -15), Vec2(60, -2));
    pocket.obstruction = boss;
    pocket.obstacles = {{-38, 0, boss}};
    pocket.skirt = subtract(offset(boss, 1.5, kTol), boss, kTol);
    const ToolSequence sequence =
        sequenceTools(pocket, makeLibrary({makeStubbyMill(10, 4000), makeMill(6, 600)}), makeMachine(),
                      withSurrogates(SurrogateRule::Single), kTol);
    int surrogates = 0;
    for (const SequenceStep& step : sequence.steps) {
        if (step.role != Role::Surrogate) continue;
        ++surrogates;
        EXPECT_EQ(rapidsInto(pocket.skirt, 0, step.path, 3), 0);
    }
    EXPECT_GT(surrogates, 0);
}

TEST(SequenceTools, WhatAHolderKeepsOffMayBeLeftToALaterTool) {
    const ToolLibrary library = makeLibrary({makeStubbyMill(10, 4000), makeMill(6, 600)});
    const auto sequenceBy = [&](SurrogateRule rule) {
        return sequenceTools(makePocketBesideABoss(3), library, makeMachine(), withSurrogates(rule), kTol);
    };
    const ToolSequence at_once = sequenceBy(SurrogateRule::Single);
    for (const SurrogateRule rule : {SurrogateRule::SingleOrLater, SurrogateRule::Sequence}) {
        const ToolSequence later = sequenceBy(rule);
        EXPECT_EQ(toolsOf(later), (std::vector<std::string>{"stubby EM10", "EM6"}));
        EXPECT_EQ(later.way, (std::vector<DagNode>{{"stubby EM10", true}, {"EM6"}}));
        EXPECT_NE(findEdge(later, "stubby EM10 alone", "EM6"), nullptr);
        EXPECT_LT(later.time_s, at_once.time_s);
        EXPECT_TRUE(later.residual.empty());
    }
}

TEST(SequenceTools, ASurrogateThatComesNextAnywayIsChangedToOnce) {
    const ToolSequence sequence =
        sequenceTools(makePocketBesideABoss(3), makeLibrary({makeStubbyMill(10, 4000), makeMill(6, 600)}),
                      makeMachine(), withSurrogates(SurrogateRule::Single), kTol);
    ASSERT_EQ(toolsOf(sequence), (std::vector<std::string>{"stubby EM10", "EM6", "EM6"}));
    EXPECT_EQ(sequence.steps[1].role, Role::Surrogate);
    EXPECT_EQ(sequence.steps[2].role, Role::Rest);
    double paths_s = 0;
    for (const SequenceStep& step : sequence.steps)
        paths_s += step.path.totals.time_s();
    EXPECT_NEAR(sequence.time_s, paths_s + 2 * makeMachine().tool_change_s, 1e-9);
    const DagEdge* first = findEdge(sequence, "", "stubby EM10");
    const DagEdge* second = findEdge(sequence, "stubby EM10", "EM6");
    ASSERT_NE(first, nullptr);
    ASSERT_NE(second, nullptr);
    EXPECT_LE(sequence.time_s, first->time_s + second->time_s) << "of the quickest patterns";
}

TEST(SequenceTools, OneSurrogatePerLumpWhereThatIsAskedFor) {
    SequenceOptions options = inAluminium();
    options.surrogates = SurrogateRule::Single;
    const ToolLibrary library =
        makeLibrary({makeStubbyMill(10, 4000), makeMill(8, 1500), makeMill(6, 600), makeMill(4, 400)});
    const ToolSequence single = sequenceTools(makePocketBesideABoss(), library, makeMachine(), options, kTol);
    for (const DagEdge& edge : single.edges)
        EXPECT_LE(edge.surrogates.size(), 1U) << edge.from.name() << " to " << edge.to.name();
    const ToolSequence several =
        sequenceTools(makePocketBesideABoss(), library, makeMachine(), inAluminium(), kTol);
    EXPECT_LE(several.time_s, single.time_s + 1e-9);
}

TEST(SequenceTools, WhatNobodyReachesStaysAndTheRestIsShared) {
    // The boss keeps both off the ground beside it, the thicker holder more than the slimmer one.
    ToolAssembly slimmer = makeMill(6, 600);
    slimmer.stick_out_mm = 20;
    slimmer.holder.push_back({20, 20, 80});
    const ToolSequence sequence =
        sequenceTools(makePocketBesideABoss(), makeLibrary({makeStubbyMill(10, 4000), slimmer}),
                      makeMachine(), inAluminium(), kTol);
    ASSERT_FALSE(sequence.steps.empty());
    ASSERT_EQ(sequence.residual.size(), 1U);
    EXPECT_EQ(sequence.residual[0].reason, Reason::HolderCollision);
    EXPECT_EQ(toolsOf(sequence).front(), "stubby EM10");
    EXPECT_EQ(toolsOf(sequence).back(), "EM6");
    // The slimmer holder keeps 10 mm off the boss, 8 of them in the pocket, so its cutter 5 mm.
    EXPECT_NEAR(boundingBox(sequence.residual[0].region).max().y(), 5, 1e-3);
    // Beside the wall, 2 mm before the boss, a cutter of 10 mm has its axis 7 mm from it: room for 14 mm.
    EXPECT_EQ(
        sequence.residual[0].advice,
        "an end mill of 10 mm with a stick-out of 38 mm (18 mm more), or a holder no wider than 13.9 mm "
        "below that");
}

TEST(SequenceTools, NoEdgeFollowsAToolThatLeavesNothing) {
    const ToolSequence sequence = sequenceTools(makeIslandPocket(), makeLibrary({makeMill(10), makeMill(8)}),
                                                makeMachine(), inAluminium(), kTol);
    EXPECT_EQ(findEdge(sequence, "EM10", "EM8"), nullptr);
    EXPECT_NE(findEdge(sequence, "EM10", ""), nullptr);
    EXPECT_NE(findEdge(sequence, "EM8", ""), nullptr);
}

Feature makeHole(FeatureClass feature_class) {
    Feature hole = makePocket(makeCircle(Vec2(20, 20), 4), 15, feature_class);
    hole.through = feature_class == FeatureClass::HoleThrough;
    return hole;
}

TEST(SequenceTools, DrillsAThroughHoleOfTheDrillsSizeBeyondItsFloor) {
    const ToolSequence sequence = sequenceTools(makeHole(FeatureClass::HoleThrough),
                                                makeLibrary({makeDrill(8), makeDrill(7), makeMill(6, 300)}),
                                                makeMachine(), inAluminium(), kTol);
    ASSERT_EQ(toolsOf(sequence), std::vector<std::string>{"DR8"});
    EXPECT_EQ(sequence.steps[0].role, Role::Drill);
    EXPECT_TRUE(sequence.residual.empty());
    double deepest = 0;
    for (const Move& move : sequence.steps[0].path.moves)
        deepest = std::min(deepest, move.to.z());
    EXPECT_NEAR(deepest, -15 - 0.5 - 4 / std::tan(degToRad(59)), 1e-9);
    EXPECT_LE(sequence.lower_bound_s, sequence.time_s);
}

TEST(SequenceTools, MillsABlindHoleThatACutterCanFinish) {
    const ToolSequence sequence =
        sequenceTools(makeHole(FeatureClass::HoleBlind), makeLibrary({makeDrill(8), makeMill(6)}),
                      makeMachine(), inAluminium(), kTol);
    EXPECT_EQ(toolsOf(sequence), std::vector<std::string>{"EM6"});
    EXPECT_TRUE(sequence.residual.empty());
}

TEST(SequenceTools, ADrillWithShortFlutesIsToldItsFlutes) {
    const Feature hole = makeHole(FeatureClass::HoleThrough);
    ToolAssembly drill = makeDrill(8);
    drill.flute_length_mm = hole.depth_mm() - 1;
    const ToolSequence sequence =
        sequenceTools(hole, makeLibrary({drill}), makeMachine(), inAluminium(), kTol);
    ASSERT_EQ(toolsOf(sequence), std::vector<std::string>{"DR8"});
    ASSERT_FALSE(sequence.residual.empty());
    EXPECT_EQ(sequence.residual.back().reason, Reason::TooDeep);
    EXPECT_EQ(sequence.residual.back().advice,
              fmt::format("a drill of 8 mm with flutes of {:.4g} mm",
                          hole.depth_mm() + pointLengthMm(drill) + kBreakThroughMm));
}

TEST(SequenceTools, ADrilledBlindHoleKeepsTheRimUnderTheDrillsPoint) {
    const Feature hole = makeHole(FeatureClass::HoleBlind);
    const ToolSequence sequence =
        sequenceTools(hole, makeLibrary({makeDrill(8)}), makeMachine(), inAluminium(), kTol);
    ASSERT_EQ(toolsOf(sequence), std::vector<std::string>{"DR8"});
    ASSERT_EQ(sequence.residual.size(), 1U);
    EXPECT_EQ(sequence.residual[0].reason, Reason::DrillPoint);
    const double point_mm = 4 / std::tan(degToRad(59));
    EXPECT_NEAR(residualVolumeMm3(sequence), hole.area_mm2 * point_mm * 2 / 3, 1e-6);
}

/// A blind hole of 8 mm that ends in a cone of that angle.
Feature makePointedHole(double angle_deg) {
    Feature hole = makeHole(FeatureClass::HoleBlind);
    hole.point_mm = 4 / std::tan(degToRad(angle_deg / 2));
    return hole;
}

double tipOf(const ToolSequence& sequence) {
    double deepest_mm = 0;
    for (const Move& move : sequence.steps.front().path.moves)
        deepest_mm = std::min(deepest_mm, move.to.z());
    return deepest_mm;
}

TEST(SequenceTools, DrillsAPointedHoleIntoItsPoint) {
    const Feature hole = makePointedHole(118);
    const ToolSequence sequence = sequenceTools(hole, makeLibrary({makeDrill(8), makeMill(6, 5000)}),
                                                makeMachine(), inAluminium(), kTol);
    ASSERT_EQ(toolsOf(sequence), std::vector<std::string>{"DR8"});
    EXPECT_TRUE(sequence.residual.empty());
    EXPECT_NEAR(tipOf(sequence), -15 - hole.point_mm, 1e-9);
    ASSERT_EQ(sequence.steps.front().takes.size(), 1U);
    EXPECT_NEAR(sequence.steps.front().takes.front().volume_mm3, hole.area_mm2 * hole.point_mm / 3, 1e-3);
}

TEST(SequenceTools, ABlunterDrillStaysWithItsRimOnTheFloor) {
    ToolAssembly drill = makeDrill(8);
    drill.point_angle_deg = 140;
    const ToolSequence sequence =
        sequenceTools(makePointedHole(118), makeLibrary({drill}), makeMachine(), inAluminium(), kTol);
    EXPECT_TRUE(sequence.residual.empty());
    EXPECT_NEAR(tipOf(sequence), -15 - 4 / std::tan(degToRad(70)), 1e-9);
}

TEST(SequenceTools, ASharperDrillStaysWithItsTipInThePoint) {
    ToolAssembly drill = makeDrill(8);
    drill.point_angle_deg = 90;
    const Feature hole = makePointedHole(140);
    const ToolSequence sequence =
        sequenceTools(hole, makeLibrary({drill}), makeMachine(), inAluminium(), kTol);
    EXPECT_NEAR(tipOf(sequence), -15 - hole.point_mm, 1e-9);
    ASSERT_EQ(sequence.residual.size(), 1U);
    EXPECT_EQ(sequence.residual.front().reason, Reason::DrillPoint);
}

TEST(SequenceTools, MillsAPointedHoleThatNoDrillFits) {
    const ToolSequence sequence = sequenceTools(
        makePointedHole(118), makeLibrary({makeDrill(7), makeMill(6)}), makeMachine(), inAluminium(), kTol);
    EXPECT_EQ(toolsOf(sequence), std::vector<std::string>{"EM6"});
}

/// Changing tools costs nothing, so that paths alone decide.
Machine machineWithoutChanges() {
    Machine machine = makeMachine();
    machine.tool_change_s = 0;
    return machine;
}

TEST(SequenceTools, DrillsAFlatHoleShortAndMillsItsFloor) {
    const Feature hole = makeHole(FeatureClass::HoleBlind);
    const ToolSequence sequence = sequenceTools(hole, makeLibrary({makeDrill(8), makeMill(6, 200)}),
                                                machineWithoutChanges(), inAluminium(), kTol);
    ASSERT_EQ(toolsOf(sequence), (std::vector<std::string>{"DR8", "EM6"}));
    EXPECT_TRUE(sequence.residual.empty());
    EXPECT_NEAR(tipOf(sequence), -15 + 0.1, 1e-9);
    const double point_mm = 4 / std::tan(degToRad(59));
    EXPECT_NEAR(sequence.steps.front().leaves.floors_mm, point_mm + 0.1, 1e-9);
    // The mill comes down in air to where the drill has left the floor.
    for (const Move& move : sequence.steps.back().path.moves)
        if (move.kind != MoveKind::Rapid && !move.in_air) {
            EXPECT_LE(move.to.z(), -15 + point_mm + 0.6);
        }
    EXPECT_EQ(sequence.steps.back().leaves.floors_mm, 0);
}

TEST(SequenceTools, ADearToolChangeKeepsAFlatHoleMilled) {
    Machine machine = makeMachine();
    machine.tool_change_s = 100000;
    const ToolSequence sequence =
        sequenceTools(makeHole(FeatureClass::HoleBlind), makeLibrary({makeDrill(8), makeMill(6, 200)}),
                      machine, inAluminium(), kTol);
    EXPECT_EQ(toolsOf(sequence), std::vector<std::string>{"EM6"});
}

TEST(SequenceTools, DrillsAllHolesOfAGroupInOneStep) {
    Feature group = makeHole(FeatureClass::HoleThrough);
    const Region other = makeCircle(Vec2(60, 20), 4);
    group.target.loops.push_back(other.loops.front());
    group.obstruction = subtract(group.obstruction, other, kTol);
    group.area_mm2 *= 2;
    group.volume_mm3 *= 2;
    const ToolSequence sequence =
        sequenceTools(group, makeLibrary({makeDrill(8)}), makeMachine(), inAluminium(), kTol);
    ASSERT_EQ(sequence.steps.size(), 1U);
    EXPECT_EQ(sequence.steps.front().holes, 2);
}

TEST(SequenceTools, ADrillWhoseHolderWouldTouchIsNotUsed) {
    Feature hole = makeHole(FeatureClass::HoleThrough);
    // A wall 10 mm from the axis stands 60 mm over the top; the holder is 40 mm wide.
    Obstacle wall{-15, 60, makeRectangle(Vec2(30, 0), Vec2(40, 40))};
    hole.obstacles.push_back(wall);
    ToolAssembly drill = makeDrill(8);
    drill.holder.push_back({40, 60, 100});
    const ToolSequence sequence =
        sequenceTools(hole, makeLibrary({drill}), makeMachine(), inAluminium(), kTol);
    EXPECT_TRUE(sequence.steps.empty());
    ASSERT_EQ(sequence.tools.size(), 1U);
    ASSERT_TRUE(sequence.tools[0].exclusion());
    EXPECT_EQ(sequence.tools[0].exclusion()->reason, ExclusionReason::HolderCollision);
}

TEST(SequenceTools, DoesNotDependOnTheNumberOfThreads) {
    const ToolLibrary library =
        makeLibrary({makeMill(20, 2000, 6), makeMill(16, 1800, 5), makeMill(12, 1500, 4),
                     makeMill(8, 1200, 3), makeMill(5, 900, 2)});
    const auto run = [&](int threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return sequenceTools(makeIslandPocket(), library, makeMachine(), inAluminium(), kTol);
    };
    const ToolSequence one = run(1);
    const ToolSequence two = run(2);
    EXPECT_EQ(toolsOf(one), toolsOf(two));
    EXPECT_EQ(one.time_s, two.time_s);
    EXPECT_EQ(one.pruned_edges, two.pruned_edges);
    ASSERT_EQ(one.edges.size(), two.edges.size());
    for (std::size_t i = 0; i < one.edges.size(); ++i) {
        EXPECT_EQ(one.edges[i].from.name(), two.edges[i].from.name());
        EXPECT_EQ(one.edges[i].to.name(), two.edges[i].to.name());
        EXPECT_EQ(one.edges[i].time_s, two.edges[i].time_s);
    }
    ASSERT_EQ(one.steps.size(), two.steps.size());
    for (std::size_t i = 0; i < one.steps.size(); ++i) {
        ASSERT_EQ(one.steps[i].path.moves.size(), two.steps[i].path.moves.size());
        for (std::size_t k = 0; k < one.steps[i].path.moves.size(); ++k)
            EXPECT_EQ(one.steps[i].path.moves[k].to, two.steps[i].path.moves[k].to);
    }
}

}  // namespace
}  // namespace stepmill::test
