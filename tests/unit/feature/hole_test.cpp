#include <gtest/gtest.h>

#include "graph_maker.h"
#include "stepmill/feature/hole.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::GraphMaker;

using test::kTol;

Hole onlyHole(const GraphMaker& maker) {
    const std::vector<Hole> holes = findHoles(maker.graph, kTol);
    EXPECT_EQ(holes.size(), 1U);
    return holes.empty() ? Hole{} : holes.front();
}

TEST(FindHoles, TwoHalvesOfABoreAreOneThroughHole) {
    GraphMaker maker;
    maker.bore({3, 4}, 2.5, 0, 12, kPi);
    maker.bore({3, 4}, 2.5, 0, 12, kPi);
    const Hole hole = onlyHole(maker);
    EXPECT_EQ(holeName(hole), "through hole");
    EXPECT_NEAR(hole.diameter_mm(), 5, 1e-9);
    EXPECT_NEAR(hole.depth_mm(), 12, 1e-9);
    EXPECT_EQ(hole.faces, (std::vector<int>{0, 1}));
}

TEST(FindHoles, HalfABoreIsASlotsEndAndNoHole) {
    GraphMaker maker;
    maker.bore({0, 0}, 2, 0, 10, kPi);
    EXPECT_TRUE(findHoles(maker.graph, kTol).empty());
}

TEST(FindHoles, AFloorMakesItBlindAndTheOtherEndItsEntry) {
    GraphMaker maker;
    const int wall = maker.bore({0, 0}, 2, 5, 20);
    const int floor = maker.plane({0, 0, 5}, {0, 0, 1});
    maker.meet(wall, floor, Bend::Concave, {2, 0, 5});
    const Hole hole = onlyHole(maker);
    EXPECT_EQ(holeName(hole), "blind hole");
    EXPECT_FALSE(hole.drill_point);
    EXPECT_NEAR(hole.entry.z(), 20, 1e-9);
    EXPECT_NEAR(hole.axis.z(), 1, 1e-9);
}

TEST(FindHoles, APointBelowIsADrillPoint) {
    GraphMaker maker;
    maker.cone({0, 0}, 0, 8.8, 2, 10);
    maker.bore({0, 0}, 2, 10, 20);
    const Hole hole = onlyHole(maker);
    EXPECT_EQ(holeName(hole), "blind hole");
    EXPECT_TRUE(hole.drill_point);
    ASSERT_EQ(hole.steps.size(), 2U);
    EXPECT_EQ(hole.steps[1].kind, HoleStep::Kind::Point);
    EXPECT_NEAR(hole.steps[1].bottom_mm, 11.2, 1e-6);
}

TEST(FindHoles, AWiderBoreAboveIsACounterbore) {
    GraphMaker maker;
    maker.bore({0, 0}, 5, 15, 20);
    maker.bore({0, 0}, 3, 0, 15);
    const Hole hole = onlyHole(maker);
    EXPECT_EQ(holeName(hole), "counterbored through hole");
    ASSERT_EQ(hole.steps.size(), 2U);
    EXPECT_NEAR(hole.steps[0].diameter_mm, 10, 1e-9) << "the wider end is the entry";
    EXPECT_NEAR(hole.diameter_mm(), 6, 1e-9);
}

TEST(FindHoles, ARingGrooveRoundABoreIsNoCounterbore) {
    GraphMaker maker;
    const int groove = maker.bore({0, 0}, 20, 18, 20);
    const int land = maker.bore({0, 0}, 17, 18, 20);
    maker.graph.faces[land].hollow = false;
    const int bore = maker.bore({0, 0}, 6, 0, 20);
    const Hole hole = onlyHole(maker);
    EXPECT_EQ(holeName(hole), "through hole");
    EXPECT_EQ(hole.faces, std::vector<int>{bore});
    // Without the land it is one.
    maker.graph.faces[land].hollow = true;
    EXPECT_EQ(findHoles(maker.graph, kTol).front().faces.front(), groove);
}

TEST(FindHoles, AWideConeAboveIsACountersinkANarrowOneABrokenEdge) {
    GraphMaker wide;
    wide.bore({0, 0}, 3, 0, 18);
    wide.cone({0, 0}, 3, 18, 5, 20);
    EXPECT_EQ(holeName(onlyHole(wide)), "countersunk through hole");
    GraphMaker narrow;
    narrow.bore({0, 0}, 3, 0, 19.5);
    narrow.cone({0, 0}, 3, 19.5, 3.5, 20);
    EXPECT_EQ(holeName(onlyHole(narrow)), "through hole");
}

TEST(FindHoles, BoresWithAGapBetweenAreTwoHoles) {
    GraphMaker maker;
    maker.bore({0, 0}, 3, 0, 5);
    maker.bore({0, 0}, 3, 12, 17);
    EXPECT_EQ(findHoles(maker.graph, kTol).size(), 2U);
}

}  // namespace
}  // namespace stepmill
