#include <random>

#include <gtest/gtest.h>

#include "plan/order/fewest_visits.h"
#include "plan/order/order_operations.h"

namespace stepmill {
namespace {

Precedence feature(const std::string& id, std::vector<std::string> parents = {}) {
    Precedence result;
    result.feature_id = id;
    result.parents = std::move(parents);
    return result;
}

Operation operation(const std::string& feature_id, const std::string& tool_id, double x_mm = 0) {
    Operation result;
    result.feature_id = feature_id;
    result.tool_id = tool_id;
    result.path.start = Vec3(x_mm, 0, 5);
    return result;
}

std::vector<std::string> toolsInOrder(const std::vector<Operation>& operations,
                                      const std::vector<int>& order) {
    std::vector<std::string> tools;
    for (const int index : order)
        tools.push_back(operations[index].tool_id);
    return tools;
}

int changes(const std::vector<std::string>& tools) {
    int count = 0;
    for (std::size_t i = 0; i < tools.size(); ++i)
        count += i == 0 || tools[i] != tools[i - 1] ? 1 : 0;
    return count;
}

TEST(OrderOperations, IsEmptyWithoutOperations) {
    EXPECT_TRUE(orderOperations({}, {feature("F1")}).empty());
}

TEST(OrderOperations, AToolStaysInTheSpindleOverTheChangeOfSetup) {
    const auto setup = [](const std::string& id, const std::vector<std::string>& names) {
        PlannedSetup made;
        made.setup.id = id;
        for (const std::string& name : names) {
            PlannedFeature planned;
            planned.feature.id = name;
            made.features.push_back(planned);
        }
        return made;
    };
    const std::vector<Precedence> order =
        inSetupOrder({setup("S1", {"S1.F1", "S1.F2"}), setup("S2", {"S2.F1"})});
    const std::vector<Operation> operations{operation("S1.F1", "A"), operation("S1.F2", "B"),
                                            operation("S2.F1", "A")};
    // B first, then A for both; S2 comes last whatever tools it calls.
    EXPECT_EQ(orderOperations(operations, order), (std::vector<int>{1, 0, 2}));
    EXPECT_EQ(fewestVisits(visitProblem(operations, order), kPlanSearch).tools.size(), 2U);
}

TEST(OrderOperations, AToolGoesDownAllBandsWhereItNeedNotWait) {
    std::vector<Operation> operations{operation("F1.1", "20"), operation("F1.1", "6"),
                                      operation("F1.2", "20"), operation("F1.2", "6")};
    const std::vector<Precedence> bands{feature("F1.1"), feature("F1.2", {"F1.1"})};
    EXPECT_EQ(changes(toolsInOrder(operations, orderOperations(operations, bands))), 4);
    operations[2].waits = {{"F1.1", 1}};
    operations[3].waits = {{"F1.1", 2}};
    EXPECT_EQ(toolsInOrder(operations, orderOperations(operations, bands)),
              (std::vector<std::string>{"20", "20", "6", "6"}));
}

TEST(OrderOperations, MergesTwoPocketsToolByTool) {
    const std::vector<Operation> operations{operation("F1", "20"), operation("F1", "6"),
                                            operation("F2", "20"), operation("F2", "6")};
    const std::vector<int> order = orderOperations(operations, {feature("F1"), feature("F2")});
    EXPECT_EQ(toolsInOrder(operations, order), (std::vector<std::string>{"20", "20", "6", "6"}));
}

TEST(OrderOperations, FinishesTheParentBeforeTheChild) {
    const std::vector<Operation> operations{operation("F1", "20"), operation("F1", "6"),
                                            operation("F2", "20")};
    EXPECT_EQ(orderOperations(operations, {feature("F1"), feature("F2", {"F1"})}),
              (std::vector<int>{0, 1, 2}));
}

TEST(OrderOperations, AParentWithoutOperationsStillWaitsForItsOwnParent) {
    const std::vector<Operation> operations{operation("F3", "20"), operation("F1", "20")};
    const std::vector<Precedence> features{feature("F1"), feature("F2", {"F1"}), feature("F3", {"F2"})};
    EXPECT_EQ(orderOperations(operations, features), (std::vector<int>{1, 0}));
}

TEST(OrderOperations, AsksAncestorsOnceHoweverManyWaysLeadToThem) {
    // Two features a layer, each the child of both above it: 2^60 chains from the last to the first.
    std::vector<Precedence> features{feature("A0"), feature("B0")};
    for (int i = 1; i < 60; ++i) {
        const std::vector<std::string> above{"A" + std::to_string(i - 1), "B" + std::to_string(i - 1)};
        features.push_back(feature("A" + std::to_string(i), above));
        features.push_back(feature("B" + std::to_string(i), above));
    }
    const std::vector<Operation> operations{operation("A59", "20"), operation("A0", "20")};
    EXPECT_EQ(orderOperations(operations, features), (std::vector<int>{1, 0}));
}

TEST(OrderOperations, LooksAheadToSaveAChange) {
    // Starting with the tool of the most operations at hand (A) would call A twice.
    const std::vector<Operation> operations{operation("F1", "A"), operation("F2", "A"), operation("F3", "B"),
                                            operation("F4", "A")};
    const std::vector<Precedence> features{feature("F1"), feature("F2"), feature("F3"),
                                           feature("F4", {"F3"})};
    EXPECT_EQ(changes(toolsInOrder(operations, orderOperations(operations, features))), 2);
}

TEST(OrderOperations, TakesTheNearestNextWithinAVisit) {
    const std::vector<Operation> operations{operation("F1", "A", 0), operation("F2", "A", 90),
                                            operation("F3", "A", 10)};
    EXPECT_EQ(orderOperations(operations, {feature("F1"), feature("F2"), feature("F3")}),
              (std::vector<int>{0, 2, 1}));
}

TEST(OrderOperations, KeepsPrecedenceOnRandomForests) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        std::mt19937 random(seed);
        std::vector<Precedence> features;
        std::vector<Operation> operations;
        const int count = std::uniform_int_distribution(1, 12)(random);
        for (int f = 0; f < count; ++f) {
            const int parent = std::uniform_int_distribution(-1, f - 1)(random);
            features.push_back(feature("F" + std::to_string(f)));
            if (parent >= 0) features.back().parents.push_back("F" + std::to_string(parent));
            const int steps = std::uniform_int_distribution(0, 3)(random);
            for (int s = 0; s < steps; ++s)
                operations.push_back(operation(features.back().feature_id,
                                               std::to_string(std::uniform_int_distribution(0, 4)(random))));
        }
        const std::vector<int> order = orderOperations(operations, features);
        std::vector<int> place(operations.size(), -1);
        for (std::size_t i = 0; i < order.size(); ++i)
            place[order[i]] = static_cast<int>(i);
        ASSERT_EQ(order.size(), operations.size()) << "seed " << seed;
        for (std::size_t i = 0; i < operations.size(); ++i) {
            for (std::size_t k = 0; k < operations.size(); ++k) {
                const bool same = operations[i].feature_id == operations[k].feature_id;
                const Precedence& later = *std::find_if(
                    features.begin(), features.end(),
                    [&](const Precedence& f) { return f.feature_id == operations[k].feature_id; });
                const bool parent = !later.parents.empty() && later.parents[0] == operations[i].feature_id;
                if ((same && i < k) || parent) {
                    ASSERT_LT(place[i], place[k]) << "seed " << seed;
                }
            }
        }
    }
}

