#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/core/file.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// What holds the part in a setup and stays where it is while the part is cut: an upright block, in setup
/// coordinates. Cutter, shank and holder keep clear of it.
struct Fixture {
    std::string name;  ///< "clamp left"
    Region section;
    double bottom_z_mm = 0;
    double top_z_mm = 0;
};

/// Fixtures are planned with larger by this share of their size: they are measured by eye and set by hand
/// [docs/fixtures.md, after Tripathi2005].
inline constexpr double kFixtureGrowth = 0.05;

/// How the shop clamps a part: the fixtures of each setup it names.
struct FixtureFile {
    std::string file;    ///< empty: no file was given
    std::string sha256;  ///< of the file
    double growth = kFixtureGrowth;
    std::map<std::string, std::vector<Fixture>> setups;  ///< by setup id; as they are, not grown
};

/// Reads a fixture file (schemas/fixtures.schema.json) and converts it to mm. An outline may run either way.
/// \throws Error(InvalidCatalog) with "file#/json/pointer" as subject and what was expected: a breach of the
///         schema, a setup named twice, a top that is not above the bottom, an outline that crosses itself;
///         Error(FileUnreadable).
FixtureFile readFixtures(const std::filesystem::path& path, std::uintmax_t max_bytes = kMaxFileBytes);

/// The same from text already in memory.
FixtureFile fixturesFromText(std::string_view text, const std::string& file_name);

}  // namespace stepmill
