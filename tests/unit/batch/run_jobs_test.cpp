#include "stepmill/batch/run_jobs.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>

#include <gtest/gtest.h>
#include <unistd.h>

#include "stepmill/batch/job_record.h"
#include "stepmill/batch/part_figures.h"
#include "stepmill/batch/tidy_batch.h"
#include "support/run_program.h"
#include "support/text_file.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;

/// What a plan that is written leaves.
void writeJob(JobFolder& folder) {
    folder.write({JobWriter::Plan, "a.step", std::string(64, '0'), "", {{"plan.json", "", "{}"}}, {}});
}

/// Dies of the signal itself: sanitizers would catch it and exit.
void crash() {
    std::signal(SIGSEGV, SIG_DFL);
    std::raise(SIGSEGV);
}

int doAs(const std::string& what, StageBoard& board) {
    if (what == "crash") crash();
    if (what == "import-crash") {
        board.set("importing", StageBoard::Reads::Input);
        crash();
    }
    if (what == "memory") throw std::bad_alloc();
    if (what == "killed") ::kill(::getpid(), SIGKILL);
    while (what == "hang")
        ::pause();
    return std::stoi(what);
}

class RunJobs : public testing::Test {
  protected:
    /// Jobs whose folders' names say what they do.
    std::vector<BatchJob> jobs(const std::vector<std::string>& names) {
        std::vector<BatchJob> jobs;
        for (const std::string& name : names) {
            BatchJob job;
            job.key = {name, "options", "1.0"};
            job.folder = name;
            jobs.push_back(job);
        }
        return jobs;
    }

    int run(const std::vector<BatchJob>& jobs, int at_once = 2) {
        Ledger ledger(ledger_);
        const JobWork work{[this](const BatchJob& job, JobFolder& folder, StageBoard& board) {
                               std::ofstream(begun_, std::ios::app) << job.folder << "\n";
                               std::cerr << "told by " << job.folder << "\n";
                               const int exit_code = doAs(job.folder, board);
                               if (exit_code < 2) writeJob(folder);
                               if (exit_code < 2) writeRecord(batch_, job, {exit_code, figures()});
                               return exit_code;
                           },
                           [](const Supervised&) { return std::string("ended"); },
                           [this](const BatchJob&) { ++told_; }};
        return runJobs(jobs, batch_, {at_once, {kTimeoutS, 0}}, work, ledger);
    }

    static std::string figures() { return figuresJson(PartFigures{}); }
    BatchJob entry(const std::string& name) const {
        for (const auto& [key, job] : Ledger::forReading(ledger_).jobs())
            if (job.folder == name) return job;
        return {};
    }

    static constexpr double kTimeoutS = 1;
    test::TemporaryFolder folder_;
    fs::path batch_ = folder_.path();
    fs::path ledger_ = batch_ / "ledger.sqlite";
    fs::path begun_ = batch_ / "begun";
    int told_ = 0;
};

TEST_F(RunJobs, EachOutcomeIsEnteredWhateverTheOthersDo) {
    const std::vector<std::pair<std::string, Outcome>> all{
        {"0", Outcome::Complete},    {"1", Outcome::Gaps},
        {"2", Outcome::Refused},     {"3", Outcome::Bug},
        {"4", Outcome::Unwritable},  {"5", Outcome::Missing},
        {"6", Outcome::Changed},     {"crash", Outcome::Bug},
        {"hang", Outcome::TimedOut}, {"import-crash", Outcome::KernelCrash},
        {"killed", Outcome::Killed}, {"memory", Outcome::OutOfMemory}};
    std::vector<std::string> names;
    for (const auto& [name, outcome] : all)
        names.push_back(name);
    EXPECT_EQ(run(jobs(names)), 0);
    EXPECT_EQ(told_, static_cast<int>(all.size()));
    for (const auto& [name, outcome] : all) {
        const BatchJob job = entry(name);
        EXPECT_EQ(toString(job.outcome), toString(outcome)) << name;
        EXPECT_EQ(job.tries, 1);
        EXPECT_NE(job.message.find("told by " + name), std::string::npos) << job.message;
        EXPECT_EQ(job.figures.empty(), !hasPlan(outcome)) << name;
        EXPECT_EQ(isPlanned(batch_, job), hasPlan(outcome)) << name;
    }
    EXPECT_TRUE(fs::is_empty(batch_ / "records"));
}

