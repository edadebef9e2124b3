#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <random>

namespace stepmill::test {

/// Random choices that are the same with every standard library: its distributions are not.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : random_(seed) {}

    /// Even in [low, high).
    double between(double low, double high) { return low + (high - low) * share(); }
    /// The same in steps: sizes on drawings are round. Where there is no room between them: `low`.
    double between(double low, double high, double step) {
        const double steps = std::max(0.0, (high - low) / step);
        return low + step * static_cast<double>(below(static_cast<std::size_t>(steps) + 1));
    }
    /// 0 ... count - 1.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
    bool chance(double probability) { return share() < probability; }
    template <typename Value>
    Value oneOf(std::initializer_list<Value> values) {
        return *std::next(values.begin(), static_cast<std::ptrdiff_t>(below(values.size())));
    }

  private:
    double share() { return static_cast<double>(random_() >> 11) * 0x1.0p-53; }

    std::mt19937_64 random_;
};

}  // namespace stepmill::test
