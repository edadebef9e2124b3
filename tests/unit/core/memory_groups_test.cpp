#include "stepmill/core/memory_groups.h"

#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "stepmill/core/supervise.h"
#include "support/run_program.h"
#include "support/text_file.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;

/// Files as a system has them that delegates a group. What a kernel does with the words is not tested here.
class MadeUpGroups : public testing::Test {
  protected:
    MadeUpGroups() {
        write("cgroup.controllers", "cpu memory pids\n");
        write("cgroup.procs", self_ + "\n");
        write("cgroup.subtree_control", "");
    }
    void write(const std::string& name, const std::string& text) const { std::ofstream(own_ / name) << text; }
    fs::path ours() const { return own_ / ("stepmill-" + self_); }

    test::TemporaryFolder folder_;
    fs::path own_ = folder_.path();
    std::string self_ = std::to_string(::getpid());
};

TEST_F(MadeUpGroups, EachChildHasItsLimitAndTheCallerStandsBeside) {
    const auto groups = MemoryGroups::take(own_);
    ASSERT_NE(groups, nullptr);
    EXPECT_EQ(test::slurp(ours() / "cgroup.procs"), self_);
    EXPECT_EQ(test::slurp(own_ / "cgroup.subtree_control"), "+memory");
    const auto first = groups->make(123456);
    const auto second = groups->make(7);
    EXPECT_EQ(test::slurp(ours().string() + "-job-1/memory.max"), "123456");
    EXPECT_EQ(test::slurp(ours().string() + "-job-2/memory.max"), "7");
    EXPECT_TRUE(first->enter());
    EXPECT_EQ(test::slurp(ours().string() + "-job-1/cgroup.procs"), self_);
}

TEST_F(MadeUpGroups, AChildThatTheSystemEndsForItsMemoryRanOutOfIt) {
    const auto groups = MemoryGroups::take(own_);
    ASSERT_NE(groups, nullptr);
    const fs::path group = ours().string() + "-job-1";
    const StopSignals stop;
    SupervisedChild child(
        [&](StageBoard&) {
            EXPECT_EQ(test::slurp(group / "cgroup.procs"), std::to_string(::getpid()));
            std::ofstream(group / "memory.events") << "low 0\nmax 12\noom 1\noom_kill 1\n";
            return ::kill(::getpid(), SIGKILL);
        },
        {60, std::uint64_t{1} << 40, groups.get()}, stop);
    std::optional<Supervised> end;
    while (!(end = child.ended()))
        ::usleep(1000);
    EXPECT_EQ(end->end, Supervised::End::OutOfMemory);
}

TEST_F(MadeUpGroups, AreNotTakenWhereTheSystemDoesNotGiveThem) {
    write("cgroup.procs", self_ + "\n1\n");
    EXPECT_EQ(MemoryGroups::take(own_), nullptr) << "others are in the group";
    write("cgroup.procs", "");
    EXPECT_EQ(MemoryGroups::take(own_), nullptr) << "it is another's";
    write("cgroup.procs", self_ + "\n");
    write("cgroup.controllers", "cpu pids\n");
    EXPECT_EQ(MemoryGroups::take(own_), nullptr) << "memory is limited in another way here";
    EXPECT_EQ(MemoryGroups::take({}), nullptr);
    EXPECT_FALSE(fs::exists(ours()));
}

}  // namespace
}  // namespace stepmill
