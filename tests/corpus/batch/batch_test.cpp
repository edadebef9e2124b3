// Batches of the program itself: outcomes of all kinds, kills and what resumes them, two at once, limits.

#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <thread>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stepmill/batch/ledger.h"
#include "support/expected_outcomes.h"
#include "support/run_program.h"
#include "support/text_file.h"
#include "support/told.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using Json = nlohmann::json;

const std::string kSource = STEPMILL_SOURCE_DIR;

class Batches : public testing::Test {
  protected:
    Batches() { fs::create_directory(parts_); }

    /// A copy of a sample part.
    void part(const std::string& name, const std::string& sample = "shoulder_block") const {
        fs::create_directories((parts_ / name).parent_path());
        fs::copy_file(kSource + "/step_parts/" + sample + ".step", parts_ / name);
    }
    void noise(const std::string& name) const { std::ofstream(parts_ / name) << "ISO-no-10303"; }

    static Words words(Words more) {
        more.insert(more.begin(), {stepmillBinary(), "batch"});
        return more;
    }
    ProgramRun batch(const Words& more = {}) const {
        Words all{parts_.string(), "-o", out_.string()};
        all.insert(all.end(), more.begin(), more.end());
        return runProgram(words(all));
    }
    ProgramRun status() const { return runProgram(words({"--status", out_.string()})); }

    /// Starts a batch whose end is not awaited.
    static pid_t start(Words all) { return startProgram(words(std::move(all))); }
    static void killAndWait(pid_t child) {
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
    }

    /// By part: outcome and job of the ledger.
    static std::map<std::string, BatchJob> entries(const fs::path& out) {
        const Ledger ledger = Ledger::forReading(out / "ledger.sqlite");
        const std::map<std::string, BatchJob> jobs = ledger.jobs();
        std::map<std::string, BatchJob> entries;
        for (const LedgerPart& part : ledger.parts())
            entries[part.name] = part.key.empty() ? BatchJob{} : jobs.at(part.key);
        return entries;
    }
    std::string outcome(const std::string& part) const { return toString(entries(out_).at(part).outcome); }

    /// All that must not depend on how often a batch was killed: of the ledger all but times.
    static std::map<std::string, std::string> bytes(const fs::path& out) {
        std::map<std::string, std::string> bytes;
        for (const auto& entry : fs::recursive_directory_iterator(out))
            if (entry.is_regular_file() && !entry.path().filename().string().starts_with("ledger."))
                bytes[entry.path().lexically_relative(out).string()] = slurp(entry.path());
        for (const auto& [name, job] : entries(out))
            bytes["ledger " + name] = job.key.text() + job.folder + toString(job.outcome) +
                                      std::to_string(job.exit_code) + job.message + job.figures;
        return bytes;
    }

    TemporaryFolder folder_;
    fs::path parts_ = fs::path(folder_.path()) / "parts";
    fs::path out_ = fs::path(folder_.path()) / "out";
};

TEST_F(Batches, PlansEachPartByItselfAndNamesWhatCameOfIt) {
    part("block.step");
    part("sub/slots.STP", "open_slots");
    part("sub/again.step");
    part("die.step", "die_cavity");
    noise("noise.step");
    const ProgramRun run = batch();
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_EQ(outcome("block.step"), "complete");
    EXPECT_EQ(outcome("sub/slots.STP"), "complete");
    EXPECT_EQ(outcome("die.step"), "gaps");
    EXPECT_EQ(outcome("noise.step"), "refused");
    EXPECT_TRUE(tells(run.out, {"5 parts", "3 complete", "1 gaps", "1 refused"}));
    EXPECT_TRUE(tells(run.out, {"/5", "complete", "sub/again.step"})) << "a line a part";
    EXPECT_TRUE(tells(status().out, {"noise.step", "refused", "STEP"}));
    EXPECT_TRUE(tells(slurp(out_ / "parts.csv"), {"die.step", "gaps", "cm3"}));
    EXPECT_TRUE(tells(slurp(out_ / "tools.csv"), {"EM"}));
    EXPECT_NE(slurp(out_ / "index.html").find("sub/slots.STP"), std::string::npos);
    for (const auto& [name, job] : entries(out_))
        if (name != "noise.step") {
            const ProgramRun verified =
                runProgram({stepmillBinary(), "verify", (out_ / "jobs" / job.folder).string()});
            EXPECT_EQ(verified.exit_code, job.exit_code) << name;
        }
}

TEST_F(Batches, TheSameContentIsPlannedOnce) {
    part("a.step");
    part("z/b.step");
    batch();
    const auto all = entries(out_);
    EXPECT_EQ(all.at("a.step").folder, all.at("z/b.step").folder);
    EXPECT_EQ(std::distance(fs::directory_iterator(out_ / "jobs"), {}), 1);
}

