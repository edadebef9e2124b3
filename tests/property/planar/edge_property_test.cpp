// Distances and crossings of lines and arcs against points sampled along them.

#include "stepmill/planar/edge_index.h"

#include <gtest/gtest.h>

#include <random>

namespace stepmill {
namespace {

constexpr int kSamples = 400;

Edge randomEdge(std::mt19937& random) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const Vec2 at(between(-10, 10), between(-10, 10));
    if (random() % 2 == 0) return makeEdge(at, {Vec2(between(-10, 10), between(-10, 10)), std::nullopt});
    const double r = between(0.5, 8);
    const double from = between(0, 7);
    const double to = from + between(0.1, 6);
    const Arc arc{at, r, random() % 2 == 0};
    return makeEdge(at + r * Vec2(std::cos(from), std::sin(from)),
                    {Vec2(at + r * Vec2(std::cos(to), std::sin(to))), arc});
}

class RandomEdges : public testing::TestWithParam<unsigned> {};

TEST_P(RandomEdges, AreAsFarApartAsTheirPoints) {
    SCOPED_TRACE("seed " + std::to_string(GetParam()));
    std::mt19937 random(GetParam());
    for (int trial = 0; trial < 50; ++trial) {
        const Edge a = randomEdge(random);
        const Edge b = randomEdge(random);
        double sampled = 1e300;
        for (int i = 0; i <= kSamples; ++i) {
            const double share = static_cast<double>(i) / kSamples;
            sampled = std::min(sampled, distanceTo(pointAt(a, share), b.from, b.segment));
        }
        const double step = length(a) / kSamples;
        EXPECT_LE(separation(a, b), sampled + 1e-9);
        EXPECT_GE(separation(a, b), sampled - step / 2 - 1e-9);
        EXPECT_NEAR(separation(a, b), separation(b, a), 1e-9);
    }
}

TEST_P(RandomEdges, AreCutIntoPartsThatAddUp) {
    SCOPED_TRACE("seed " + std::to_string(GetParam()));
    std::mt19937 random(GetParam());
    for (int trial = 0; trial < 50; ++trial) {
        const Edge edge = randomEdge(random);
        const double share = std::uniform_real_distribution<double>(0.01, 0.99)(random);
        const auto head = cutOut(edge, 0, share);
        const auto tail = cutOut(edge, share, 1);
        ASSERT_TRUE(head && tail);
        EXPECT_EQ(head->segment.to, tail->from);
        EXPECT_NEAR(length(*head) + length(*tail), length(edge), 1e-5);
        EXPECT_NEAR(shareOf(edge, head->segment.to), share, 1e-4);
    }
}

TEST_P(RandomEdges, HaveTheirNearestPointAtTheirDistance) {
    SCOPED_TRACE("seed " + std::to_string(GetParam()));
    std::mt19937 random(GetParam());
    std::uniform_real_distribution<double> anywhere(-12, 12);
    for (int trial = 0; trial < 200; ++trial) {
        const Edge edge = randomEdge(random);
        const Vec2 p(anywhere(random), anywhere(random));
        const Vec2 nearest = nearestPoint(edge, p);
        EXPECT_NEAR((nearest - p).norm(), distanceTo(p, edge), 1e-9);
        EXPECT_NEAR(distanceTo(nearest, edge), 0, 1e-9);
    }
}

TEST_P(RandomEdges, AreFoundByTheIndexAsByASearchThroughAll) {
    SCOPED_TRACE("seed " + std::to_string(GetParam()));
    std::mt19937 random(GetParam());
    std::uniform_real_distribution<double> anywhere(-12, 12);
    std::vector<Edge> edges;
    for (unsigned i = 0; i < 3 * GetParam() * GetParam(); ++i)
        edges.push_back(randomEdge(random));
    const EdgeIndex index(edges);
    for (int trial = 0; trial < 50; ++trial) {
        const Edge edge = randomEdge(random);
        const Vec2 p(anywhere(random), anywhere(random));
        double to_point = 3;
        double to_edge = EdgeIndex::kFarthestMm;
        for (const Edge& other : edges) {
            to_point = std::min(to_point, distanceTo(p, other));
            to_edge = std::min(to_edge, separation(edge, other));
        }
        EXPECT_EQ(index.distanceTo(p, 3), to_point);
        EXPECT_EQ(index.distanceTo(edge), to_edge);
        EXPECT_EQ(index.anyNearer(p, 0.2), to_point < 0.2);
        EXPECT_EQ(index.anyNearer(edge, 0.2), to_edge < 0.2);
        std::vector<Vec2> found;
        std::vector<Vec2> expected;
        index.forEachIn(edge.box, [&](const Edge& other) { found.push_back(other.from); });
        for (const Edge& other : edges)
            if (other.box.intersects(edge.box)) expected.push_back(other.from);
        EXPECT_EQ(found, expected);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomEdges, testing::Range(1U, 11U));

}  // namespace
}  // namespace stepmill
