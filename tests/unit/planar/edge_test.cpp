#include "stepmill/planar/edge.h"

#include <gtest/gtest.h>

#include <limits>

#include "stepmill/core/units.h"
#include "stepmill/planar/path_parts.h"

namespace stepmill {
namespace {

/// The left half of the unit circle about the origin, from top to bottom.
Edge leftHalf() {
    return makeEdge({0, 1}, {{0, -1}, Arc{{0, 0}, 1, true}});
}

Path square() {
    return makeRectangle({0, 0}, {2, 2}).loops.front();
}

TEST(Vector, LeftIsAQuarterTurnCounterClockwise) {
    EXPECT_EQ(leftOf({1, 0}), Vec2(0, 1));
    EXPECT_EQ(cross({1, 0}, {0, 2}), 2);
    EXPECT_EQ(cross({0, 2}, {1, 0}), -2);
}

TEST(Box, ThatIsEmptyStaysEmptyWhenGrown) {
    EXPECT_TRUE(grown(Box2(), 5).isEmpty());
    const Box2 box = grown(Box2(Vec2(1, 2)), 3);
    EXPECT_EQ(box.min(), Vec2(-2, -1));
    EXPECT_EQ(box.max(), Vec2(4, 5));
}

TEST(Edge, HasABoxAroundTheArcItself) {
    const Box2 box = leftHalf().box;
    EXPECT_EQ(box.min(), Vec2(-1, -1));
    EXPECT_EQ(box.max(), Vec2(0, 1));
}

TEST(Edge, ListsARegionLoopByLoop) {
    const Region ring = {{square(), reversed(makeRectangle({0.5, 0.5}, {1.5, 1.5}).loops.front())}};
    const std::vector<Edge> edges = edgesOf(ring);
    ASSERT_EQ(edges.size(), 8U);
    EXPECT_EQ(edges[3].to(), ring.loops[0].start);
    EXPECT_EQ(edges[4].from, ring.loops[1].start);
}

TEST(Edge, KnowsItsNearestPoint) {
    const Edge line = makeLine({0, 0}, {4, 0});
    EXPECT_EQ(nearestPoint(line, {1, 3}), Vec2(1, 0));
    EXPECT_EQ(nearestPoint(line, {-1, 3}), Vec2(0, 0));
    EXPECT_EQ(nearestPoint(line, {9, 3}), Vec2(4, 0));
    EXPECT_NEAR((nearestPoint(leftHalf(), {-3, 0}) - Vec2(-1, 0)).norm(), 0, 1e-12);
    EXPECT_EQ(nearestPoint(leftHalf(), {3, 0.5}), Vec2(0, 1)) << "the circle's other half is not the edge";
    EXPECT_EQ(nearestPoint(leftHalf(), {2e-6, 1e-6}), Vec2(0, 1)) << "no direction within rounding";
    EXPECT_EQ(nearestPoint(leftHalf(), {0, 0}), Vec2(0, -1)) << "an end stands for all the arc";
}

TEST(EachEdge, GoesThroughAllLoopsAsEdgesOfDoes) {
    Region region = makeRectangle({0, 0}, {4, 3});
    region.loops.push_back({{1, 1}, {}});  // a path without edges has none to show
    region.loops.push_back(makeCircle({9, 9}, 1).loops[0]);
    const std::vector<Edge> edges = edgesOf(makeRectangle({0, 0}, {4, 3}));
    std::vector<Vec2> starts;
    for (const auto& [from, segment] : eachEdge(region))
        starts.push_back(from);
    ASSERT_EQ(starts.size(), 6U);
    for (std::size_t i = 0; i < edges.size(); ++i)
        EXPECT_EQ(starts[i], edges[i].from);
    EXPECT_EQ(starts[4], region.loops[2].start);
    EXPECT_EQ(starts[5], region.loops[2].segments[0].to);
}

TEST(EachEdge, OfNothingIsNone) {
    const Region empty;
    for (const auto& [from, segment] : eachEdge(empty))
        ADD_FAILURE() << from.transpose();
    const Path point{{1, 1}, {}};
    for (const auto& [from, segment] : eachEdge(point))
        ADD_FAILURE() << from.transpose();
    EXPECT_EQ(distanceTo({1, 1}, point), std::numeric_limits<double>::infinity());
}

TEST(Edge, OfNoLengthIsAPoint) {
    const Edge point = makeLine({1, 1}, {1, 1});
    EXPECT_EQ(shareOf(point, {3, 3}), 0);
    EXPECT_EQ(nearestPoint(point, {3, 3}), Vec2(1, 1));
    EXPECT_EQ(separation(point, makeLine({1, 2}, {5, 2})), 1);
    EXPECT_EQ(separation(point, makeEdge({1, 3}, {{1, 3}, Arc{{1, 4}, 1, true}})), 2);
}

TEST(Edge, TellsTheShareOfAPointOnIt) {
    EXPECT_DOUBLE_EQ(shareOf(makeLine({0, 0}, {4, 0}), {1, 0}), 0.25);
    EXPECT_DOUBLE_EQ(shareOf(leftHalf(), {-1, 0}), 0.5);
    EXPECT_EQ(shareOf(leftHalf(), leftHalf().from), 0);
    EXPECT_EQ(shareOf(leftHalf(), leftHalf().to()), 1);
    EXPECT_EQ(shareOf(leftHalf(), {1e-9, 1}), 0) << "a rounding error before the start";
    EXPECT_EQ(shareOf(leftHalf(), {1e-9, -1}), 1) << "a rounding error past the end";
}

TEST(Edge, IsCutIntoParts) {
    const auto part = cutOut(makeLine({0, 0}, {4, 0}), 0.25, 0.5);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->from, Vec2(1, 0));
    EXPECT_EQ(part->to(), Vec2(2, 0));
    EXPECT_FALSE(cutOut(leftHalf(), 0.5, 0.5 + 1e-8)) << "ends on the same grid point";
    EXPECT_FALSE(cutOut(leftHalf(), 0.5, 0.25));
}

TEST(Edge, MeetsAnotherWhereBothAre) {
    const Edge line = makeLine({-5, 0}, {5, 0});
    ASSERT_EQ(meetingPoints(line, leftHalf()).size(), 1U);
    EXPECT_NEAR((meetingPoints(line, leftHalf()).front() - Vec2(-1, 0)).norm(), 0, 1e-12);
    EXPECT_EQ(meetingPoints(line, makeLine({1, -1}, {1, 1})), std::vector<Vec2>{Vec2(1, 0)});
    EXPECT_TRUE(meetingPoints(line, makeLine({6, -1}, {6, 1})).empty()) << "its carrier alone meets";
    EXPECT_TRUE(meetingPoints(line, makeLine({0, 0}, {3, 0})).empty()) << "they overlap along a length";
}

TEST(Edge, IsApartFromAnother) {
    EXPECT_EQ(separation(makeLine({0, 0}, {4, 0}), makeLine({1, 3}, {2, 5})), 3);
    EXPECT_EQ(separation(makeLine({0, 0}, {4, 0}), makeLine({1, -3}, {2, 5})), 0);
    const Edge full = makeEdge({1, 0}, {{1, 0}, Arc{{0, 0}, 1, true}});
    EXPECT_NEAR(separation(full, makeLine({-5, 3}, {5, 3})), 2, 1e-12);
    EXPECT_NEAR(separation(full, makeEdge({0.5, 0}, {{0.5, 0}, Arc{{0, 0}, 0.5, true}})), 0.5, 1e-12);
}

TEST(PathParts, FindTheNearestPointOfAPath) {
    const NearestPoint nearest = nearestOn(square(), {2.5, 0.5});
    EXPECT_DOUBLE_EQ(nearest.distance_mm, 0.5);
    EXPECT_EQ(nearest.edge, 1U);
    EXPECT_DOUBLE_EQ(nearest.share, 0.25);
    EXPECT_EQ(nearest.point, Vec2(2, 0.5));
    EXPECT_EQ(nearestOn(Path{{3, 4}, {}}, {0, 0}).distance_mm, 5);
}

TEST(PathParts, TurnALoopToStartElsewhere) {
    const Path turned = startingAt(square(), 1, 0.25);
    EXPECT_EQ(turned.start, Vec2(2, 0.5));
    EXPECT_TRUE(turned.closed());
    EXPECT_DOUBLE_EQ(length(turned), 8);
    EXPECT_EQ(startingAt(square(), 1, 0).start, Vec2(2, 0));
    EXPECT_EQ(startingAt(square(), 1, 1).start, Vec2(2, 2));
}

TEST(PathParts, EndAtALength) {
    EXPECT_EQ(firstPart(square(), 2.5).end(), Vec2(2, 0.5));
    EXPECT_EQ(firstPart(square(), 100).segments.size(), 4U);
}

}  // namespace
}  // namespace stepmill
