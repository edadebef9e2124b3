#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace stepmill::planar {

/// The numbers 0, 1, ... sorted into groups, in rising order within each. Two lists in all, where a list per
/// group would cost more time than what is looked up in it.
class Grouped {
  public:
    Grouped() = default;
    /// Number i belongs to group `groups[i]`, one of `count`. O(numbers + count).
    Grouped(std::span<const int> groups, std::size_t count) : first_(count + 1, 0), members_(groups.size()) {
        for (const int group : groups)
            ++first_[static_cast<std::size_t>(group) + 1];
        for (std::size_t g = 0; g < count; ++g)
            first_[g + 1] += first_[g];
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (std::size_t i = 0; i < groups.size(); ++i)
            members_[next[static_cast<std::size_t>(groups[i])]++] = static_cast<int>(i);
    }

    std::size_t count() const { return first_.empty() ? 0 : first_.size() - 1; }
    std::span<const int> operator[](std::size_t group) const {
        return {members_.data() + first_[group], members_.data() + first_[group + 1]};
    }

  private:
    std::vector<std::size_t> first_;  // of each group, its first member; then one past all
    std::vector<int> members_;
};

}  // namespace stepmill::planar
