// Every file of the collection of ill-formed and unwelcome STEP files ends as its README asks: refused with
// a reason or loaded, never a crash, never a hang.

#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "stepmill/core/error.h"
#include "stepmill/core/supervise.h"
#include "stepmill/part/part.h"
#include "support/expected_outcomes.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;

constexpr double kTimeLimit_s = 60;
constexpr int kLoaded = 100;   // exit code of the child: plus the number of solids
constexpr int kRefused = 200;  // plus the error code

/// Reads the file in a child, which prints the table's row and encodes the outcome in its exit code.
Supervised readSupervised(const fs::path& path) {
    return runSupervised(
        [&](StageBoard& stage) {
            stage.set("reading " + path.filename().string());
            try {
                int solids = 0;
                std::string names;
                for (const Part& part : readStep(path)) {
                    solids += part.count;
                    names += fmt::format("{} x {}, {:.6g} mm3; ", part.count, part.name, part.volume_mm3);
                    for (const Remark& remark : part.remarks)
                        names += "(" + remark.text + ") ";
                }
                fmt::print("| {:<30} | loaded  | {}|\n", path.filename().string(), names);
                return kLoaded + solids;
            } catch (const Error& error) {
                fmt::print("| {:<30} | refused | {} |\n", path.filename().string(), error.what());
                return kRefused + static_cast<int>(error.code());
            }
        },
        kTimeLimit_s);
}

class BadParts : public testing::TestWithParam<test::ExpectedOutcome> {};

TEST_P(BadParts, IsRefusedWithAReasonOrLoadedAsItsReadmeAsks) {
    const test::ExpectedOutcome& expected = GetParam();
    STEPMILL_NEEDS_PART(expected);
    const Supervised run = readSupervised(expected.path);
    ASSERT_EQ(run.end, Supervised::End::Exited) << run.last_stage << ", signal " << run.signal;
    const int wanted =
        expected.refusal ? kRefused + static_cast<int>(*expected.refusal) : kLoaded + expected.solids;
    EXPECT_EQ(run.exit_code, wanted);
}

INSTANTIATE_TEST_SUITE_P(Corpus, BadParts, testing::ValuesIn(test::expectedOf("bad")),
                         [](const auto& row) { return test::testName(row.param); });

}  // namespace
}  // namespace stepmill
