#include "stepmill/batch/cluster_jobs.h"

#include <algorithm>
#include <fstream>
#include <numeric>

#include <gtest/gtest.h>

#include "stepmill/batch/batch_rows.h"
#include "support/run_program.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;
using Tasks = std::vector<std::vector<std::size_t>>;

TEST(ExpectedSeconds, GrowWithFacesAndSize) {
    const std::string small = "#1=ADVANCED_FACE();#2=ADVANCED_FACE();";
    EXPECT_GT(expectedSeconds(small), expectedSeconds("#1=ADVANCED_FACE();                   "));
    EXPECT_GT(expectedSeconds(std::string(5'000'000, ' ')), expectedSeconds(std::string(50, ' ')) + 1);
    EXPECT_GT(expectedSeconds(""), 0);
}

TEST(ShareOut, SmallJobsShareATaskAndALongOneHasItsOwn) {
    EXPECT_EQ(shareOut({1, 100, 1, 1, 1}, 10, 1000).front(), (std::vector<std::size_t>{1}));
    EXPECT_EQ(shareOut({1, 1, 1, 1}, 2, 1000), (Tasks{{0, 2}, {1, 3}}));
    EXPECT_EQ(shareOut({1, 1, 1}, 60, 1000), (Tasks{{0, 1, 2}}));
    EXPECT_EQ(shareOut({}, 60, 1000), Tasks());
}

TEST(ShareOut, EveryJobIsInOneTaskAndTheTasksAreNoMoreThanAllowed) {
    std::vector<double> expected_s;
    for (int i = 0; i < 5000; ++i)
        expected_s.push_back(0.1 + i % 17);
    const Tasks tasks = shareOut(expected_s, 10, 1000);
    EXPECT_EQ(tasks.size(), 1000U);
    std::vector<int> times(expected_s.size());
    std::vector<double> loads_s;
    for (const auto& task : tasks) {
        EXPECT_TRUE(std::is_sorted(task.begin(), task.end()));
        double load_s = 0;
        for (const std::size_t job : task) {
            load_s += expected_s[job];
            ++times[job];
        }
        loads_s.push_back(load_s);
    }
    EXPECT_EQ(times, std::vector<int>(expected_s.size(), 1));
    const double mean_s = std::accumulate(loads_s.begin(), loads_s.end(), 0.0) / 1000;
    // Longest first errs by a third at most [Graham 1969].
    EXPECT_LE(*std::max_element(loads_s.begin(), loads_s.end()), 4.0 / 3 * mean_s + 1e-9);
}

class TaskRecords : public testing::Test {
  protected:
    static BatchJob job(const std::string& name) {
        BatchJob job;
        job.key = {name, "options", "1.0"};
        job.folder = name;
        return job;
    }

    test::TemporaryFolder folder_;
    fs::path batch_ = folder_.path();
    TaskBook book_{batch_, "node7"};
};

TEST_F(TaskRecords, TellWhatCameOfAJobAndWhere) {
    BatchJob tried = job("a");
    EXPECT_EQ(recordedJob(batch_, tried).node, "") << "it has not begun";
    tried.tries = 1;
    book_.begin(tried);
    EXPECT_EQ(recordedJob(batch_, tried).job.outcome, Outcome::Waiting);
    EXPECT_EQ(recordedJob(batch_, tried).node, "node7");
    tried.outcome = Outcome::TimedOut;
    tried.exit_code = 2;
    tried.message = "stopped after \"5 s\"\n";
    tried.started = "2026-01-02T03:04:05Z";
    tried.seconds = 5.25;
    book_.finish(tried);
    const BatchJob read = recordedJob(batch_, job("a")).job;
    EXPECT_EQ(read.outcome, Outcome::TimedOut);
    EXPECT_EQ(read.exit_code, 2);
    EXPECT_EQ(read.message, tried.message);
    EXPECT_EQ(read.tries, 1);
    EXPECT_EQ(read.started, tried.started);
    EXPECT_EQ(read.seconds, 5.25);
    removeRecord(batch_, tried);
    EXPECT_TRUE(fs::is_empty(batch_ / "records"));
}

TEST_F(TaskRecords, AJobToldToBePlannedWhosePlanIsNotThereIsStillToDo) {
    BatchJob planned = job("a");
    planned.outcome = Outcome::Complete;
    book_.finish(planned);
    EXPECT_EQ(recordedJob(batch_, job("a")).job.outcome, Outcome::Waiting);
    for (const auto& file : fs::directory_iterator(batch_ / "records"))
        std::ofstream(file.path()) << R"({"outcome":"refused")";
    EXPECT_EQ(recordedJob(batch_, job("a")).node, "") << "a damaged record is none";
}

TEST_F(TaskRecords, CountInAListBeforeTheyAreInTheLedger) {
    Ledger ledger(batch_ / "ledger.sqlite");
    ledger.setParts({{"a.step", 1, "", "", job("a").key.text(), ""}});
    ledger.begin(job("a"));
    BatchJob refused = job("a");
    refused.outcome = Outcome::Refused;
    book_.finish(refused);
    EXPECT_EQ(rowsOf(ledger).front().outcome, Outcome::Waiting);
    EXPECT_EQ(rowsOf(ledger, batch_).front().outcome, Outcome::Refused);
}

TEST_F(TaskRecords, ASharedLedgerTakesItsPlaceWholeOrNotAtAll) {
    const fs::path file = batch_ / "ledger.sqlite";
    Ledger(file).begin(job("a"));
    {
        SharedLedger shared(file);
        shared.ledger().begin(job("b"));
        EXPECT_EQ(Ledger::forReading(file).jobs().size(), 1U);
        shared.publish();
        EXPECT_EQ(Ledger::forReading(file).jobs().size(), 2U);
        shared.ledger().begin(job("c"));
    }
    EXPECT_EQ(Ledger::forReading(file).jobs().size(), 2U) << "what was not published is not there";
    EXPECT_FALSE(fs::exists(file.string() + "-wal")) << "the file is all";
    EXPECT_EQ(Ledger(file).jobs().size(), 2U);
}

}  // namespace
}  // namespace stepmill
