#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "stepmill/catalog/blank.h"
#include "stepmill/catalog/vise.h"
#include "stepmill/core/file.h"
#include "stepmill/planar/region.h"

namespace stepmill {

enum class FixtureKind {
    Clamp,     ///< a block that the shop puts there
    Jaw,       ///< of the vise
    Screw,     ///< the head of one that goes through the part
    HeldStock  ///< stock that is held and therefore not cut in this setup
};

/// "clamp", "jaw", "screw", "held stock".
std::string toString(FixtureKind kind);
/// The reverse; nothing for another word.
std::optional<FixtureKind> fixtureKindFrom(std::string_view word);

/// What holds the part in a setup and stays where it is while the part is cut: an upright block, in setup
/// coordinates. Cutter, shank and holder keep clear of it.
struct Fixture {
    std::string name;  ///< "clamp left"
    Region section;
    double bottom_z_mm = 0;
    double top_z_mm = 0;
    FixtureKind kind = FixtureKind::Clamp;
};

/// A fixture that is a solid in a STEP file, and how it stands in its setup.
struct FixtureSolid {
    std::string name;            ///< "vise"
    std::string pointer;         ///< where it is named: "clamps.json#/setups/0/solids/0"
    std::filesystem::path file;  ///< as named there; a relative one stands beside the fixture file
    Eigen::Isometry3d to_setup = Eigen::Isometry3d::Identity();  ///< upright: of the file's coordinates
};

/// Fixtures are planned with larger by this share of the radius of the widest cutter or holder, for they are
/// measured by eye and set by hand: all keep off them as if they were as much wider, R' = 1.05 R
/// [Tripathi2005; docs/fixtures.md].
inline constexpr double kFixtureGrowth = 0.05;

/// How thick the shop's sacrificial plates are [mm]: cutters may go that deep below what lies on one.
inline constexpr double kPlateThicknessMm = 12;

/// How the shop clamps a part: the fixtures of each setup it names, and what holds the others.
struct FixtureFile {
    std::string file;                                    ///< empty: no file was given
    std::string sha256;                                  ///< of the file
    double growth = kFixtureGrowth;                      ///< share of that radius
    std::map<std::string, std::vector<Fixture>> setups;  ///< by setup id; as they are, not grown
    /// Not read yet, by setup id, each of which `setups` has too: readFixturesWithSolids() makes them blocks
    /// there [layers/fixture_solids.h].
    std::map<std::string, std::vector<FixtureSolid>> solids;
    Vise vise;
    double plate_mm = kPlateThicknessMm;
    BlankRule blank;
};

/// Reads a fixture file (schemas/fixtures.schema.json) and converts it to mm. An outline may run either way.
/// The files of solids it names are not opened.
/// \throws Error(InvalidCatalog) with "file#/json/pointer" as subject and what was expected: a breach of the
///         schema, a setup named twice, a top that is not above the bottom, an outline that crosses itself;
///         Error(FileUnreadable).
FixtureFile readFixtures(const std::filesystem::path& path, std::uintmax_t max_bytes = kMaxFileBytes);

/// The same from text already in memory.
FixtureFile fixturesFromText(std::string_view text, const std::string& file_name);

}  // namespace stepmill
