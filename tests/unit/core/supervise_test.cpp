#include "stepmill/core/supervise.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <new>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "stepmill/core/error.h"

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

TEST(Supervise, TellsACrashFromAKillWithTheSignal) {
    const auto endBy = [](int signal) {
        return runSupervised(
            [=](StageBoard& stage) {
                stage.set("dying");
                std::signal(signal, SIG_DFL);
                ::raise(signal);
                return 0;
            },
            30);
    };
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL}) {
        const Supervised run = endBy(signal);
        EXPECT_EQ(run.end, Supervised::End::Crashed);
        EXPECT_EQ(run.signal, signal);
        EXPECT_EQ(run.last_stage, "dying");
    }
    for (const int signal : {SIGKILL, SIGTERM, SIGPIPE, SIGXCPU}) {
        const Supervised run = endBy(signal);
        EXPECT_EQ(run.end, Supervised::End::Killed);
        EXPECT_EQ(run.signal, signal);
    }
}

TEST(Supervise, TellsThatMemoryRanOut) {
#ifdef STEPMILL_SANITIZED
    GTEST_SKIP() << "the sanitizer's allocator calls no new-handler";
#endif
    constexpr std::uint64_t kLimit = std::uint64_t{256} << 20;
    const auto allocate = [&](std::size_t bytes) {
        return runSupervised(
            [=](StageBoard&) {
                try {
                    const std::vector<char> block(bytes, 'x');
                    return static_cast<int>(std::count(block.begin(), block.end(), 'y'));
                } catch (const std::exception&) {
                    return 2;  // swallowed on its way, as the failure of one feature
                }
            },
            30, kLimit);
    };
    EXPECT_EQ(allocate(kLimit / 2).end, Supervised::End::Exited);
    EXPECT_EQ(allocate(kLimit / 2).exit_code, 0);
    EXPECT_EQ(allocate(kLimit).end, Supervised::End::OutOfMemory);
}

TEST(Supervise, BadAllocThrownByHandIsMemoryThatRanOut) {
    const Supervised run = runSupervised([](StageBoard&) -> int { throw std::bad_alloc(); }, 30);
    EXPECT_EQ(run.end, Supervised::End::OutOfMemory);
}

void expectASignalToTheParentEndsTheChild(int signal) {
    std::signal(signal, SIG_DFL);  // whoever runs the tests may ignore it
    const pid_t parent = ::getpid();
    const Clock::time_point start = Clock::now();
    const Supervised run = runSupervised(
        [=](StageBoard& stage) {
            stage.set("waiting");
            ::kill(parent, signal);
            ::sleep(60);
            return 0;
        },
        60);
    EXPECT_EQ(run.end, Supervised::End::Stopped);
    EXPECT_EQ(run.signal, signal);
    EXPECT_EQ(run.last_stage, "waiting");
    EXPECT_LT(secondsSince(start), 20);
}

TEST(Supervise, ASignalToTheParentEndsTheChildAndIsTold) {
    // In a process of its own: here a thread that an earlier test left waiting may take the signal.
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        EXPECT_EXIT(
            {
                expectASignalToTheParentEndsTheChild(signal);
                std::_Exit(HasFailure() ? 1 : 0);
            },
            testing::ExitedWithCode(0), "");
    }
}

TEST(Supervise, AnIgnoredSignalStaysIgnored) {
    std::signal(SIGHUP, SIG_IGN);  // as nohup does
    const pid_t parent = ::getpid();
    const Supervised run = runSupervised(
        [=](StageBoard&) {
            ::kill(parent, SIGHUP);
            ::usleep(20000);
            return 5;
        },
        30);
    std::signal(SIGHUP, SIG_DFL);
    EXPECT_EQ(run.end, Supervised::End::Exited);
    EXPECT_EQ(run.exit_code, 5);
}

TEST(Supervise, ATimeLimitThatIsNoNumberIsRefused) {
    EXPECT_ANY_THROW(runSupervised([](StageBoard&) { return 0; }, std::nan("")));
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

#ifndef STEPMILL_SANITIZED
TEST(Supervise, SaysSoWhereTheSystemGrantsNoMoreMemory) {
    const Supervised run = runSupervised(
        [](StageBoard&) {
            const rlimit nothing_more{0, 0};
            ::setrlimit(RLIMIT_AS, &nothing_more);
            try {
                runSupervised([](StageBoard&) { return 0; }, 30);
            } catch (const Error& error) {
                return error.code() == ErrorCode::SystemLimit ? 7 : 1;
            }
            return 0;
        },
        30);
    EXPECT_EQ(run.exit_code, 7);
}
#endif

/// Asks until it has ended.
Supervised endOf(SupervisedChild& child) {
    while (true) {
        if (const std::optional<Supervised> end = child.ended()) return *end;
        ::usleep(1000);
    }
}

TEST(SupervisedChildren, WorkBesideEachOther) {
    const StopSignals stop;
    SupervisedChild hangs(
        [](StageBoard&) {
            while (true)
                ::pause();
            return 0;
        },
        {0.5, 0}, stop);
    SupervisedChild ends([](StageBoard&) { return 5; }, {30, 0}, stop);
    EXPECT_EQ(endOf(ends).exit_code, 5);
    EXPECT_FALSE(hangs.ended().has_value());
    EXPECT_EQ(endOf(hangs).end, Supervised::End::TimedOut);
}

TEST(SupervisedChildren, EndForASignalAndWithTheirObject) {
    const StopSignals stop;
    const auto sleeps = [](StageBoard& stage) {
        stage.set("sleeping");
        while (true)
            ::pause();
        return 0;
    };
    SupervisedChild stopped(sleeps, {30, 0}, stop);
    const Supervised end = stopped.endFor(SIGTERM);
    EXPECT_EQ(end.end, Supervised::End::Stopped);
    EXPECT_EQ(end.signal, SIGTERM);
    { const SupervisedChild dropped(sleeps, {30, 0}, stop); }
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "no child is left";
}

}  // namespace
}  // namespace stepmill
