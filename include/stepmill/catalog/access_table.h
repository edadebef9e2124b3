#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/core/file.h"

namespace stepmill {

/// One cutter by what it reaches and how fast it removes that: a line of the table in [Lim2000, Fig. 8].
struct AccessRow {
    std::string tool;  ///< id; empty in a table read from a file
    double diameter_mm = 0;
    double volume_cm3 = 0;  ///< tool access volume (TAV): what the cutter alone could reach
    double mrr_cm3_per_min = 0;
    /// Of the volume, what reach, shank and holder allow; nothing in a table read from a file.
    std::optional<double> clear_volume_cm3 = std::nullopt;
};

/// Reads a table of cutters: a CSV file with the header `diameter_mm,volume_cm3,mrr_cm3_per_min` and one line
/// a cutter, at most 1000, in any order. Diameters and removal rates are above zero, volumes not below it.
/// Blank lines and blanks around numbers are allowed.
///
/// \throws Error(InvalidCatalog) with "file, line N" as subject and what was expected; Error(FileUnreadable)
std::vector<AccessRow> readAccessTable(const std::filesystem::path& path,
                                       std::uintmax_t max_bytes = kMaxFileBytes);

/// The same from text already in memory; `file_name` is what error messages say.
std::vector<AccessRow> accessTableFromText(std::string_view text, const std::string& file_name);

/// The table as readAccessTable() takes it; numbers come back bit for bit, tool ids are not part of it.
std::string accessTableCsv(const std::vector<AccessRow>& rows);

}  // namespace stepmill
