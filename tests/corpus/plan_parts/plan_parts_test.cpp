// Every part of the corpus ends as expected_outcomes.json says, within its time, and the books of plans
// close.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/expected_outcomes.h"
#include "support/planned_parts.h"
#include "support/text_file.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// What is planned, what stays and what is out of reach add up to the stock less the part [features.md].
constexpr double kBooksShare = 1e-3;

/// Processor time on top of every budget [s]: starting a process, with all its libraries, takes from a tenth
/// of a second to most of one, as fast as the machine is and as busy with other tests. It says nothing of the
/// part.
constexpr double kStartS = 1.0;

/// What a plan.json of a real part stays below, in bytes.
constexpr std::uintmax_t kLargestPlan = 2'000'000;

double booksGap(const Json& books) {
    const double total = books.at("stock_minus_part_mm3");
    const double sum = books.at("planned_mm3").get<double>() + books.at("residual_mm3").get<double>() +
                       books.at("unreachable_mm3").get<double>();
    return total == 0 ? 0 : std::abs(sum - total) / total;
}

void checkPlan(const fs::path& folder) {
    EXPECT_LT(fs::file_size(folder / "plan.json"), kLargestPlan);
    const Json plan = Json::parse(slurp(folder / "plan.json"));
    EXPECT_LE(booksGap(plan.at("volume_balance")), kBooksShare);
    EXPECT_TRUE(fs::exists(folder / "report.html"));
    EXPECT_TRUE(fs::exists(folder / "sheets.html"));
    // A setup beyond the machine's travel has no program, nor has one in which nothing is cut.
    std::set<std::string> beyond_travel;
    for (const Json& warning : plan.at("warnings"))
        if (warning.at("code") == "travel") beyond_travel.insert(warning.at("subject"));
    for (const Json& setup : plan.at("setups"))
        EXPECT_EQ(fs::exists(folder / setup.at("program").get<std::string>()),
                  beyond_travel.count(setup.at("id")) == 0 && !setup.at("operations").empty());
    const Json& totals = plan.at("totals");
    EXPECT_GE(totals.at("time_s").get<double>(), totals.at("lower_bound_s").get<double>());
    const Json& books = plan.at("volume_balance");
    const double total = std::max(1e-9, books.at("stock_minus_part_mm3").get<double>());
    fmt::print("{} features, {:.1f} min of machining, {:.1f} % stays, {:.1f} % out of reach\n",
               plan.at("features").size(), totals.at("time_s").get<double>() / 60,
               100 * books.at("residual_mm3").get<double>() / total,
               100 * books.at("unreachable_mm3").get<double>() / total);
}

int exitCodeOf(Outcome outcome) {
    return outcome == Outcome::Planned ? 0 : outcome == Outcome::Gaps ? 1 : 2;
}

/// Does the plan say that time was short?
bool isShortOfTime(const Json& plan) {
    const Json& warnings = plan.at("warnings");
    if (std::any_of(warnings.begin(), warnings.end(), [](const Json& warning) {
            return warning.at("code") == "few-tools" || warning.at("code") == "time-limit";
        }))
        return true;
    const Json& reasons = plan.at("volume_balance").at("residual_by_reason");
    return std::any_of(reasons.begin(), reasons.end(),
                       [](const Json& entry) { return entry.at("reason") == "time limit"; });
}

/// Gets no plan of all its tools within its budget today. As soon as it does, its row must say so.
void expectTooSlow(const ExpectedOutcome& expected) {
    const TemporaryFolder folder;
    const fs::path out = fs::path(folder.path()) / "plan";
    const ProgramRun run = runProgram({stepmillBinary(), "plan", expected.path, "-o", out.string(),
                                       "--timeout", fmt::format("{:g}", expected.cpu_s)});
    if (run.exit_code == 1 && isShortOfTime(Json::parse(slurp(out / "plan.json")))) return;
    EXPECT_EQ(run.exit_code, 2) << "it plans now: write its outcome and processor time into the table\n"
                                << run.err;
    EXPECT_GE(run.seconds, expected.cpu_s) << "refused before its time was up: " << run.err;
    EXPECT_FALSE(fs::exists(out)) << "a half-written plan";
}

class PlanParts : public testing::TestWithParam<ExpectedOutcome> {};

TEST_P(PlanParts, EndsAsExpectedWithinItsBudget) {
    const ExpectedOutcome& expected = GetParam();
    STEPMILL_NEEDS_PART(expected);
    if (expected.outcome == Outcome::TooSlow) return expectTooSlow(expected);
    const PlannedPart planned = plannedPart(expected.path);
    fmt::print("exit {}, {:.2f} s of processor time ({:g} allowed), {:.2f} s on the clock\n{}",
               planned.run.exit_code, planned.run.cpu_s, expected.cpu_s, planned.run.seconds,
               planned.run.err);
    ASSERT_EQ(planned.run.exit_code, exitCodeOf(expected.outcome)) << planned.run.err;
    EXPECT_LE(planned.run.cpu_s, expected.cpu_s + kStartS);
    if (expected.hasPlan()) return checkPlan(planned.folder);
    EXPECT_FALSE(planned.run.err.empty()) << "refused without a reason";
    EXPECT_FALSE(fs::exists(planned.folder)) << "a half-written plan";
}

std::vector<ExpectedOutcome> quickOutcomes() {
    std::vector<ExpectedOutcome> rows = expectedOutcomes();
    std::erase_if(rows, [](const ExpectedOutcome& row) { return row.slow; });
    return rows;
}

const auto kPartName = [](const auto& row) { return testName(row.param); };

INSTANTIATE_TEST_SUITE_P(Corpus, PlanParts, testing::ValuesIn(quickOutcomes()), kPartName);
INSTANTIATE_TEST_SUITE_P(Slow, PlanParts, testing::ValuesIn(slowPlans()), kPartName);

TEST(ExpectedOutcomes, HaveARowForEveryPart) {
    std::set<std::string> rows;
    for (const ExpectedOutcome& expected : expectedOutcomes())
        rows.insert(expected.part);
    std::vector<std::string> parts = sampleParts();
    for (const char* folder : {"machined", "nist", "bad", "random"})
        for (const std::string& part : sharedParts(folder))
            parts.push_back(part);
    for (const fs::path part : parts) {
        const std::string name = (part.parent_path().filename() / part.filename()).string();
        EXPECT_TRUE(rows.contains(name)) << name << ": add a row to tests/corpus/expected_outcomes.json";
    }
}

TEST(ExpectedOutcomes, NameOnlyPartsThatAreThere) {
    for (const ExpectedOutcome& expected : expectedOutcomes()) {
        const bool folder_missing = folderOfParts(fs::path(expected.part).parent_path()).empty();
        EXPECT_TRUE(folder_missing || !expected.path.empty()) << expected.part;
    }
}

}  // namespace
}  // namespace stepmill::test
