#pragma once

#include <random>

namespace stepmill::test {

/// Even in [from, to).
inline double uniform(std::mt19937& random, double from, double to) {
    return std::uniform_real_distribution(from, to)(random);
}

}  // namespace stepmill::test