TEST_F(Batches, AHangTheMemoryACrashAndALostFileHarmNoOther) {
    for (const char* sample : {"shoulder_block", "open_slots", "rounded_pocket", "nested_pockets"})
        part(std::string(sample) + ".step", sample);
    fs::create_symlink(parts_ / "nowhere", parts_ / "lost.step");
    const ProgramRun run =
        batch({"--timeout", "10", "--memory", "0.5", "--fault", "shoulder_block.step:hang", "--fault",
               "open_slots.step:memory", "--fault", "nested_pockets.step:crash"});
    EXPECT_EQ(run.exit_code, 3) << run.err;
    EXPECT_EQ(outcome("shoulder_block.step"), "timed-out");
    EXPECT_EQ(outcome("open_slots.step"), "memory");
    EXPECT_EQ(outcome("nested_pockets.step"), "bug");
    EXPECT_EQ(outcome("rounded_pocket.step"), "complete");
    const std::string told = status().out;
    EXPECT_TRUE(tells(told, {"shoulder_block.step", "10 s", "--timeout"}));
    EXPECT_TRUE(tells(told, {"open_slots.step", "0.5 GB", "--memory"}));
    EXPECT_TRUE(tells(told, {"nested_pockets.step", "signal 11"}));
    EXPECT_TRUE(tells(told, {"lost.step", "missing"}));

    EXPECT_EQ(batch({"--resume"}).exit_code, 3) << "limits and bugs are not tried again";
    part("found.step", "four_setups");
    fs::remove(parts_ / "lost.step");
    EXPECT_EQ(batch({"--retry"}).exit_code, 0);
    EXPECT_EQ(entries(out_).at("shoulder_block.step").tries, 2);
    EXPECT_EQ(entries(out_).at("rounded_pocket.step").tries, 1);
}

TEST_F(Batches, KilledAtAnyMomentItEndsAsIfItHadNotBeen) {
    int copies = 0;
    for (const char* sample :
         {"shoulder_block", "open_slots", "rounded_pocket", "nested_pockets", "four_setups"})
        part(std::string(sample) + "-" + std::to_string(++copies) + ".step", sample);
    noise("noise.step");
    const fs::path whole = fs::path(folder_.path()) / "whole";
    EXPECT_EQ(runProgram(words({parts_.string(), "-o", whole.string()})).exit_code, 1);
    for (const int wait_ms : {20, 150, 300, 450, 700, 1100}) {
        const pid_t run = start({parts_.string(), "-o", out_.string(), "--resume"});
        std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
        killAndWait(run);
    }
    EXPECT_EQ(batch({"--resume"}).exit_code, 1);
    EXPECT_EQ(bytes(out_), bytes(whole));
}

TEST_F(Batches, WhatIsPlannedIsNotPlannedAgainUnlessItChanged) {
    part("a.step");
    part("b.step", "open_slots");
    batch();
    EXPECT_FALSE(tells(batch({"--resume"}).out, {"a.step"})) << "nothing to do";
    EXPECT_FALSE(tells(batch({"--resume", "--material", "aluminium"}).out, {"a.step"}))
        << "the default, said";
    fs::remove(parts_ / "a.step");
    part("a.step", "rounded_pocket");
    const ProgramRun changed = batch({"--resume"});
    EXPECT_TRUE(tells(changed.out, {"1/1", "a.step"})) << changed.out;
    EXPECT_TRUE(tells(batch({"--resume", "--material", "steel"}).out, {"2/2"}));
    EXPECT_TRUE(tells(batch({"--resume"}).out, {"2/2"})) << "its folder had the plan in steel";
    fs::remove_all(out_ / "jobs");
    EXPECT_TRUE(tells(batch({"--resume"}).out, {"2/2"})) << "plans that are gone";
}

TEST_F(Batches, AnotherBatchInItsFolderIsRefused) {
    part("a.step");
    const pid_t first =
        start({parts_.string(), "-o", out_.string(), "--fault", "a.step:hang", "--timeout", "60"});
    while (!fs::exists(out_ / "jobs"))
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const ProgramRun second = batch({"--resume"});
    EXPECT_EQ(second.exit_code, 2);
    EXPECT_TRUE(tells(second.err, {"out", "another run"}));
    EXPECT_TRUE(tells(status().out, {"1 waiting"}));
    killAndWait(first);
    EXPECT_EQ(batch({"--resume"}).exit_code, 0);
    const ProgramRun third = batch();
    EXPECT_EQ(third.exit_code, 2);
    EXPECT_TRUE(tells(third.err, {"holds a batch", "--resume"}));
}