TEST_F(RunJobs, WhatAKilledBatchHadPlannedIsEnteredAndNotDoneAgain) {
    const std::vector<BatchJob> planned = jobs({"1"});
    {
        JobFolder folder(jobFolder(batch_, planned.front()));
        writeJob(folder);
        writeRecord(batch_, planned.front(), {1, figures()});
    }
    EXPECT_EQ(run(planned), 0);
    EXPECT_EQ(entry("1").outcome, Outcome::Gaps);
    EXPECT_FALSE(fs::exists(begun_)) << "it was planned again";
}

TEST_F(RunJobs, ARecordOfAnotherPlanOrCutOffIsNone) {
    const BatchJob job = jobs({"1"}).front();
    {
        JobFolder folder(jobFolder(batch_, job));
        writeJob(folder);
        writeRecord(batch_, job, {0, figures()});
        ASSERT_TRUE(readRecord(batch_, job).has_value());
        folder.write({JobWriter::Plan, "a.step", std::string(64, '0'), "", {{"plan.json", "", "{ }"}}, {}});
    }
    EXPECT_FALSE(readRecord(batch_, job).has_value()) << "the folder holds the plan of other options";
    EXPECT_EQ(run({job}), 0);
    EXPECT_EQ(entry("1").outcome, Outcome::Gaps);
    EXPECT_EQ(test::slurp(begun_), "1\n");
    std::ofstream(batch_ / "records" / (job.key.text() + ".json")) << R"({"exit_code": 0, "figures": ")";
    EXPECT_FALSE(readRecord(batch_, job).has_value());
}

TEST_F(RunJobs, WhatAKilledBatchLeftHalfWrittenGoesAndWholeRecordsStay) {
    const BatchJob job = jobs({"1"}).front();
    {
        JobFolder folder(jobFolder(batch_, job));
        writeJob(folder);
    }
    writeRecord(batch_, job, {1, figures()});
    fs::create_directories(batch_ / "jobs" / ".x-1.stepmill-abcdef");
    for (const char* name : {"records/a.json.12.part", "index.html.7.part", "jobs/.x-1.stepmill-lock"})
        std::ofstream(batch_ / name) << "";
    std::ofstream(batch_ / "mine.part") << "hers";
    tidyBatch(batch_);
    EXPECT_TRUE(readRecord(batch_, job).has_value());
    EXPECT_EQ(std::distance(fs::directory_iterator(batch_ / "jobs"), {}), 1);
    EXPECT_FALSE(fs::exists(batch_ / "records" / "a.json.12.part"));
    EXPECT_FALSE(fs::exists(batch_ / "index.html.7.part"));
    EXPECT_TRUE(fs::exists(batch_ / "mine.part"));
    removeOldRecords(batch_);
    EXPECT_TRUE(fs::is_empty(batch_ / "records"));
}

TEST_F(RunJobs, AJobWhoseFolderAnotherRunHasIsUnwritable) {
    const std::vector<BatchJob> taken = jobs({"0", "1"});
    const JobFolder other(jobFolder(batch_, taken.front()));
    EXPECT_EQ(run(taken), 0);
    EXPECT_EQ(entry("0").outcome, Outcome::Unwritable);
    EXPECT_EQ(entry("1").outcome, Outcome::Gaps);
}

TEST_F(RunJobs, ASignalStopsItAndLeavesTheRestWaiting) {
    const pid_t self = ::getpid();
    const pid_t helper = ::fork();
    if (helper == 0) {
        ::usleep(300000);
        ::kill(self, SIGTERM);
        ::_exit(0);
    }
    const StopSignals held;  // it takes effect nowhere else
    EXPECT_EQ(run(jobs({"0", "hang", "1"}), 1), SIGTERM);
    EXPECT_EQ(entry("0").outcome, Outcome::Complete);
    EXPECT_EQ(entry("hang").outcome, Outcome::Waiting);
    EXPECT_EQ(entry("1").folder, "") << "it has not begun";
}

}  // namespace
}  // namespace stepmill