/// Two pockets at x = 0 and 10, each with one below it.
const std::vector<Precedence> kTwoBranches{feature("A"), feature("B"), feature("A2", {"A"}),
                                           feature("B2", {"B"})};

std::vector<Operation> onTwoBranches(double a2_mm, double b2_mm) {
    std::vector<Operation> operations{operation("A", "T", 0), operation("B", "T", 10),
                                      operation("A2", "T", a2_mm), operation("B2", "T", b2_mm)};
    for (std::size_t i = 0; i < operations.size(); ++i)
        operations[i].z_floor_mm = i < 2 ? -5 : -10;
    return operations;
}

TEST(OrderOperations, GoesBranchByBranchOrLevelByLevel) {
    const std::vector<Operation> operations = onTwoBranches(30, 25);
    EXPECT_EQ(orderOperations(operations, kTwoBranches, OrderRule::Nearest), (std::vector<int>{0, 1, 3, 2}));
    EXPECT_EQ(orderOperations(operations, kTwoBranches, OrderRule::Branches), (std::vector<int>{0, 2, 1, 3}));
    EXPECT_EQ(orderOperations(operations, kTwoBranches, OrderRule::Levels), (std::vector<int>{0, 1, 3, 2}));
}

TEST(OrderOperations, TakesTheShortestOrderOfEachSetup) {
    // The nearest next leads back and forth: 0, 4, -5, 14.
    std::vector<Operation> operations = onTwoBranches(4, 14);
    operations[1].path.start.x() = -5;
    const ShortestOrder shortest = shortestOrder(operations, kTwoBranches);
    ASSERT_EQ(shortest.weighed.size(), 1U);
    const std::vector<WeighedOrder>& weighed = shortest.weighed.front();
    ASSERT_EQ(weighed.size(), 3U);
    EXPECT_EQ(weighed.front().rule, OrderRule::Levels);
    EXPECT_DOUBLE_EQ(weighed.front().travel_mm, 5 + 9 + 10);
    EXPECT_EQ(shortest.order, (std::vector<int>{0, 1, 2, 3}));
}

}  // namespace
}  // namespace stepmill
