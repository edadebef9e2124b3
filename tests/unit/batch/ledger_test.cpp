#include "stepmill/batch/ledger.h"

#include <csignal>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "stepmill/batch/batch_rows.h"
#include "stepmill/core/error.h"
#include "support/run_program.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;

BatchJob jobOf(const std::string& part, const std::string& folder) {
    BatchJob job;
    job.key = {part, "options", "1.0"};
    job.folder = folder;
    return job;
}

BatchJob finished(BatchJob job, Outcome outcome) {
    job.outcome = outcome;
    job.exit_code = 1;
    job.message = "stepmill: one\ntwo of stepmill: x\n";
    job.tries = 2;
    job.started = "2026-01-02T03:04:05Z";
    job.seconds = 1.5;
    return job;
}

class Ledgers : public testing::Test {
  protected:
    test::TemporaryFolder folder_;
    fs::path file_ = fs::path(folder_.path()) / "ledger.sqlite";
};

TEST_F(Ledgers, KeepsJobsAndPartsForTheNextRun) {
    const BatchJob job = jobOf("part", "a-1");
    {
        Ledger ledger(file_);
        ledger.setParts({{"a.step", 3, "monday", "--setup +z", job.key.text(), ""},
                         {"\xff\n.step", 1, "", "", "", "gone"}});
        ledger.begin(job);
        ledger.finish(finished(job, Outcome::Gaps));
    }
    const Ledger ledger = Ledger::forReading(file_);
    const BatchJob read = ledger.jobs().at(job.key.text());
    EXPECT_EQ(read.folder, "a-1");
    EXPECT_EQ(read.outcome, Outcome::Gaps);
    EXPECT_EQ(read.exit_code, 1);
    EXPECT_EQ(read.message, "stepmill: one\ntwo of stepmill: x\n");
    EXPECT_EQ(read.tries, 2);
    EXPECT_EQ(read.started, "2026-01-02T03:04:05Z");
    EXPECT_EQ(read.seconds, 1.5);
    const std::vector<BatchRow> rows = rowsOf(ledger);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].part.quantity, 3);
    EXPECT_EQ(rows[0].reason, "one; two of stepmill: x");
    EXPECT_EQ(rows[1].part.name, "\xff\n.step");
    EXPECT_EQ(rows[1].outcome, Outcome::Missing);
    EXPECT_EQ(rows[1].reason, "gone");
}

TEST_F(Ledgers, AJobThatBeginsForgetsWhatItsFolderHeld) {
    Ledger ledger(file_);
    const BatchJob old = jobOf("part", "a-1");
    BatchJob other_options = old;
    other_options.key.options_sha256 = "others";
    ledger.finish(finished(old, Outcome::Complete));
    ledger.begin(other_options);
    EXPECT_FALSE(ledger.jobs().contains(old.key.text()));
    EXPECT_EQ(ledger.jobs().at(other_options.key.text()).outcome, Outcome::Waiting);
}

TEST_F(Ledgers, WhatIsFinishedStaysWhateverKillsTheProgramNext) {
    const BatchJob job = jobOf("part", "a-1");
    const pid_t child = fork();
    if (child == 0) {
        Ledger ledger(file_);
        ledger.finish(finished(job, Outcome::Complete));
        ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(Ledger(file_).jobs().at(job.key.text()).outcome, Outcome::Complete);
}

TEST_F(Ledgers, AFileThatIsNoLedgerIsRefused) {
    std::ofstream(file_) << "these are notes of mine, and they are longer than a header";
    EXPECT_THROW(Ledger{file_}, Error);
    EXPECT_THROW(Ledger::forReading(folder_.path() + "/none"), Error);
}

TEST(JobKeys, EachOfItsThreeMakesAnother) {
    const JobKey key{"a", "b", "c"};
    EXPECT_NE(key.text(), (JobKey{"x", "b", "c"}.text()));
    EXPECT_NE(key.text(), (JobKey{"a", "x", "c"}.text()));
    EXPECT_NE(key.text(), (JobKey{"a", "b", "x"}.text()));
    EXPECT_EQ(key.text().size(), 64U);
}

TEST(Outcomes, HaveWordsThatAreReadBack) {
    for (const Outcome outcome : allOutcomes())
        EXPECT_EQ(outcomeFrom(toString(outcome)), outcome);
    EXPECT_FALSE(outcomeFrom("fine").has_value());
}

TEST(Outcomes, TheExitCodeIsThatOfTheWorstPart) {
    EXPECT_EQ(exitCodeOf({}), 0);
    EXPECT_EQ(exitCodeOf({Outcome::Complete, Outcome::Complete}), 0);
    for (const Outcome outcome : allOutcomes()) {
        if (outcome == Outcome::Complete) continue;
        EXPECT_EQ(exitCodeOf({Outcome::Complete, outcome}), outcome == Outcome::Bug ? 3 : 1)
            << toString(outcome);
    }
}

TEST(Outcomes, WhatThePartIsNotToBlameForIsDoneAgain) {
    for (const Outcome outcome :
         {Outcome::Waiting, Outcome::Killed, Outcome::Unwritable, Outcome::Missing, Outcome::Changed})
        EXPECT_TRUE(isDoneAgain(outcome, false)) << toString(outcome);
    for (const Outcome outcome :
         {Outcome::TimedOut, Outcome::OutOfMemory, Outcome::KernelCrash, Outcome::Bug}) {
        EXPECT_FALSE(isDoneAgain(outcome, false)) << toString(outcome);
        EXPECT_TRUE(isDoneAgain(outcome, true)) << toString(outcome);
    }
    for (const Outcome outcome : {Outcome::Complete, Outcome::Gaps, Outcome::Refused})
        EXPECT_FALSE(isDoneAgain(outcome, true)) << toString(outcome);
}

}  // namespace
}  // namespace stepmill
