#include <gtest/gtest.h>

#include "bossed_tasks.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

using test::kTol;

/// Tools in the order of their visits.
std::vector<std::string> visitsOf(const ToolSequence& sequence) {
    std::vector<std::string> visits;
    for (const SequenceStep& step : sequence.steps)
        if (visits.empty() || visits.back() != step.tool_id) visits.push_back(step.tool_id);
    return visits;
}

TEST(ChoicesLaw, EveryChoiceIsWhatItSaysAndLeavesTheSame) {
    int others = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        std::mt19937 random(seed);
        const Feature feature = randomBossedPocket(random);
        const ToolLibrary library = randomHeldTools(random);
        const Machine machine = makeMachine();
        const SequenceOptions options = randomOptions(seed);
        const ToolSequence sequence = sequenceTools(feature, library, machine, options, kTol);
        const std::vector<SequenceChoice> choices = choicesOf(sequence);
        ASSERT_EQ(choices.empty(), sequence.steps.empty());
        const bool by_time = options.objective == Objective::Time;
        const double change =
            by_time ? machine.tool_change_s : machine.tool_change_s / 3600 * machine.hourly_rate;
        for (std::size_t i = 0; i < choices.size(); ++i) {
            const ToolSequence made = withChoice(sequence, i);
            const double weight = by_time ? made.time_s : made.cost;
            EXPECT_EQ(visitsOf(made), choices[i].tools) << "seed " << seed;
            // Steps are made with the quickest patterns, choices weighed with one.
            const auto weighed = [&](const SequenceChoice& choice) {
                return choice.paths + change * static_cast<double>(choice.tools.size());
            };
            EXPECT_LE(weight, weighed(choices[i]) * (1 + 1e-6)) << "seed " << seed;
            EXPECT_GE(weighed(choices[i]), weighed(choices[0]) * (1 - 1e-9)) << "seed " << seed;
            std::vector<Region> done;
            for (const SequenceStep& step : made.steps)
                done.push_back(step.area.area);
            for (const Residual& residual : made.residual)
                done.push_back(residual.region);
            if (made.floor_z_mm == feature.floor_z_mm) {
                EXPECT_LE(area(subtract(feature.target, unite(done, kTol), kTol)), 1e-4 * feature.area_mm2)
                    << "seed " << seed;
            }
        }
        others += static_cast<int>(choices.size()) - (choices.empty() ? 0 : 1);
    }
    EXPECT_GE(others, 20) << "there should be something to choose from";
}

}  // namespace
}  // namespace stepmill::test
