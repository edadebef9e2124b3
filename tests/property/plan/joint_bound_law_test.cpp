// The bound on features that share tools, against all sets of tools.

#include <random>

#include <gtest/gtest.h>

#include "plan/order/joint_bound.h"
#include "stepmill/sequence/tool_dag.h"

namespace stepmill::test {
namespace {

constexpr int kTools = 6;
constexpr int kRounds = 400;

struct Sharers {
    std::vector<LeastTimes> features;
    double change_s = 0;
};

/// One to six features, each with some of the tools in their order.
Sharers randomSharers(std::mt19937& random) {
    const auto between = [&](int from, int to) { return std::uniform_int_distribution(from, to)(random); };
    Sharers sharers;
    sharers.change_s = between(1, 20);
    for (int f = between(1, 6); f > 0; --f) {
        LeastTimes feature;
        for (int t = 0; t < kTools; ++t)
            if (std::bernoulli_distribution(0.6)(random))
                feature.tools.emplace_back(1, static_cast<char>('A' + t));
        const int n = static_cast<int>(feature.tools.size());
        for (int m = kSource; m < n; ++m) {
            std::vector<double>& row = feature.cutting_s.emplace_back(n, kNoEdge);
            for (int k = m + 1; k < n; ++k)
                if (std::bernoulli_distribution(0.8)(random)) row[k] = between(0, 40);
        }
        for (int k = 0; k < n; ++k)
            feature.ends.push_back(k + 1 == n || std::bernoulli_distribution(0.3)(random));
        sharers.features.push_back(std::move(feature));
    }
    return sharers;
}

/// The least that the feature takes with these tools alone.
double cheapestWith(const LeastTimes& feature, const std::string& tools) {
    const int n = static_cast<int>(feature.tools.size());
    return cheapestPath(
               n,
               [&](int m, int k) {
                   return tools.find(feature.tools[k]) == std::string::npos ? kNoEdge
                                                                            : feature.cuttingS(m, k);
               },
               feature.ends)
        .cost;
}

/// What the features that any tools can end take at least, changes included.
double byEnumeration(const Sharers& sharers) {
    std::vector<const LeastTimes*> possible;
    for (const LeastTimes& feature : sharers.features)
        if (cheapestWith(feature, "ABCDEF") < kNoEdge) possible.push_back(&feature);
    double best_s = kNoEdge;
    for (unsigned set = 0; set < (1U << kTools); ++set) {
        std::string tools;
        for (int t = 0; t < kTools; ++t)
            if ((set >> t & 1U) != 0) tools += static_cast<char>('A' + t);
        double sum_s = sharers.change_s * static_cast<double>(tools.size());
        for (const LeastTimes* feature : possible)
            sum_s += cheapestWith(*feature, tools);
        best_s = std::min(best_s, sum_s);
    }
    return best_s;
}

TEST(JointBoundLaw, IsNeverAboveTheCheapestSetOfToolsAndMostlyNearIt) {
    double shares = 0;
    for (unsigned seed = 0; seed < kRounds; ++seed) {
        std::mt19937 random(seed);
        const Sharers sharers = randomSharers(random);
        const double bound_s = leastTogetherS(sharers.features, sharers.change_s);
        const double optimum_s = byEnumeration(sharers);
        ASSERT_LE(bound_s, optimum_s * (1 + 1e-9)) << "seed " << seed;
        shares += optimum_s > 0 ? bound_s / optimum_s : 1;
    }
    EXPECT_GT(shares / kRounds, 0.98);
}

TEST(JointBoundLaw, OfOneFeatureIsItsCheapestPathWithChanges) {
    for (unsigned seed = 0; seed < kRounds; ++seed) {
        std::mt19937 random(seed);
        Sharers sharers = randomSharers(random);
        sharers.features.resize(1);
        const double optimum_s = byEnumeration(sharers);
        EXPECT_NEAR(leastTogetherS(sharers.features, sharers.change_s), optimum_s, 2e-3 * optimum_s)
            << "seed " << seed;
    }
}

TEST(JointBoundLaw, OfNothingIsNothing) {
    EXPECT_EQ(leastTogetherS({}, 5), 0);
    EXPECT_EQ(leastTogetherS({LeastTimes{}}, 5), 0);
}

}  // namespace
}  // namespace stepmill::test