TEST_F(Batches, ASignalStopsItAndSaysHowToGoOn) {
    part("a.step");
    const pid_t run = start({parts_.string(), "-o", out_.string(), "--fault", "a.step:hang"});
    while (!fs::exists(out_ / "jobs"))
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    kill(run, SIGTERM);
    int state = 0;
    waitpid(run, &state, 0);
    EXPECT_TRUE(WIFSIGNALED(state));
    EXPECT_EQ(batch({"--resume"}).exit_code, 0);
}

TEST_F(Batches, AListGivesPartsOptionsOfTheirOwn) {
    part("a.step");
    const fs::path list = parts_ / "orders.csv";
    std::ofstream(list) << "file,quantity,due,material,options\n"
                           "a.step,10,2026-12-01,,\n"
                           "a.step,5,,steel,\n"
                           "a.step,1,,,\"--setup +z --stock-margin 1,1,0\"\n"
                           "gone.step,1,,,\n";
    const ProgramRun run = runProgram(words({list.string(), "-o", out_.string()}));
    EXPECT_EQ(run.exit_code, 1) << run.err;
    const std::string table = slurp(out_ / "parts.csv");
    EXPECT_TRUE(tells(table, {"a.step", ",10,2026-12-01", "complete", "aluminium"}));
    EXPECT_TRUE(tells(table, {"a.step", ",5,", "steel"}));
    EXPECT_TRUE(tells(table, {"gone.step", "missing"}));
    EXPECT_EQ(std::distance(fs::directory_iterator(out_ / "jobs"), {}), 3);
}

TEST_F(Batches, OptionsThatMakeNoSenseAreToldBeforeAnythingIsPlanned) {
    part("a.step");
    std::ofstream(parts_ / "orders.csv") << "file,options\na.step,--objective beauty\n";
    const ProgramRun list = runProgram(words({(parts_ / "orders.csv").string(), "-o", out_.string()}));
    EXPECT_EQ(list.exit_code, 2);
    EXPECT_TRUE(tells(list.err, {"a.step", "objective"}));
    EXPECT_EQ(batch({"--tools", "none.json"}).exit_code, 2);
    EXPECT_EQ(runProgram(words({"nowhere", "-o", out_.string()})).exit_code, 2);
    EXPECT_EQ(runProgram(words({})).exit_code, 2);
    EXPECT_EQ(runProgram(words({"--status", out_.string()})).exit_code, 2);
    EXPECT_FALSE(fs::exists(out_));
}

TEST_F(Batches, AFolderThatCannotBeWrittenIsTold) {
    part("a.step");
    const ProgramRun run = runProgram(words({parts_.string(), "-o", "/proc/stepmill-batch"}));
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(tells(run.err, {"/proc/stepmill-batch", "cannot be made"}));
    if (geteuid() == 0) GTEST_SKIP() << "root writes into read-only folders";
    fs::create_directory(out_);
    chmod(out_.c_str(), 0500);
    EXPECT_EQ(batch().exit_code, 2);
    chmod(out_.c_str(), 0700);
}

TEST_F(Batches, AFileSizeLimitLosesNothing) {
    part("a.step");
    noise("noise.step");
    for (const char* blocks : {"0", "8", "40"}) {
        const ProgramRun run =
            runProgram({"/bin/bash", "-c",
                        std::string("ulimit -f ") + blocks + "; '" + stepmillBinary() + "' batch '" +
                            parts_.string() + "' -o '" + out_.string() + "' --resume"});
        EXPECT_GE(run.exit_code, 1) << blocks;
        EXPECT_LE(run.exit_code, 2) << blocks << run.err;
    }
    EXPECT_EQ(batch({"--resume"}).exit_code, 1);
    EXPECT_EQ(outcome("a.step"), "complete");
    EXPECT_EQ(outcome("noise.step"), "refused");
}

TEST_F(Batches, HostileNamesAreNamedAndHarmNothing) {
    const Words names{"-o.step",   " .step",       "'; touch x.step", "<script>alert(1)<.step",
                      "=1+1.step", "\n.step",      "\xff\xfe.step",   "\"quoted\".step",
                      "a,b.step",  "$(exit).step", "...step",         "%2e%2e%2f.step"};
    for (const std::string& name : names)
        noise(name);
    const ProgramRun run = batch();
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_EQ(entries(out_).size(), names.size());
    std::set<std::string> left;
    for (const auto& entry : fs::directory_iterator(folder_.path()))
        left.insert(entry.path().filename().string());
    EXPECT_EQ(left, (std::set<std::string>{"out", "parts"}));
}

