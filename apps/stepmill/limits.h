#pragma once

#include <cstdint>
#include <string>

#include <CLI/CLI.hpp>

namespace stepmill {

/// Of a run: 8 GB, or its share of three quarters of what the machine has where that is less.
/// \param at_once  runs at the same time
double defaultMemoryGb(int at_once = 1);

/// What a run of any command may take.
struct RunLimits {
    double timeout_s = 300;
    double memory_gb = defaultMemoryGb();  ///< of 2^30 bytes
    double max_file_mb = 512;              ///< of each file that is read; of 2^20 bytes

    std::uint64_t memoryBytes() const;
    std::uint64_t maxFileBytes() const;
};

/// Adds --timeout, --memory and --max-file-size.
void addLimitOptions(CLI::App& command, RunLimits& limits);

/// Takes numbers from `least` to `most`; what it says is short whatever was typed.
CLI::Validator numberFrom(double least, double most, const std::string& unit);

}  // namespace stepmill
