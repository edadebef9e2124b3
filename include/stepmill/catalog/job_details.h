#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/core/file.h"

namespace stepmill {

/// What a shop says of a job beside the part: the words in the head of its setup sheets. Empty where it is
/// not told.
struct JobDetails {
    std::string part;  ///< empty: the name in the STEP file
    std::string part_number;
    std::string revision;
    std::string description;
    std::string document;
    std::string order;
    std::string customer;
    std::string programmer;
    std::string date;
    std::string machine;     ///< empty: the name in the machine's file
    std::string controller;  ///< empty: the dialect
    std::string material;    ///< grade and condition
    int quantity = 0;        ///< 0: not told
    std::vector<std::string> notes;
};

/// Reads a job file (schemas/job.schema.json).
/// \throws Error(InvalidCatalog) with "file#/json/pointer" as subject and what was expected;
///         Error(FileUnreadable)
JobDetails readJobDetails(const std::filesystem::path& path, std::uintmax_t max_bytes = kMaxFileBytes);

/// The same from text already in memory.
JobDetails jobDetailsFromText(std::string_view text, const std::string& file_name);

}  // namespace stepmill
