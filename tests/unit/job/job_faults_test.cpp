// Whatever fails, and wherever the run is killed: the folder holds the old job whole or the new one whole.

#include <sys/wait.h>

#include <gtest/gtest.h>

#include "job_makers.h"
#include "stepmill/core/supervise.h"
#include "support/faulty_disk.h"

namespace stepmill::test {
namespace {

enum class Holds { Old, New, Mix };

/// How the folder is replaced, and what lies in it.
struct Way {
    const char* name;
    bool can_exchange = true;
    bool can_link = true;
    bool notes = false;   ///< a file of the user's
    bool fresh = false;   ///< no job yet
    bool folder = false;  ///< a folder of the user's, so that files move one by one
};

std::ostream& operator<<(std::ostream& out, const Way& way) {
    return out << way.name;
}

class JobFaults : public testing::TestWithParam<Way> {
  protected:
    void SetUp() override {
        if (GetParam().fresh) return;
        write(old_);
        if (GetParam().notes) writeFile(job_ / "notes.txt", "hers");
        if (GetParam().folder) fs::create_directory(job_ / "photos");
        if (GetParam().folder) writeFile(job_ / "photos" / "one", "hers too");
    }

    void write(const NewJob& job) const {
        FaultyDisk sound;
        JobFolder(job_, sound).write(job);
    }

    FaultyDisk diskOfThisWay() const {
        FaultyDisk disk;
        disk.can_exchange = GetParam().can_exchange;
        disk.can_link = GetParam().can_link;
        return disk;
    }

    int callsOfOneWriting() {
        FaultyDisk disk = diskOfThisWay();
        JobFolder(job_, disk).write(new_);
        restore();
        return disk.calls;
    }

    void restore() {
        if (GetParam().fresh)
            fs::remove_all(job_);
        else
            write(old_);
    }

    /// Programs beside one job or the other count; only the user's files may lie beside them.
    Holds holds() const {
        if (!fs::exists(job_)) return GetParam().fresh ? Holds::Old : Holds::Mix;
        Files files;
        for (const auto& entry : fs::directory_iterator(job_))
            if (entry.is_regular_file()) files[entry.path().filename().string()] = readFile(entry.path());
        if (GetParam().notes && files["notes.txt"] != "hers") return Holds::Mix;
        if (GetParam().folder && readFile(job_ / "photos" / "one") != "hers too") return Holds::Mix;
        files.erase("notes.txt");
        const bool sealed = files.erase(kManifestName) > 0;
        if (sealed && files == wholeJob(new_)) return Holds::New;
        return sealed && files == wholeJob(old_) ? Holds::Old : Holds::Mix;
    }

    bool nothingElseIsLeft() const {
        for (const std::string& name : namesIn(folder_.path()))
            if (name != "job") return false;
        if (!fs::exists(job_)) return true;
        for (const std::string& name : namesIn(job_))
            if (name.starts_with(".")) return false;
        return true;
    }

    bool movesOneByOne() const {
        return !GetParam().fresh && (!GetParam().can_exchange || !GetParam().can_link || GetParam().folder);
    }

    TemporaryFolder folder_;
    fs::path job_ = fs::path(folder_.path()) / "job";
    NewJob old_ = planJob("a", 3);
    NewJob new_ = planJob("b", 2);
};

TEST_P(JobFaults, EveryCallThatFailsLeavesOneJobWholeAndNothingBeside) {
    const int calls = callsOfOneWriting();
    ASSERT_GT(calls, 10);
    for (int call = 0; call < calls; ++call) {
        SCOPED_TRACE(call);
        FaultyDisk disk = diskOfThisWay();
        disk.fault_at = call;
        bool failed = false;
        try {
            JobFolder(job_, disk).write(new_);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::OutputUnwritable);
            failed = true;
        }
        EXPECT_NE(holds(), Holds::Mix);
        EXPECT_TRUE(failed || holds() == Holds::New);
        write(new_);
        EXPECT_EQ(holds(), Holds::New);
        EXPECT_TRUE(nothingElseIsLeft());
        restore();
    }
}

TEST_P(JobFaults, AFullDiskLeavesTheOldJobWholeAtEveryByte) {
    std::size_t bytes = 0;
    {
        FaultyDisk disk = diskOfThisWay();
        disk.bytes_left = 1 << 20;
        JobFolder(job_, disk).write(new_);
        bytes = (1 << 20) - disk.bytes_left;
        restore();
    }
    ASSERT_GT(bytes, 500u);
    for (std::size_t fits = 0; fits < bytes; ++fits) {
        FaultyDisk disk = diskOfThisWay();
        disk.bytes_left = fits;
        EXPECT_THROW(JobFolder(job_, disk).write(new_), Error) << fits;
        ASSERT_EQ(holds(), Holds::Old) << fits;
        ASSERT_TRUE(nothingElseIsLeft()) << fits;
    }
}

TEST_P(JobFaults, AKillAtEveryCallLeavesOneJobWholeOrOneThatTheNextRunRestores) {
    const int calls = callsOfOneWriting();
    for (int call = 0; call < calls; ++call) {
        SCOPED_TRACE(call);
        const Supervised run = runSupervised(
            [&](StageBoard&) {
                FaultyDisk disk = diskOfThisWay();
                disk.fault_at = call;
                disk.fault = FaultyDisk::Fault::Kills;
                JobFolder(job_, disk).write(new_);
                return 0;
            },
            60);
        ASSERT_EQ(run.end, Supervised::End::Killed);
        if (holds() == Holds::Mix) {
            // Files were moving one by one: without its manifest the folder is no job, and says so.
            ASSERT_TRUE(movesOneByOne());
            EXPECT_FALSE(fs::exists(job_ / kManifestName));
            EXPECT_THROW(checkJob(job_), Error);
        }
        { const JobFolder tidied(job_); }
        EXPECT_NE(holds(), Holds::Mix);
        EXPECT_TRUE(nothingElseIsLeft());
        write(new_);
        EXPECT_EQ(holds(), Holds::New);
        restore();
    }
}

TEST_P(JobFaults, ADiskThatBreaksForGoodLosesNothing) {
    const int calls = callsOfOneWriting();
    for (int call = 0; call < calls; ++call) {
        SCOPED_TRACE(call);
        FaultyDisk disk = diskOfThisWay();
        disk.fault_at = call;
        disk.stays_broken = true;
        try {
            JobFolder(job_, disk).write(new_);
        } catch (const Error&) {
        }
        { const JobFolder tidied(job_); }
        EXPECT_NE(holds(), Holds::Mix);
        EXPECT_TRUE(nothingElseIsLeft());
        restore();
    }
}

INSTANTIATE_TEST_SUITE_P(Ways, JobFaults,
                         testing::Values(Way{"AtOnce"}, Way{"AtOnceWithNotes", true, true, true},
                                         Way{"Fresh", true, true, false, true},
                                         Way{"NoExchange", false, true, true},
                                         Way{"NoLinks", true, false, true},
                                         Way{"WithAFolder", true, true, true, false, true}),
                         [](const auto& way) { return std::string(way.param.name); });

}  // namespace
}  // namespace stepmill::test
