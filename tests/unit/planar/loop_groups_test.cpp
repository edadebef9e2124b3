// Loops that nothing meets are left out of Booleans, which must not show.

#include <gtest/gtest.h>

#include "planar/boolean/loop_groups.h"
#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;
constexpr double kApartMm = 2e-3;

Region plateWithHoles() {
    const Region holes[] = {makeCircle({10, 10}, 4), makeRoundedRectangle({20, 5}, {30, 15}, 2),
                            makeCircle({40, 10}, 3)};
    return subtract(makeRectangle({0, 0}, {50, 20}), unite(holes, kTol), kTol);
}

std::vector<planar::OperandLoop> loopsOf(const Region& region, int operand) {
    std::vector<planar::OperandLoop> loops;
    for (const Loop& loop : region.loops)
        loops.push_back({&loop, operand});
    return loops;
}

TEST(LoopGroups, HoldTogetherWhatMeets) {
    const Region plate = plateWithHoles();
    const Region cutter = makeCircle({40, 14}, 2);
    std::vector<planar::OperandLoop> loops = loopsOf(plate, 0);
    loops.push_back({&cutter.loops.front(), 1});
    const std::vector<planar::LoopGroup> groups = planar::loopGroups(loops, kApartMm);
    // The cutter and the hole it cuts into; the plate's edge and the two other holes alone.
    ASSERT_EQ(groups.size(), 4U);
    std::size_t most = 0;
    for (const planar::LoopGroup& group : groups)
        most = std::max(most, group.loops.size());
    EXPECT_EQ(most, 2U);
    // The plate's edge winds once around all but itself.
    EXPECT_EQ(groups.front().around[0], 0);
    for (std::size_t i = 1; i < groups.size(); ++i)
        EXPECT_EQ(groups[i].around[0], 1) << i;
}

TEST(LoopGroups, LoopsThatTouchAreOne) {
    const Region two[] = {makeRectangle({0, 0}, {10, 10}), makeRectangle({10, 2}, {20, 8})};
    std::vector<planar::OperandLoop> loops = loopsOf(two[0], 0);
    loops.push_back({&two[1].loops.front(), 1});
    EXPECT_EQ(planar::loopGroups(loops, kApartMm).size(), 1U);
}

TEST(LoopGroups, ATidyLoopNeedsNoBoolean) {
    const Region rounded = makeRoundedRectangle({0, 0}, {30, 20}, 5);
    const Region circle = makeCircle({3, 4}, 5);
    EXPECT_TRUE(planar::isTidy({&rounded.loops.front(), 0}, kApartMm, kTol.linear_mm));
    EXPECT_TRUE(planar::isTidy({&circle.loops.front(), 0}, kApartMm, kTol.linear_mm));
}

TEST(LoopGroups, ALoopWithAnEdgeInTwoPiecesIsNotTidy) {
    const Region split = makePolygon({{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}});
    EXPECT_FALSE(planar::isTidy({&split.loops.front(), 0}, kApartMm, kTol.linear_mm));
    EXPECT_EQ(unite(split, Region{}, kTol).loops.front().segments.size(), split.loops.front().segments.size())
        << "a region that meets no other is not touched at all";
    EXPECT_EQ(intersect(split, makeRectangle({-1, -1}, {11, 11}), kTol).loops.front().segments.size(), 4U);
}

TEST(LoopGroups, ALoopThatCrossesItselfIsNotTidy) {
    // Once around a square and once more around a part of it.
    const Region twice{{Loop{{0, 0},
                             {{{10, 0}, {}},
                              {{10, 10}, {}},
                              {{0, 10}, {}},
                              {{0, 4}, {}},
                              {{6, 4}, {}},
                              {{6, 6}, {}},
                              {{-4, 6}, {}},
                              {{-4, 0}, {}},
                              {{0, 0}, {}}}}}};
    EXPECT_FALSE(planar::isTidy({&twice.loops.front(), 0}, kApartMm, kTol.linear_mm));
    const Region around = makeRectangle({-20, -20}, {20, 20});
    EXPECT_NEAR(area(intersect(twice, around, kTol)), 100 + 24, 1e-6);
}

TEST(Boolean, LeavesHolesAloneThatNothingMeets) {
    const Region plate = plateWithHoles();
    const Region notched = subtract(plate, makeRectangle({48, 8}, {52, 12}), kTol);
    EXPECT_NEAR(area(notched), area(plate) - 8, 1e-9);
    EXPECT_EQ(notched.loops.size(), plate.loops.size());
    EXPECT_EQ(area(subtract(notched, plate, kTol)), 0);
}

TEST(Boolean, KnowsOnWhichSideOfOthersALoopLies) {
    const Region plate = plateWithHoles();
    const Region in_hole = makeCircle({10, 10}, 2);
    const Region in_plate = makeCircle({15, 3}, 1);
    const Region beside = makeCircle({70, 10}, 5);
    EXPECT_NEAR(area(unite(plate, in_hole, kTol)), area(plate) + area(in_hole), 1e-9);
    EXPECT_NEAR(area(unite(plate, in_plate, kTol)), area(plate), 1e-9);
    EXPECT_NEAR(area(unite(plate, beside, kTol)), area(plate) + area(beside), 1e-9);
    EXPECT_TRUE(intersect(plate, in_hole, kTol).empty());
    EXPECT_NEAR(area(intersect(plate, in_plate, kTol)), area(in_plate), 1e-9);
    EXPECT_NEAR(area(subtract(plate, in_hole, kTol)), area(plate), 1e-9);
    EXPECT_NEAR(area(subtract(plate, in_plate, kTol)), area(plate) - area(in_plate), 1e-9);
    EXPECT_EQ(subtract(plate, in_plate, kTol).loops.size(), plate.loops.size() + 1);
}

}  // namespace
}  // namespace stepmill
