#include "plan/order/fewest_visits.h"

#include <gtest/gtest.h>

namespace stepmill {
namespace {

/// Features with the tools of their operations, and the features that each waits for wholly.
struct Drawn {
    std::vector<std::vector<int>> tools;
    std::vector<std::vector<int>> parents;
};

VisitProblem problemOf(const Drawn& drawn) {
    std::vector<VisitOperation> operations;
    std::vector<VisitFeature> features;
    for (std::size_t f = 0; f < drawn.tools.size(); ++f) {
        features.push_back({0, drawn.parents[f]});
        for (const int tool : drawn.tools[f])
            operations.push_back({tool, static_cast<int>(f), 0, {}});
    }
    return visitProblem(std::move(operations), features);
}

FewestVisits fewestOf(const Drawn& drawn) {
    return fewestVisits(problemOf(drawn), kPlanSearch);
}

TEST(FewestVisits, AreNoneWithoutOperations) {
    const FewestVisits none = fewestOf({{{}}, {{}}});
    EXPECT_TRUE(none.tools.empty());
    EXPECT_EQ(none.at_least, 0);
}

TEST(FewestVisits, AToolThatComesTwiceInAChainIsCalledTwice) {
    // 0 1 in the parent, 0 in the child.
    const FewestVisits fewest = fewestOf({{{0, 1}, {0}}, {{}, {0}}});
    EXPECT_EQ(fewest.tools, (std::vector<int>{0, 1, 0}));
    EXPECT_EQ(fewest.at_least, 3);
}

TEST(FewestVisits, EachToolOnceWhereNothingForbidsIt) {
    // Four pockets, each roughed by 0 and finished by another tool, and a hole under each.
    const FewestVisits fewest = fewestOf(
        {{{0, 1}, {0, 2}, {0, 1}, {0, 2}, {3}, {3}, {4}, {4}}, {{}, {}, {}, {}, {0}, {1}, {2}, {3}}});
    EXPECT_EQ(fewest.tools.size(), 5U);
    EXPECT_EQ(fewest.at_least, 5);
}

TEST(FewestVisits, TwoToolsThatWaitForEachOtherTakeThreeVisits) {
    // 0 over 1 on the left, 1 over 0 on the right: no chain has either twice, yet one of them comes again.
    const FewestVisits fewest = fewestOf({{{0}, {1}, {1}, {0}}, {{}, {0}, {}, {2}}});
    EXPECT_EQ(fewest.tools.size(), 3U);
    EXPECT_EQ(fewest.at_least, 3) << "proven by the search, not by chains alone";
}

TEST(FewestVisits, AStaircaseOfTwoToolsIsCutInOnePassDownEach) {
    // 0 1 0 1 0 in one chain; a second chain 1 0 1 0 1 runs along with it.
    const FewestVisits fewest = fewestOf({{{0}, {1}, {0}, {1}, {0}, {1}, {0}, {1}, {0}, {1}},
                                          {{}, {0}, {1}, {2}, {3}, {}, {5}, {6}, {7}, {8}}});
    EXPECT_EQ(fewest.tools.size(), 6U);
}

TEST(FewestVisits, EarlyStartsLetAToolGoOn) {
    std::vector<VisitOperation> operations{{0, 0, 0, {}}, {1, 0, 0, {}}, {0, 1, 0, {}}, {1, 1, 0, {}}};
    const std::vector<VisitFeature> features{{0, {}}, {0, {0}}};
    EXPECT_EQ(fewestVisits(visitProblem(operations, features), kPlanSearch).tools.size(), 4U);
    operations[2].needs = {{0, 1}};
    EXPECT_EQ(fewestVisits(visitProblem(operations, features), kPlanSearch).tools, (std::vector<int>{0, 1}));
    operations[2].needs = {{0, 0}};
    EXPECT_EQ(fewestVisits(visitProblem(operations, features), kPlanSearch).tools, (std::vector<int>{0, 1}));
}

TEST(FewestVisits, ASetupIsDoneBeforeTheNextHoweverEarlyOperationsMayStart) {
    // In the first setup 0 over 1 over nothing; in the second 0 alone, which needs nothing of its own setup.
    const std::vector<VisitOperation> operations{
        {0, 0, 0, {}}, {1, 1, 0, {}}, {2, 2, 0, {}}, {0, 3, 0, {{2, 0}}}};
    const std::vector<VisitFeature> features{{0, {}}, {0, {0}}, {1, {}}, {1, {2}}};
    EXPECT_EQ(fewestVisits(visitProblem(operations, features), kPlanSearch).tools.size(), 4U);
}

TEST(FewestVisits, OfEqualsTheOneThatKeepsToTheStages) {
    // A hole and a face, on their own: the face is of an earlier stage.
    const std::vector<VisitOperation> operations{{0, 0, 2, {}}, {1, 1, 0, {}}};
    const std::vector<VisitFeature> features{{0, {}}, {0, {}}};
    EXPECT_EQ(fewestVisits(visitProblem(operations, features), kPlanSearch).tools, (std::vector<int>{1, 0}));
}

TEST(FewestVisits, ANarrowSearchSaysWhatIsNotProven) {
    const Drawn drawn{{{0}, {1}, {1}, {0}}, {{}, {0}, {}, {2}}};
    const FewestVisits fewest = fewestVisits(problemOf(drawn), {1, 0});
    EXPECT_EQ(fewest.tools.size(), 3U);
    EXPECT_EQ(fewest.at_least, 2);
}

TEST(VisitProblem, NeedsThatFollowFromOthersAreLeftOut) {
    const std::vector<VisitOperation> operations{{0, 0, 0, {}}, {1, 1, 0, {}}, {2, 2, 0, {{0, 1}, {1, 1}}}};
    const VisitProblem problem = visitProblem(operations, {{0, {}}, {0, {0}}, {0, {1}}});
    ASSERT_EQ(problem.operations[2].needs.size(), 1U);
    EXPECT_EQ(problem.operations[2].needs[0].feature, 1);
}

}  // namespace
}  // namespace stepmill