TEST_F(Batches, OneMagazineServesAllParts) {
    part("a.step");
    part("b.step", "open_slots");
    part("c.step", "rounded_pocket");
    batch();
    const ProgramRun free = runProgram(words({"--magazine", out_.string()}));
    EXPECT_EQ(free.exit_code, 0) << free.err;
    EXPECT_TRUE(tells(free.out, {"no other set"}));
    const ProgramRun one = runProgram(words({"--magazine", out_.string(), "--places", "1"}));
    EXPECT_TRUE(tells(one.out, {"1 of"}));
    EXPECT_TRUE(tells(slurp(out_ / "magazine.csv"), {"EM", "yes"}));
    EXPECT_TRUE(tells(one.out, {"parts need more tools"}));
    EXPECT_TRUE(tells(runProgram(words({"--magazine", out_.string(), "--places", "8"})).out,
                      {"tools are put in", "no order puts in fewer"}));
    EXPECT_TRUE(tells(slurp(out_ / "order.csv"), {"3,", ".step", "EM"}));
    EXPECT_EQ(runProgram(words({"--magazine", parts_.string()})).exit_code, 2);
}

std::string wordOf(test::Outcome expected) {
    return expected == test::Outcome::Planned ? "complete"
           : expected == test::Outcome::Gaps  ? "gaps"
                                              : "refused";
}

TEST_F(Batches, ToolsToBuyAreWeighedOverAllPieces) {
    // A library of one narrow cutter, and the shop's to choose from.
    const std::string shop = kSource + "/samples/shop_metric_tools.json";
    Json library = Json::parse(slurp(shop));
    std::erase_if(library["tools"].get_ref<Json::array_t&>(),
                  [](const Json& tool) { return tool["id"] != "EM6"; });
    std::ofstream(parts_ / "small.json") << library;
    part("a.step", "rounded_pocket");
    std::ofstream(parts_ / "orders.csv") << "file,quantity\na.step,50\n";
    const Words order{(parts_ / "orders.csv").string(), "-o",    out_.string(), "--tools",
                      (parts_ / "small.json").string(), "--buy", shop};
    EXPECT_LE(runProgram(words(order)).exit_code, 1);
    const std::string worth = slurp(out_ / "buy.csv");
    std::istringstream lines(worth);
    std::string line;
    std::getline(lines, line);
    EXPECT_TRUE(line.starts_with("tool,diameter_mm,price,parts,features,saves_min"));
    ASSERT_TRUE(std::getline(lines, line)) << "a wider cutter would save time";
    EXPECT_TRUE(line.starts_with("EM"));
    EXPECT_EQ(worth.find("\nEM6,"), std::string::npos) << "the shop has it";
    // What one piece would save is told by plan too.
    const ProgramRun one =
        runProgram({stepmillBinary(), "plan", (parts_ / "a.step").string(), "-o", (parts_ / "job").string(),
                    "--tools", (parts_ / "small.json").string(), "--buy", shop});
    EXPECT_TRUE(tells(one.out, {"feature", "saves", "min"}));
    EXPECT_NE(one.out.find(line.substr(0, line.find(','))), std::string::npos);
}

TEST_F(Batches, BadFilesComeOutAsTheCorpusTableSays) {
    const std::vector<ExpectedOutcome> all = expectedOf("bad");
    for (const ExpectedOutcome& expected : all) {
        STEPMILL_NEEDS_PART(expected);
        fs::copy_file(expected.path, parts_ / fs::path(expected.part).filename());
    }
    EXPECT_EQ(batch().exit_code, 1);
    const std::map<std::string, BatchJob> jobs = entries(out_);
    ASSERT_EQ(jobs.size(), all.size());
    for (const ExpectedOutcome& expected : all) {
        const BatchJob& job = jobs.at(fs::path(expected.part).filename().string());
        EXPECT_EQ(toString(job.outcome), wordOf(expected.outcome)) << expected.part << job.message;
    }
}

/// Bad files and MFCAD parts beside the checkout.
TEST_F(Batches, PartsOfTheCorpusComeOutAsPlanSaysOfEach) {
    constexpr std::size_t kOfEach = 6;
    std::map<std::string, std::string> from;
    for (const char* folder : {"bad", "mfcad"}) {
        const std::vector<std::string> all = sharedParts(folder);
        for (std::size_t i = 0; i < std::min(kOfEach, all.size()); ++i)
            from[fs::path(all[i]).filename().string()] = all[i];
    }
    if (from.empty()) GTEST_SKIP() << "the folder of STEP parts is not beside this checkout";
    for (const auto& [name, path] : from)
        fs::copy_file(path, parts_ / name);
    batch();
    for (const auto& [name, path] : from) {
        const fs::path alone = fs::path(folder_.path()) / "alone" / name;
        const ProgramRun run = runProgram({stepmillBinary(), "plan", path, "-o", alone.string()});
        const BatchJob job = entries(out_).at(name);
        EXPECT_EQ(job.exit_code, run.exit_code) << name;
        EXPECT_EQ(slurp(out_ / "jobs" / job.folder / "plan.json"), slurp(alone / "plan.json")) << name;
    }
}

}  // namespace
}  // namespace stepmill::test
