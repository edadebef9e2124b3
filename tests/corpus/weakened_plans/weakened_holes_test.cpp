// A plan that was made by a weaker hole table than the one it says: programs and plan.json agree, so nothing
// but the table itself tells. With the table verify catches what is missing.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <vector>

#include <nlohmann/json.hpp>

#include "stepmill/core/file.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const std::string kSource = STEPMILL_SOURCE_DIR;
const std::string kPart = kSource + "/step_parts/plate_with_holes.step";
const std::string kTools = kSource + "/samples/shop_with_taps_tools.json";

Json holesOf(double diameter_mm, const Json& what) {
    Json entry{{"diameter", {{"min", diameter_mm - 0.1}, {"max", diameter_mm + 0.1}}}};
    entry.update(what);
    return entry;
}

/// What is asked for: two threads, holes that are drilled alone, holes that are left.
Json wantedEntries() {
    return {holesOf(6.8, {{"make", "tap"}, {"thread", "M8"}}),
            holesOf(8.5, {{"make", "tap"}, {"thread", "M10"}, {"thread_depth", 8}}),
            holesOf(5, {{"make", "leave"}})};
}

struct WeakerTable {
    std::string name;
    Json entries;
    std::string said;  ///< what verify says of it
};

void PrintTo(const WeakerTable& table, std::ostream* out) {
    *out << table.name;
}

std::vector<WeakerTable> weakerTables() {
    const Json all = wantedEntries();
    Json shallow = all[1];
    shallow["thread_depth"] = 6;
    Json short_through = all[0];
    short_through["thread_depth"] = 5;
    return {{"no thread of one kind", {all[0], all[2]}, "4 holes have none"},
            {"no thread at all", {all[2]}, "10 holes have none"},
            {"a thread that is too short", {all[0], shallow, all[2]}, "its thread ends at"},
            {"a thread that is not through", {short_through, all[1], all[2]}, "its thread ends at"},
            {"holes that are cut", {all[0], all[1]}, "cuts a hole that the hole table leaves: #/holes/2"}};
}

/// A job folder of the test's own, with its tables beside it.
class HoleClaim : public testing::Test {
  protected:
    fs::path file(const std::string& name) const { return fs::path(folder_.path()) / name; }

    void writeTable(const std::string& name, const Json& entries) const {
        std::ofstream(file(name)) << Json{{"format", 1}, {"unit", "mm"}, {"holes", entries}}.dump(1);
    }

    Json planWith(const std::string& table) const {
        const ProgramRun run = runProgram({stepmillBinary(), "plan", kPart, "-o", file("job").string(),
                                           "--tools", kTools, "--holes", file(table).string()});
        EXPECT_LE(run.exit_code, 1) << run.err;
        return Json::parse(readFile(file("job") / "plan.json"));
    }

    /// Who edits a plan writes its manifest anew, or takes it away.
    void replacePlan(const Json& plan) const {
        std::ofstream(file("job") / "plan.json", std::ios::binary) << plan.dump();
        fs::remove(file("job") / "manifest.json");
    }

    ProgramRun verify(const std::vector<std::string>& more) const {
        std::vector<std::string> words{stepmillBinary(), "verify", file("job").string(), "--part", kPart,
                                       "--tools",        kTools};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words);
    }

    TemporaryFolder folder_;
};

class WeakenedHoles : public HoleClaim, public testing::WithParamInterface<WeakerTable> {};

TEST_P(WeakenedHoles, AreCaughtByTheTableThatWasAskedFor) {
    writeTable("wanted.json", wantedEntries());
    writeTable("weaker.json", GetParam().entries);
    Json plan = planWith("weaker.json");
    const ProgramRun honest = verify({"--holes", file("weaker.json").string()});
    ASSERT_LE(honest.exit_code, 1) << honest.out << honest.err;
    plan["request"]["holes"] = {{"file", "wanted.json"}, {"sha256", sha256(readFile(file("wanted.json")))}};
    replacePlan(plan);
    const ProgramRun run = verify({"--holes", file("wanted.json").string()});
    EXPECT_GT(run.exit_code, 1) << run.out << run.err;
    EXPECT_NE(run.out.find(GetParam().said), std::string::npos) << run.out << run.err;
}

INSTANTIATE_TEST_SUITE_P(All, WeakenedHoles, testing::ValuesIn(weakerTables()));

TEST_F(HoleClaim, NeedsTheTableThatThePlanNames) {
    writeTable("wanted.json", wantedEntries());
    Json plan = planWith("wanted.json");
    const ProgramRun proven = verify({"--holes", file("wanted.json").string()});
    EXPECT_EQ(proven.exit_code, 0) << proven.out << proven.err;
    const ProgramRun without = verify({});
    EXPECT_EQ(without.exit_code, 2) << without.out;
    EXPECT_NE(without.err.find("--holes"), std::string::npos) << without.err;
    plan["request"].erase("holes");
    replacePlan(plan);
    EXPECT_EQ(verify({"--holes", file("wanted.json").string()}).exit_code, 2);
    const ProgramRun unasked = verify({});
    EXPECT_EQ(unasked.exit_code, 2) << unasked.out;
    EXPECT_NE(unasked.out.find("which the hole table does not ask for"), std::string::npos) << unasked.out;
}

/// Threads that no tap of the library cuts are a gap that the plan names: no more of them, and no fewer.
TEST_F(HoleClaim, CountsTheThreadsThatThePlanSaysItLacks) {
    Json entries = wantedEntries();
    entries[0]["thread"] = "M8x1";  // the hole is no core of it
    writeTable("wanted.json", entries);
    Json plan = planWith("wanted.json");
    ASSERT_EQ(plan["threads_missing"], 6);
    const std::vector<std::string> table{"--holes", file("wanted.json").string()};
    const ProgramRun run = verify(table);
    EXPECT_EQ(run.exit_code, 1) << run.out << run.err;
    EXPECT_NE(run.out.find("no thread or fit, as the plan says: 6 holes"), std::string::npos) << run.out;
    plan["threads_missing"] = 5;
    replacePlan(plan);
    EXPECT_EQ(verify(table).exit_code, 2);
    plan.erase("threads_missing");
    replacePlan(plan);
    EXPECT_EQ(verify(table).exit_code, 2);
}

}  // namespace
}  // namespace stepmill::test
