// Every part gets a plan or a refusal with a reason: none crashes, none hangs, the books close.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// No part may take longer. Castings and sheet metal of hundreds of free-form faces do not get ready in it
/// and end with that reason.
constexpr int kTimeLimitS = 12;
/// algorithms.md, section 2.
constexpr double kBooksShare = 1e-3;

Json readJson(const fs::path& path) {
    std::ifstream file(path);
    return Json::parse(file);
}

double booksGap(const Json& plan) {
    const Json& books = plan.at("volume_balance");
    const double total = books.at("stock_minus_part_mm3");
    const double sum = books.at("planned_mm3").get<double>() + books.at("residual_mm3").get<double>() +
                       books.at("unreachable_mm3").get<double>();
    return total == 0 ? 0 : std::abs(sum - total) / total;
}

std::string firstLine(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

void checkPlan(const std::string& part, const fs::path& folder, std::string& row) {
    const Json plan = readJson(folder / "plan.json");
    const double gap = booksGap(plan);
    EXPECT_LE(gap, kBooksShare) << part;
    EXPECT_TRUE(fs::exists(folder / "report.html")) << part;
    for (const Json& setup : plan.at("setups"))
        EXPECT_TRUE(fs::exists(folder / setup.at("program").get<std::string>())) << part;
    const Json& totals = plan.at("totals");
    EXPECT_GE(totals.at("time_s").get<double>(), totals.at("lower_bound_s").get<double>()) << part;
    const Json& books = plan.at("volume_balance");
    const double total = std::max(1e-9, books.at("stock_minus_part_mm3").get<double>());
    row += fmt::format(" {:>8} {:>9.1f} min {:>8.1f} {:>8.1f} {:>9.1e}", plan.at("features").size(),
                       totals.at("time_s").get<double>() / 60,
                       100 * books.at("residual_mm3").get<double>() / total,
                       100 * books.at("unreachable_mm3").get<double>() / total, gap);
}

void planAll(const std::vector<std::string>& parts) {
    if (parts.empty()) GTEST_SKIP() << "the folder of STEP parts is not beside this checkout";
    fmt::print("{:<38} {:<8} {:>7} {:>8} {:>13} {:>8} {:>8} {:>9}\n", "part", "outcome", "s", "features",
               "machining", "stays %", "unreach %", "books");
    for (const std::string& part : parts) {
        const TemporaryFolder folder;
        const fs::path out = fs::path(folder.path()) / "plan";
        const ProgramRun run = runProgram(
            {stepmillBinary(), "plan", part, "-o", out.string(), "--timeout", std::to_string(kTimeLimitS)});
        const std::string name = fs::path(part).filename().string();
        std::string row = fmt::format("{:<38} {:<8} {:>7.2f}", name,
                                      run.exit_code == 0   ? "plan"
                                      : run.exit_code == 1 ? "gaps"
                                                           : fmt::format("exit {}", run.exit_code),
                                      run.seconds);
        if (run.exit_code == 0 || run.exit_code == 1)
            checkPlan(name, out, row);
        else
            row += "  " + firstLine(run.err);
        fmt::print("{}\n", row);
        std::fflush(stdout);
        EXPECT_TRUE(run.exit_code >= 0 && run.exit_code <= 2) << name << ": " << run.err;
        EXPECT_FALSE(run.exit_code == 2 && run.err.empty()) << name << " refused without a reason";
        EXPECT_FALSE(run.exit_code == 2 && fs::exists(out)) << name << " left a half-written plan";
    }
}

TEST(PlanParts, EverySamplePartGetsAPlan) {
    planAll(sampleParts());
}

TEST(PlanParts, EveryMachinedPartGetsAPlanOrAReason) {
    planAll(sharedParts("machined"));
}

TEST(PlanParts, EveryNistPartGetsAPlanOrAReason) {
    planAll(sharedParts("nist"));
}

TEST(PlanParts, BadFilesEndWithAPlainMessageAndNoPlan) {
    const std::vector<std::string> parts = sharedParts("bad");
    if (parts.empty()) GTEST_SKIP() << "the folder of STEP parts is not beside this checkout";
    for (const std::string& part : parts) {
        const TemporaryFolder folder;
        const fs::path out = fs::path(folder.path()) / "plan";
        const ProgramRun run =
            runProgram({stepmillBinary(), "plan", part, "-o", out.string(), "--timeout", "60"});
        const std::string name = fs::path(part).filename().string();
        fmt::print("{:<34} exit {} {:>6.2f} s  {}\n", name, run.exit_code, run.seconds, firstLine(run.err));
        std::fflush(stdout);
        if (name == "crlf_and_comments.stp") {
            EXPECT_LE(run.exit_code, 1) << run.err;
            EXPECT_TRUE(fs::exists(out / "plan.json"));
            continue;
        }
        EXPECT_TRUE(run.exit_code == 1 || run.exit_code == 2) << name << ": " << run.err;
        EXPECT_EQ(run.exit_code == 1, fs::exists(out / "plan.json")) << name;
    }
}

}  // namespace
}  // namespace stepmill::test
