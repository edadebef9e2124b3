#include "stepmill/core/supervise.h"

#include <chrono>
#include <csignal>
#include <stdexcept>

#include <gtest/gtest.h>
#include <unistd.h>

namespace stepmill {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

TEST(Supervise, PassesTheExitCodeAndTheLastStageOn) {
    const Supervised run = runSupervised(
        [](StageBoard& stage) {
            stage.set("first");
            stage.set("second");
            return 7;
        },
        30);
    EXPECT_EQ(run.end, Supervised::End::Exited);
    EXPECT_EQ(run.exit_code, 7);
    EXPECT_EQ(run.last_stage, "second");
}

TEST(Supervise, EndsAnEndlessLoopAtTheTimeLimit) {
    const Clock::time_point start = Clock::now();
    const Supervised run = runSupervised(
        [](StageBoard& stage) {
            stage.set("looping");
            volatile bool forever = true;
            while (forever) {
            }
            return 0;
        },
        0.3);
    EXPECT_EQ(run.end, Supervised::End::TimedOut);
    EXPECT_EQ(run.last_stage, "looping");
    EXPECT_GE(secondsSince(start), 0.3);
    EXPECT_LT(secondsSince(start), 10);
}

TEST(Supervise, AChildThatIgnoresTerminationIsEndedToo) {
    const Supervised run = runSupervised(
        [](StageBoard&) {
            std::signal(SIGTERM, SIG_IGN);
            while (true)
                ::pause();
            return 0;
        },
        0.2);
    EXPECT_EQ(run.end, Supervised::End::TimedOut);
}

TEST(Supervise, ReportsACrashWithItsSignal) {
    const Supervised run = runSupervised(
        [](StageBoard& stage) {
            stage.set("crashing");
            ::raise(SIGKILL);
            return 0;
        },
        30);
    EXPECT_EQ(run.end, Supervised::End::Crashed);
    EXPECT_EQ(run.signal, SIGKILL);
    EXPECT_EQ(run.last_stage, "crashing");
}

TEST(Supervise, AnUncaughtExceptionIsABugWithAMessage) {
    ::testing::internal::CaptureStderr();
    const Supervised run =
        runSupervised([](StageBoard&) -> int { throw std::runtime_error("lost the plot"); }, 30);
    const std::string message = ::testing::internal::GetCapturedStderr();
    EXPECT_EQ(run.end, Supervised::End::Exited);
    EXPECT_EQ(run.exit_code, 3);
    EXPECT_NE(message.find("lost the plot"), std::string::npos);
}

TEST(Supervise, OutputWrittenBeforeTheForkAppearsOnce) {
    ::testing::internal::CaptureStdout();
    std::fputs("parent ", stdout);
    runSupervised(
        [](StageBoard&) {
            std::fputs("child ", stdout);
            return 0;
        },
        30);
    std::fputs("parent again", stdout);
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "parent child parent again");
}

TEST(Supervise, AStageLongerThanTheBoardIsCut) {
    const Supervised run = runSupervised(
        [](StageBoard& stage) {
            stage.set(std::string(1000, 'x'));
            return 0;
        },
        30);
    EXPECT_EQ(run.last_stage, std::string(255, 'x'));
}

TEST(Supervise, GrandchildrenDoNotOutliveTheRun) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const Clock::time_point start = Clock::now();
    runSupervised(
        [&](StageBoard&) {
            if (::fork() == 0) {
                ::close(ends[0]);
                ::sleep(60);
                ::_exit(0);
            }
            return 0;
        },
        30);
    ::close(ends[1]);
    char byte = 0;
    // The read ends when the last holder of the pipe's other end is gone.
    EXPECT_EQ(::read(ends[0], &byte, 1), 0);
    EXPECT_LT(secondsSince(start), 20);
    ::close(ends[0]);
}

}  // namespace
}  // namespace stepmill
