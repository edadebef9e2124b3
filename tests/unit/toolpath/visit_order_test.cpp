#include "toolpath/script/visit_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace stepmill::toolpath {
namespace {

double way(const std::vector<Stop>& stops, const std::vector<std::size_t>& order) {
    double sum = 0;
    for (std::size_t i = 1; i < order.size(); ++i)
        sum += (stops[order[i]].in - stops[order[i - 1]].out).norm();
    return sum;
}

TEST(VisitOrder, GoesAlongALineFromEndToEnd) {
    std::vector<Stop> stops;
    for (const double x : {30.0, 0.0, 20.0, 40.0, 10.0})
        stops.push_back({{x, 0}, {x, 0}});
    EXPECT_NEAR(way(stops, visitOrder(stops)), 40, 1e-9);
}

TEST(VisitOrder, HasEveryStopOnce) {
    EXPECT_TRUE(visitOrder({}).empty());
    EXPECT_EQ(visitOrder({Stop{}}), std::vector<std::size_t>{0});
}

class RandomStops : public testing::TestWithParam<unsigned> {};

TEST_P(RandomStops, AreVisitedHardlyLongerThanTheShortestWay) {
    std::mt19937 random(GetParam());
    std::uniform_real_distribution<double> place(0, 100);
    std::uniform_real_distribution<double> extent(-10, 10);
    std::vector<Stop> stops(7);
    for (Stop& stop : stops) {
        stop.in = Vec2(place(random), place(random));
        stop.out = stop.in + Vec2(extent(random), extent(random));
    }
    std::vector<std::size_t> order(stops.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const double given = way(stops, order);
    double shortest = given;
    do
        shortest = std::min(shortest, way(stops, order));
    while (std::next_permutation(order.begin(), order.end()));
    const std::vector<std::size_t> found = visitOrder(stops);
    EXPECT_EQ(found, visitOrder(stops));
    EXPECT_LE(way(stops, found), given);
    EXPECT_LE(way(stops, found), 1.1 * shortest);
    std::vector<std::size_t> sorted = found;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i)
        EXPECT_EQ(sorted[i], i);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomStops, testing::Range(1U, 21U));

}  // namespace
}  // namespace stepmill::toolpath
