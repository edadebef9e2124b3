#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace stepmill {

/// Disjoint sets of the numbers from 0 on, each named by its least member.
class Groups {
  public:
    /// \param count  so many numbers, each a set of its own
    explicit Groups(std::size_t count = 0) { grow(count); }

    /// To so many numbers: what is new is a set of its own.
    void grow(std::size_t count) {
        const std::size_t from = least_.size();
        least_.resize(count);
        std::iota(least_.begin() + static_cast<std::ptrdiff_t>(from), least_.end(), from);
    }

    /// The name of the set; shortens the way to it.
    std::size_t of(std::size_t member) {
        while (least_[member] != member)
            member = least_[member] = least_[least_[member]];
        return member;
    }
    std::size_t of(std::size_t member) const {
        while (least_[member] != member)
            member = least_[member];
        return member;
    }

    void join(std::size_t a, std::size_t b) {
        a = of(a);
        b = of(b);
        least_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::size_t> least_;  ///< by number: one of its set that is no greater, the least its own
};

}  // namespace stepmill
