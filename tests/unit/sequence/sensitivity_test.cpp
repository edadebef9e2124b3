#include "stepmill/sequence/advice/sensitivity.h"

#include <gtest/gtest.h>

#include "support/sample_feature.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

using test::kTol;

DagEdge edge(const std::string& from, const std::string& to, double feed_time_s) {
    DagEdge result;
    result.from.tool = from;
    result.to.tool = to;
    result.totals.feed_time_s = feed_time_s;
    return result;
}

/// Alone EM6 needs 100 s; after EM12's 20 s it needs 30.
std::vector<DagEdge> twoTools() {
    return {edge("", "EM12", 20), edge("", "EM6", 100), edge("EM12", "EM6", 30), edge("EM6", "", 0)};
}

ToolLibrary twoMills() {
    ToolLibrary library = makeLibrary({makeMill(12), makeMill(6)});
    library.tools[0].price = 100;
    library.tools[0].life_min = 10;
    library.tools[1].price = 10;
    library.tools[1].life_min = 10;
    return library;
}

TEST(Sensitivity, ToolChangeTimeHasItsExactBreakEven) {
    const auto ranges = bestSequences(
        cheapestOverEdges(twoTools(), twoMills(), makeMachine(), Parameter::ToolChange, Objective::Time));
    ASSERT_EQ(ranges.size(), 2u);
    EXPECT_EQ(ranges[0].line.tools, (std::vector<std::string>{"EM12", "EM6"}));
    EXPECT_EQ(ranges[1].line.tools, (std::vector<std::string>{"EM6"}));
    // 50 + 2 t = 100 + t
    EXPECT_DOUBLE_EQ(ranges[0].to, 50);
    EXPECT_DOUBLE_EQ(ranges[1].from, 50);
    EXPECT_TRUE(std::isinf(ranges[1].to));
}

TEST(Sensitivity, DearToolsGiveWayToTime) {
    // 5 s a change. EM12 > EM6: 60 s; wear 20/600 x 100 + 30/600 x 10. EM6: 105 s; wear 100/600 x 10.
    const auto by_rate = bestSequences(
        cheapestOverEdges(twoTools(), twoMills(), makeMachine(), Parameter::HourlyRate, Objective::Time));
    ASSERT_EQ(by_rate.size(), 2u);
    EXPECT_EQ(by_rate[0].line.tools, (std::vector<std::string>{"EM6"}));
    const double wear_gap = 20.0 / 6 + 0.5 - 10.0 / 6;
    EXPECT_NEAR(by_rate[0].to, wear_gap / (45.0 / 3600), 1e-9);

    const auto by_price = bestSequences(
        cheapestOverEdges(twoTools(), twoMills(), makeMachine(), Parameter::ToolPrice, Objective::Time));
    ASSERT_EQ(by_price.size(), 2u);
    EXPECT_EQ(by_price[1].line.tools, (std::vector<std::string>{"EM6"}));
    EXPECT_NEAR(by_price[0].to, 45.0 / 3600 * 60 / wear_gap, 1e-9);
}

TEST(Sensitivity, CountsTheSurrogatesOfAnEdgeInTimeAndMoney) {
    std::vector<DagEdge> edges = twoTools();
    PathTotals helped;
    helped.feed_time_s = 60;
    for (DagEdge& edge : edges)
        if (edge.from.empty() && edge.to.tool == "EM6") edge.surrogates.push_back({"EM12", 1, helped});
    // EM6 alone takes 160 s with its surrogate and two changes, EM12 > EM6 50 s and as many.
    const auto by_change = bestSequences(
        cheapestOverEdges(edges, twoMills(), makeMachine(), Parameter::ToolChange, Objective::Time));
    ASSERT_EQ(by_change.size(), 1u);
    EXPECT_EQ(by_change[0].line.tools, (std::vector<std::string>{"EM12", "EM6"}));
    // In wear alone 100/600 x 10 + 60/600 x 100 against 20/600 x 100 + 30/600 x 10.
    const auto by_rate = bestSequences(
        cheapestOverEdges(edges, twoMills(), makeMachine(), Parameter::HourlyRate, Objective::Cost));
    ASSERT_EQ(by_rate.size(), 1u);
    EXPECT_NEAR(by_rate[0].line.fixed, 20.0 / 6 + 0.5, 1e-9);
}

TEST(Sensitivity, OfNothingMachinedIsOneRangeWithoutTools) {
    const auto ranges = bestSequences(
        cheapestOverEdges({}, twoMills(), makeMachine(), Parameter::ToolChange, Objective::Time));
    ASSERT_EQ(ranges.size(), 1u);
    EXPECT_TRUE(ranges[0].line.tools.empty());
    EXPECT_TRUE(std::isinf(ranges[0].to));
}

TEST(Sensitivity, AParameterThatChangesNothingHasOneRange) {
    const CheapestAt flat = [](double) { return CostLine{5, 0, {"EM6"}}; };
    ASSERT_EQ(bestSequences(flat).size(), 1u);
}

TEST(Sensitivity, BySequencingAgreesWithThePlanAtEveryValue) {
    const Feature pocket = makeIslandPocket();
    const ToolLibrary library = makeLibrary({makeMill(20), makeMill(12), makeMill(6)});
    const Machine machine = makeMachine();
    const SequenceOptions options = inAluminium();
    const auto ranges =
        bestSequences(cheapestBySequencing(pocket, library, machine, options, kTol, Parameter::ToolChange));
    EXPECT_GE(ranges.size(), 2u);
    for (const double change_s : {0.0, 1.0, 5.0, 20.0, 100.0, 1000.0}) {
        Machine at = machine;
        at.tool_change_s = change_s;
        const ToolSequence sequence = sequenceTools(pocket, library, at, options, kTol);
        const auto range = std::find_if(ranges.begin(), ranges.end(), [&](const BestSequence& candidate) {
            return candidate.from <= change_s && change_s < candidate.to;
        });
        EXPECT_NEAR(range->line.at(change_s), sequence.time_s, 1e-6) << change_s;
    }
}

}  // namespace
}  // namespace stepmill::test
