#include "stepmill/planar/edge_index.h"

#include <gtest/gtest.h>

namespace stepmill {
namespace {

TEST(EdgeIndex, WithoutEdgesIsFarFromEverything) {
    const EdgeIndex none;
    EXPECT_TRUE(none.empty());
    EXPECT_TRUE(none.box().isEmpty());
    EXPECT_EQ(none.distanceTo(Vec2(1, 1)), EdgeIndex::kFarthestMm);
    EXPECT_EQ(none.distanceTo(makeLine({0, 0}, {1, 1}), 7.0), 7.0);
    EXPECT_FALSE(none.anyNearer(Vec2(1, 1), 1e9));
}

TEST(EdgeIndex, LooksNoFartherThanAsked) {
    const EdgeIndex square(makeRectangle({0, 0}, {10, 10}));
    EXPECT_EQ(square.distanceTo(Vec2(5, 4)), 4);
    EXPECT_EQ(square.distanceTo(Vec2(5, 4), 3), 3);
    EXPECT_TRUE(square.anyNearer(Vec2(5, 4), 4.1));
    EXPECT_FALSE(square.anyNearer(Vec2(5, 4), 4)) << "as near is not nearer";
    EXPECT_EQ(square.distanceTo(makeLine({3, 3}, {4, 4})), 3);
    EXPECT_EQ(square.distanceTo(makeLine({3, 3}, {14, 4})), 0);
    EXPECT_FALSE(square.anyNearer(makeLine({3, 3}, {4, 4}), 3));
}

TEST(EdgeIndex, NamesTheEdgesInABoxInTheirOrder) {
    const EdgeIndex square(makeRectangle({0, 0}, {10, 10}));
    std::vector<Vec2> starts;
    square.forEachIn(Box2(Vec2(9, 4), Vec2(11, 6)), [&](const Edge& edge) { starts.push_back(edge.from); });
    EXPECT_EQ(starts, std::vector<Vec2>{Vec2(10, 0)});
    int corner = 0;
    square.forEachIn(Box2(Vec2(10, 10), Vec2(11, 11)), [&](const Edge&) { ++corner; });
    EXPECT_EQ(corner, 2) << "edges that touch the box are in it";
}

TEST(SharesWhereMet, AreThoseOfTheMeetingsAndTheEnds) {
    const EdgeIndex square(makeRectangle({0, 0}, {10, 10}));
    EXPECT_EQ(sharesWhereMet(makeLine({15, 5}, {-5, 5}), square), (std::vector<double>{0, 0.25, 0.75, 1}));
    EXPECT_EQ(sharesWhereMet(makeLine({2, 2}, {8, 8}), square), (std::vector<double>{0, 1}));
}

}  // namespace
}  // namespace stepmill
