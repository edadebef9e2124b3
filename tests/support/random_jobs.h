#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sample_parts.h"

namespace stepmill::test {

/// A random part with what a shop would say of it: tools, clamps, stock and setups, allowances.
struct RandomJob {
    std::uint64_t seed = 0;
    SamplePart part;
    std::string tools_json;            ///< empty: the built-in library
    std::string fixtures_json;         ///< empty: the suggested vises
    std::vector<std::string> options;  ///< words of the command line, files apart
    std::string about;                 ///< part, library and clamps in a line
};

/// The same seed gives the same job.
RandomJob randomJob(std::uint64_t seed);

/// Writes the job's files into a folder; returns the words after the program's name that plan it there.
std::vector<std::string> writeJob(const RandomJob& job, const std::string& folder);

}  // namespace stepmill::test
