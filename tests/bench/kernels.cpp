#include "bench/kernels.h"

#include <ctime>

namespace stepmill::bench {

double processorSeconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Pairs runPairs(std::size_t radii, double first_s, double budget_s,
               const std::function<double(std::size_t m, std::size_t n)>& pair) {
    std::vector<std::pair<std::size_t, std::size_t>> all;
    for (std::size_t m = 1; m < radii; ++m)
        for (std::size_t n = 0; n < m; ++n)
            all.emplace_back(m, n);
    constexpr std::size_t kStride = 73;  // a prime, so that no pair comes twice
    Pairs result;
    result.all = static_cast<int>(all.size());
    const double start_s = processorSeconds();
    double used_s = 0;
    for (std::size_t i = 0; i < all.size() && used_s < budget_s; ++i) {
        const auto& [m, n] = all[i * kStride % all.size()];
        result.area_mm2 += pair(m, n);
        ++result.done;
        used_s = processorSeconds() - start_s;
    }
    result.seconds = start_s - first_s + used_s * result.all / result.done;
    return result;
}

}  // namespace stepmill::bench
