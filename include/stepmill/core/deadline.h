#pragma once

#include <algorithm>
#include <chrono>
#include <limits>
#include <string>

#include "stepmill/core/error.h"

namespace stepmill {

/// The moment at which work is given up; never, unless one is given.
class Deadline {
  public:
    using Clock = std::chrono::steady_clock;

    Deadline() = default;
    explicit Deadline(Clock::time_point at) : at_(at) {}
    /// So many seconds from now; infinite: never.
    static Deadline in(double seconds) {
        constexpr double kNeverS = 1e9;  // thirty years, which the clock can count
        if (seconds >= kNeverS) return {};
        return Deadline(Clock::now() +
                        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)));
    }

    bool isNever() const { return at_ == Clock::time_point::max(); }
    /// Infinite where it never comes; negative where it has passed.
    double secondsLeft() const {
        if (isNever()) return std::numeric_limits<double>::infinity();
        return std::chrono::duration<double>(at_ - Clock::now()).count();
    }
    bool passed() const { return !isNever() && Clock::now() >= at_; }
    /// \throws Error(TimedOut) about `subject` where it has passed
    void check(const std::string& subject) const {
        if (passed()) throw Error(ErrorCode::TimedOut, subject, "the time for it is over");
    }
    Deadline orEarlier(const Deadline& other) const { return Deadline(std::min(at_, other.at_)); }

  private:
    Clock::time_point at_ = Clock::time_point::max();
};

}  // namespace stepmill
