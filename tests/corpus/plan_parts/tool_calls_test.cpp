// Tools are called as rarely as the order of features allows.

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include <nlohmann/json.hpp>

#include "support/expected_outcomes.h"
#include "support/planned_parts.h"
#include "support/text_file.h"

namespace stepmill::test {
namespace {

using Json = nlohmann::json;

/// A part with what a setter expects of its tool changes.
struct ToolCalls {
    const char* part;
    int most_changes;       ///< of the whole plan
    int most_called_again;  ///< tools beyond the first call in their setup
};

/// Tools of all setups that are put in again after another one.
int calledAgain(const Json& plan) {
    int again = 0;
    std::string setup;
    std::string tool;
    std::set<std::string> called;
    for (const Json& operation : plan.at("operations")) {
        if (operation.at("setup") != setup) {
            setup = operation.at("setup");
            tool.clear();
            called.clear();
        }
        const std::string own = operation.at("tool");
        if (own == tool) continue;
        again += called.insert(own).second ? 0 : 1;
        tool = own;
    }
    return again;
}

class ToolCallsOfPart : public testing::TestWithParam<ToolCalls> {};

TEST_P(ToolCallsOfPart, AreFew) {
    const ToolCalls& expected = GetParam();
    const std::filesystem::path part = expected.part;
    const std::filesystem::path folder = folderOfParts(part.parent_path());
    if (folder.empty()) GTEST_SKIP() << "the folder of STEP parts is not beside this checkout";
    const PlannedPart planned = plannedPart((folder / part.filename()).string());
    const Json plan = Json::parse(slurp(planned.folder / "plan.json"));
    EXPECT_LE(plan.at("totals").at("tool_changes").get<int>(), expected.most_changes);
    EXPECT_LE(calledAgain(plan), expected.most_called_again);
}

// All tools of hole_model are called once a setup, but for the one whose slot waits for the ground in it. Of
// plate_with_holes one call more saves four seconds of cutting; a mill that gehause_rohteil calls again,
// below what is cut to a depth before, saves another tool.
INSTANTIATE_TEST_SUITE_P(Corpus, ToolCallsOfPart,
                         testing::Values(ToolCalls{"machined/hole_model.stp", 15, 1},
                                         ToolCalls{"machined/isolated_blends_test_09.stp", 5, 0},
                                         ToolCalls{"machined/nist_d2mi_827-9999-904.stp", 11, 1},
                                         ToolCalls{"machined/gehause_rohteil.stp", 13, 1},
                                         ToolCalls{"step_parts/plate_with_holes.step", 7, 0}),
                         [](const auto& row) {
                             ExpectedOutcome named;
                             named.part = row.param.part;
                             return testName(named);
                         });

}  // namespace
}  // namespace stepmill::test
