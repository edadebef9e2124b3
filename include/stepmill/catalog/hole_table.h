#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/catalog/fit.h"
#include "stepmill/catalog/thread.h"
#include "stepmill/core/file.h"

namespace stepmill {

/// What a hole table may say of a hole.
enum class HoleMaking {
    Tap,    ///< made as without the table, then tapped
    Ream,   ///< made nearly as wide, then reamed to a fit
    Bore,   ///< made nearly as wide, then bored to a fit, by a boring head or the turns of a mill
    Drill,  ///< by drills alone: what they leave stays
    Leave   ///< nothing of it is cut
};

/// Both ends belong to it [mm].
struct SizeRange {
    double least_mm = 0;
    double most_mm = 0;

    bool holds(double value_mm) const;
};

/// One entry: which holes, and what of them. A hole is chosen by all that is given.
struct HoleEntry {
    std::optional<SizeRange> diameter;
    std::optional<SizeRange> depth;
    std::vector<std::string> ids;  ///< of holes ("H3") and features ("S1.F2"); empty: any
    HoleMaking make = HoleMaking::Drill;
    std::optional<Thread> thread;  ///< to be tapped
    double thread_depth_mm = 0;    ///< of full thread; 0: as deep as the hole lets the tap go
    std::optional<Fit> fit;        ///< to be reamed or bored to
    std::string pointer;           ///< "#/holes/0", for messages
};

/// What the shop knows of holes that the part's file does not say: the first entry that chooses a hole holds.
struct HoleTable {
    std::string file;  ///< empty: no table was given
    std::string sha256;
    std::vector<HoleEntry> entries;
};

/// Reads a hole table (schemas/holes.schema.json) and converts it to mm.
/// \throws Error(InvalidCatalog) with "file#/json/pointer" as subject and what was expected: a breach of the
///         schema, a range whose end is below its start, a name of no thread; Error(FileUnreadable).
HoleTable readHoleTable(const std::filesystem::path& path, std::uintmax_t max_bytes = kMaxFileBytes);

/// The same from text already in memory.
HoleTable holeTableFromText(std::string_view text, const std::string& file_name);

}  // namespace stepmill
