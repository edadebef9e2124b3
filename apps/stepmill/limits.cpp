#include "limits.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <unistd.h>

#include <fmt/core.h>

namespace stepmill {

namespace {

constexpr double kBytesOfGb = 1 << 30;
constexpr double kBytesOfMb = 1 << 20;

/// As typed, but no longer than a message should be.
std::string cut(const std::string& text) {
    constexpr std::size_t kShown = 20;
    return text.size() <= kShown ? text : text.substr(0, kShown) + "...";
}

double machineMemoryGb() {
    return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE)) /
           kBytesOfGb;
}

}  // namespace

double defaultMemoryGb(int at_once) {
    constexpr double kUsual = 8;
    constexpr double kShare = 0.75;
    const double each_gb = kShare * machineMemoryGb() / at_once;
    // Rounded, so that help and messages show a plain number.
    return each_gb > 0 ? std::min(kUsual, std::max(0.25, std::floor(4 * each_gb) / 4)) : kUsual;
}

std::uint64_t RunLimits::memoryBytes() const {
    return static_cast<std::uint64_t>(memory_gb * kBytesOfGb);
}

std::uint64_t RunLimits::maxFileBytes() const {
    return static_cast<std::uint64_t>(max_file_mb * kBytesOfMb);
}

CLI::Validator numberFrom(double least, double most, const std::string& unit) {
    const std::string expected = fmt::format("{:g} to {:g}{}{}", least, most, unit.empty() ? "" : " ", unit);
    return {[=](std::string& text) {
                const char* end = text.data() + text.size();
                double value = 0;
                const auto [next, error] = std::from_chars(text.data(), end, value);
                const bool fits = error == std::errc() && next == end && value >= least && value <= most;
                return fits ? std::string() : fmt::format("expected {}, found '{}'", expected, cut(text));
            },
            expected};
}

void addLimitOptions(CLI::App& command, RunLimits& limits) {
    command.add_option("--timeout", limits.timeout_s, "seconds after which the run ends for good")
        ->check(numberFrom(0.001, 1e7, "s"))
        ->capture_default_str();
    command.add_option("--memory", limits.memory_gb, "GB of memory the run may take")
        ->check(numberFrom(0.03125, 65536, "GB"))
        ->capture_default_str();
    command.add_option("--max-file-size", limits.max_file_mb, "MB that each file that is read may have")
        ->check(numberFrom(0.001, 1e6, "MB"))
        ->capture_default_str();
}

}  // namespace stepmill
