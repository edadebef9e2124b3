// Distances and crossings of lines and arcs against points sampled along them.

#include "toolpath/curve.h"

#include <gtest/gtest.h>

#include <random>

namespace stepmill::toolpath {
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
            sampled = std::min(sampled, distanceTo(pointAt(a.from, a.segment, share), b.from, b.segment));
        }
        const double step = length(a.from, a.segment) / kSamples;
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
        EXPECT_NEAR(length(head->from, head->segment) + length(tail->from, tail->segment),
                    length(edge.from, edge.segment), 1e-5);
        EXPECT_NEAR(shareOf(edge, head->segment.to), share, 1e-4);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomEdges, testing::Range(1U, 11U));

}  // namespace
}  // namespace stepmill::toolpath
