#include <random>

#include <gtest/gtest.h>

#include "stepmill/sequence/advice/sensitivity.h"
#include "support/random_numbers.h"
#include "support/sample_feature.h"

namespace stepmill::test {
namespace {

constexpr int kSamples = 400;

struct RandomCase {
    ToolLibrary library;
    std::vector<DagEdge> edges;
};

/// Edges between random pairs of tools; the last tool always ends, others now and then.
RandomCase randomCase(std::mt19937& random) {
    RandomCase result;
    const int n = std::uniform_int_distribution(1, 8)(random);
    for (int i = 0; i < n; ++i) {
        ToolAssembly tool = makeMill(30 - 3 * i);
        tool.price = uniform(random, 0, 200);
        tool.life_min = std::bernoulli_distribution(0.8)(random) ? uniform(random, 5, 100) : 0;
        result.library.tools.push_back(tool);
    }
    std::vector<DagNode> nodes;
    for (const ToolAssembly& tool : result.library.tools)
        nodes.push_back({tool.id, std::bernoulli_distribution(0.3)(random)});
    for (int m = -1; m < n; ++m) {
        const DagNode from = m < 0 ? DagNode{} : nodes[m];
        for (int k = m + 1; k < n; ++k) {
            if (m >= 0 && std::bernoulli_distribution(0.2)(random)) continue;
            DagEdge edge;
            edge.from = from;
            edge.to = nodes[k];
            edge.totals.feed_time_s = uniform(random, 1, 400) / (m + 2);
            edge.totals.rapid_time_s = uniform(random, 0, 5);
            result.edges.push_back(edge);
        }
        if (m == n - 1 || (m >= 0 && std::bernoulli_distribution(0.3)(random))) {
            DagEdge end;
            end.from = from;
            result.edges.push_back(end);
        }
    }
    return result;
}

/// The least cost of all paths at one value, by trying them all.
double byEnumeration(const RandomCase& given, const DagNode& from, double value, const Machine& machine,
                     Parameter parameter, Objective objective) {
    double least = std::numeric_limits<double>::infinity();
    for (const DagEdge& edge : given.edges) {
        if (edge.from != from) continue;
        if (edge.to.empty()) {
            least = std::min(least, 0.0);
            continue;
        }
        Machine at = machine;
        ToolAssembly tool = given.library.tool(edge.to.tool);
        if (parameter == Parameter::ToolChange) at.tool_change_s = value;
        if (parameter == Parameter::HourlyRate) at.hourly_rate = value;
        if (parameter == Parameter::ToolPrice) tool.price *= value;
        const EdgeCost cost = edgeCost(edge.totals, tool, at);
        const double own = objective == Objective::Time ? cost.time_s : cost.cost;
        least = std::min(least, own + byEnumeration(given, edge.to, value, machine, parameter, objective));
    }
    return least;
}

TEST(SensitivityLaw, RangesHoldTheOptimumAtEverySampledValue) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        std::mt19937 random(seed);
        const RandomCase given = randomCase(random);
        const Machine machine = makeMachine();
        for (const Parameter parameter :
             {Parameter::ToolChange, Parameter::HourlyRate, Parameter::ToolPrice}) {
            const Objective objective =
                objectiveFor(parameter, seed % 2 == 0 ? Objective::Time : Objective::Cost);
            const auto ranges =
                bestSequences(cheapestOverEdges(given.edges, given.library, machine, parameter, objective));
            const double last = std::isinf(ranges.back().to) && ranges.size() > 1 ? ranges.back().from : 10;
            std::size_t range = 0;
            for (int i = 0; i <= kSamples; ++i) {
                const double value = 2 * last * i / kSamples;
                while (value > ranges[range].to)
                    ++range;
                const double expected = byEnumeration(given, {}, value, machine, parameter, objective);
                ASSERT_NEAR(ranges[range].line.at(value), expected, 1e-7 * (1 + expected))
                    << "seed " << seed << ", " << toString(parameter) << " " << value;
            }
        }
    }
}

TEST(SensitivityLaw, RangesMeetWhereTheirLinesDoAndSlopesFall) {
    for (unsigned seed = 100; seed < 300; ++seed) {
        std::mt19937 random(seed);
        const RandomCase given = randomCase(random);
        const auto ranges = bestSequences(cheapestOverEdges(given.edges, given.library, makeMachine(),
                                                            Parameter::ToolChange, Objective::Time));
        EXPECT_EQ(ranges.front().from, 0) << "seed " << seed;
        for (std::size_t i = 1; i < ranges.size(); ++i) {
            const double meet = ranges[i].from;
            EXPECT_EQ(ranges[i - 1].to, meet) << "seed " << seed;
            EXPECT_NEAR(ranges[i - 1].line.at(meet), ranges[i].line.at(meet), 1e-9 * ranges[i].line.at(meet))
                << "seed " << seed;
            EXPECT_LT(ranges[i].line.per_unit, ranges[i - 1].line.per_unit) << "seed " << seed;
            EXPECT_LT(ranges[i].line.tools.size(), ranges[i - 1].line.tools.size()) << "seed " << seed;
        }
    }
}

}  // namespace
}  // namespace stepmill::test
