// What the program says of every sample part, compared as text. `make golden` writes it anew; review the
// diff.

#include <gtest/gtest.h>

#include <regex>

#include "support/expected_outcomes.h"
#include "support/golden.h"
#include "support/page_text.h"
#include "support/planned_parts.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;

class GoldenPlan : public testing::TestWithParam<ExpectedOutcome> {
  protected:
    // A part that has no plan, or gets one it did not get before, is no golden's matter.
    void SetUp() override {
        planned_ = plannedPart(GetParam().path);
        ASSERT_EQ(planned_.run.exit_code, GetParam().outcome == Outcome::Planned ? 0 : 1) << planned_.run.err;
    }

    std::string stem() const { return fs::path(GetParam().part).stem(); }

    PlannedPart planned_;
};

TEST_P(GoldenPlan, HasItsSummary) {
    const std::string& out = planned_.run.out;
    expectGolden("summaries/" + stem() + ".txt", out.substr(0, out.find("\nReport:")));
}

/// Few, since people review them: one setup and two steps; several setups with pockets, holes and a slot.
using GoldenFiles = GoldenPlan;

TEST_P(GoldenFiles, HoldItsPlan) {
    const std::regex version(R"("stepmill": \{"version":"[^"]*"\})");
    expectGolden("plans/" + stem() + ".json", std::regex_replace(slurp(planned_.folder / "plan.json"),
                                                                 version, R"("stepmill": {"version":"*"})"));
}

TEST_P(GoldenFiles, HoldWhatItsReportSays) {
    expectGolden("reports/" + stem() + ".txt", pageText(slurp(planned_.folder / "report.html")));
}

TEST_P(GoldenFiles, HoldWhatItsSheetsSay) {
    expectGolden("sheets/" + stem() + ".txt", pageText(slurp(planned_.folder / "sheets.html")));
}

std::vector<ExpectedOutcome> fewParts() {
    std::vector<ExpectedOutcome> few = expectedOf("step_parts");
    std::erase_if(few, [](const ExpectedOutcome& row) {
        return row.part != "step_parts/shoulder_block.step" && row.part != "step_parts/four_setups.step";
    });
    return few;
}

const auto kPartName = [](const auto& row) { return testName(row.param); };

INSTANTIATE_TEST_SUITE_P(FewParts, GoldenFiles, testing::ValuesIn(fewParts()), kPartName);
INSTANTIATE_TEST_SUITE_P(SampleParts, GoldenPlan, testing::ValuesIn(expectedOf("step_parts")), kPartName);

}  // namespace
}  // namespace stepmill::test
