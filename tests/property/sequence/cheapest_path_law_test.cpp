#include <random>

#include <gtest/gtest.h>

#include "stepmill/sequence/tool_dag.h"

namespace stepmill {
namespace {

/// A random DAG whose costs are small whole numbers, so that ties are common and sums exact.
struct RandomDag {
    int n;
    std::vector<double> costs;  // (n + 1) x n, row 0 the source
    std::vector<bool> ends;
    std::vector<double> savings;  // (n + 1) x n x (n + 1), the sink last; empty: none

    double saving(int m, int k, int next) const {
        if (savings.empty()) return 0;
        return savings[static_cast<std::size_t>(((m + 1) * n + k) * (n + 1) + next)];
    }
    double edge(int m, int k) const { return costs[static_cast<std::size_t>((m + 1) * n + k)]; }
};

RandomDag randomDag(std::mt19937& random) {
    RandomDag dag;
    dag.n = std::uniform_int_distribution(0, 10)(random);
    const int largest = std::uniform_int_distribution(0, 1)(random) == 0 ? 4 : 1000;
    const double missing = std::uniform_real_distribution(0.0, 0.8)(random);
    for (int i = 0; i < (dag.n + 1) * dag.n; ++i) {
        const bool absent = std::bernoulli_distribution(missing)(random);
        dag.costs.push_back(absent ? kNoEdge : std::uniform_int_distribution(0, largest)(random));
    }
    for (int i = 0; i < dag.n; ++i)
        dag.ends.push_back(std::bernoulli_distribution(0.4)(random));
    return dag;
}

/// Most edges save nothing; none saves more than it costs.
void addSavings(RandomDag& dag, std::mt19937& random) {
    for (int m = kSource; m < dag.n; ++m) {
        for (int k = 0; k < dag.n; ++k) {
            for (int next = 0; next <= dag.n; ++next) {
                const double cost = dag.edge(m, k);
                const bool saves = cost < kNoEdge && next < dag.n && std::bernoulli_distribution(0.4)(random);
                const int most = saves ? static_cast<int>(cost) : 0;
                dag.savings.push_back(std::uniform_int_distribution(0, most)(random));
            }
        }
    }
}

/// Tries every subset of the tools in falling diameter [DSouza2006, eq. 10 and 11].
CheapestPath byEnumeration(const RandomDag& dag) {
    CheapestPath best;
    for (unsigned subset = 1; subset < (1U << dag.n); ++subset) {
        CheapestPath path;
        path.cost = 0;
        int before = kSource;
        int last = kSource;
        for (int k = 0; k < dag.n; ++k) {
            if ((subset >> k & 1U) == 0) continue;
            if (last != kSource) path.cost -= dag.saving(before, last, k);
            path.cost += dag.edge(last, k);
            path.tools.push_back(k);
            before = last;
            last = k;
        }
        if (!dag.ends[last] || path.cost == kNoEdge) continue;
        const auto rank = [](const CheapestPath& p) { return std::tuple(p.cost, p.tools.size(), p.tools); };
        if (best.tools.empty() || rank(path) < rank(best)) best = path;
    }
    return best;
}

TEST(CheapestPathLaw, EqualsTheEnumerationOfAllSequences) {
    for (unsigned seed = 0; seed < 1000; ++seed) {
        std::mt19937 random(seed);
        const RandomDag dag = randomDag(random);
        const CheapestPath found = cheapestPath(
            dag.n, [&](int m, int k) { return dag.edge(m, k); }, dag.ends);
        const CheapestPath expected = byEnumeration(dag);
        ASSERT_EQ(found.cost, expected.cost) << "seed " << seed;
        ASSERT_EQ(found.tools, expected.tools) << "seed " << seed;
    }
}

TEST(CheapestPathLaw, WithSavingsEqualsTheEnumerationOfAllSequences) {
    for (unsigned seed = 0; seed < 1000; ++seed) {
        std::mt19937 random(seed);
        RandomDag dag = randomDag(random);
        addSavings(dag, random);
        const CheapestPath found = cheapestPath(
            dag.n, [&](int m, int k) { return dag.edge(m, k); }, dag.ends,
            [&](int m, int k, int next) { return dag.saving(m, k, next); });
        const CheapestPath expected = byEnumeration(dag);
        ASSERT_EQ(found.cost, expected.cost) << "seed " << seed;
        ASSERT_EQ(found.tools, expected.tools) << "seed " << seed;
    }
}

TEST(CheapestPathLaw, AsksForEveryEdgeAtMostOnce) {
    for (int n = 1; n <= 20; ++n) {
        std::map<std::pair<int, int>, int> asked;
        cheapestPath(
            n,
            [&](int m, int k) {
                return static_cast<double>(++asked[{m, k}]);
            },
            std::vector<bool>(n, true));
        EXPECT_EQ(asked.size(), static_cast<std::size_t>(n * (n + 1) / 2));
        for (const auto& [edge, times] : asked)
            EXPECT_EQ(times, 1) << edge.first << " to " << edge.second;
    }
}

}  // namespace
}  // namespace stepmill
