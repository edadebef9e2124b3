// Loops over all threads: done when they return, whatever happens to the loop around them.

#include "stepmill/core/parallel.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace stepmill {
namespace {

constexpr int kOuter = 8;
constexpr int kInner = 200;

void rest() {
    std::this_thread::sleep_for(std::chrono::microseconds(100));
}

TEST(ParallelFor, DoesEachOnce) {
    std::vector<int> done(1000, 0);
    parallelFor(done.size(), [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(1000, 1));
    parallelFor(std::size_t{0}, [&](std::size_t) { FAIL(); });
}

TEST(ParallelFor, ThrowsOnWhatOneThrows) {
    EXPECT_THROW(parallelFor(kInner,
                             [](int i) {
                                 if (i == kInner / 2) throw std::runtime_error("one");
                             }),
                 std::runtime_error);
}

TEST(ParallelFor, IsDoneWhereItReturnsThoughTheLoopAroundItFailed) {
    std::atomic<int> begun = 0;
    std::atomic<int> half_done = 0;
    EXPECT_THROW(parallelFor(kOuter,
                             [&](int outer) {
                                 ++begun;
                                 if (outer == 0) {
                                     rest();
                                     throw std::runtime_error("no time");
                                 }
                                 std::atomic<int> done = 0;
                                 parallelFor(kInner, [&](int) {
                                     rest();
                                     ++done;
                                 });
                                 if (done < kInner) ++half_done;
                             }),
                 std::runtime_error);
    EXPECT_GT(begun, 0);
    EXPECT_EQ(half_done, 0);
}

TEST(ParallelForParts, CoverAll) {
    std::vector<int> done(1000, 0);
    parallelForParts(done.size(), std::size_t{64}, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            ++done[i];
    });
    EXPECT_EQ(done, std::vector<int>(1000, 1));
}

TEST(ParallelInvoke, DoesBoth) {
    int one = 0;
    int other = 0;
    parallelInvoke([&] { one = 1; }, [&] { other = 2; });
    EXPECT_EQ(one + other, 3);
}

}  // namespace
}  // namespace stepmill
