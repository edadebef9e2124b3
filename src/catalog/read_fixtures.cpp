#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "catalog/schema_check.h"
#include "stepmill/catalog/fixture.h"
#include "stepmill/catalog/json_text.h"
#include "stepmill/core/enum_words.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

using nlohmann::json;

/// No machine has a fixture farther off: a unit gone wrong [mm].
constexpr double kFarthestMm = 1e4;
/// A fixture as thin is a slip of the pen: heights in plan.json have six decimals [mm].
constexpr double kThinnestMm = 1e-3;

constexpr EnumWord<FixtureKind> kFixtureKinds[] = {{FixtureKind::Clamp, "clamp"},
                                                   {FixtureKind::Jaw, "jaw"},
                                                   {FixtureKind::Screw, "screw"},
                                                   {FixtureKind::HeldStock, "held stock"}};

/// Turns what points up in a file, "+x" to "-z", to the spindle: its x stays x, or where x points up or down
/// its y becomes x.
Eigen::Matrix3d uprightAxes(const std::string& up) {
    Eigen::Vector3d z = Eigen::Vector3d::Zero();
    z[up[1] - 'x'] = up[0] == '-' ? -1 : 1;
    const Eigen::Vector3d x = up[1] == 'x' ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
    Eigen::Matrix3d rows;
    rows << x.transpose(), z.cross(x).transpose(), z.transpose();
    return rows;
}

/// Reads a document that keeps the schema.
class FixtureReader {
  public:
    FixtureReader(const json& from, std::string file_name) : from_(from), file_name_(std::move(file_name)) {
        if (from["unit"] == "inch") mm_per_unit_ = kMillimetresPerInch;
    }

    FixtureFile read() const {
        FixtureFile file;
        file.file = file_name_;
        file.growth = from_.value("growth", kFixtureGrowth);
        if (from_.contains("vise")) file.vise = vise(from_["vise"]);
        if (from_.contains("plate")) file.plate_mm = length(from_["plate"], "#/plate");
        if (from_.contains("blank")) file.blank = blank(from_["blank"]);
        for (std::size_t i = 0; i < from_["setups"].size(); ++i) {
            const json& setup = from_["setups"][i];
            const std::string pointer = fmt::format("#/setups/{}", i);
            const auto [entry, is_new] = file.setups.try_emplace(setup["setup"]);
            if (!is_new)
                fail(pointer + "/setup",
                     fmt::format("expected every setup once, found {} again", entry->first));
            for (std::size_t k = 0; k < setup["fixtures"].size(); ++k)
                entry->second.push_back(
                    fixture(setup["fixtures"][k], fmt::format("{}/fixtures/{}", pointer, k)));
            if (!setup.contains("solids")) continue;
            for (std::size_t k = 0; k < setup["solids"].size(); ++k)
                file.solids[entry->first].push_back(
                    solid(setup["solids"][k], fmt::format("{}/solids/{}", pointer, k)));
        }
        return file;
    }

  private:
    [[noreturn]] void fail(const std::string& pointer, const std::string& what) const {
        throw Error(ErrorCode::InvalidCatalog, file_name_ + pointer, what);
    }

    double length(const json& value, const std::string& pointer) const {
        const double length_mm = value.get<double>() * mm_per_unit_;
        if (std::abs(length_mm) > kFarthestMm)
            fail(pointer,
                 fmt::format("expected no more than {:g} m, found {}", kFarthestMm / 1000, value.dump()));
        return length_mm;
    }

    void read(const json& from, const char* field, const std::string& pointer, double& into) const {
        if (from.contains(field)) into = length(from[field], fmt::format("{}/{}", pointer, field));
    }

    void read(const json& from, const char* field, const std::string& pointer,
              std::vector<double>& into) const {
        if (!from.contains(field)) return;
        into.clear();
        for (std::size_t i = 0; i < from[field].size(); ++i)
            into.push_back(length(from[field][i], fmt::format("{}/{}/{}", pointer, field, i)));
        std::sort(into.begin(), into.end());
    }

    Vise vise(const json& from) const {
        Vise vise;
        read(from, "opening", "#/vise", vise.opening_mm);
        read(from, "jaw_width", "#/vise", vise.jaw_width_mm);
        read(from, "jaw_height", "#/vise", vise.jaw_height_mm);
        read(from, "jaw_thickness", "#/vise", vise.jaw_thickness_mm);
        read(from, "parallels", "#/vise", vise.parallels_mm);
        read(from, "grip", "#/vise", vise.grip_mm);
        read(from, "jaw_clearance", "#/vise", vise.jaw_clearance_mm);
        if (vise.grip_mm > vise.jaw_height_mm)
            fail("#/vise/grip", fmt::format("expected no more than the jaws' height, {:g} mm, found {:g} mm",
                                            vise.jaw_height_mm, vise.grip_mm));
        return vise;
    }

    BlankRule blank(const json& from) const {
        BlankRule rule;
        read(from, "side", "#/blank", rule.side_mm);
        read(from, "top", "#/blank", rule.top_mm);
        read(from, "sizes", "#/blank", rule.sizes_mm);
        return rule;
    }

    Fixture fixture(const json& from, const std::string& pointer) const {
        Fixture fixture;
        fixture.name = from["name"];
        fixture.bottom_z_mm = length(from["bottom"], pointer + "/bottom");
        fixture.top_z_mm = length(from["top"], pointer + "/top");
        if (fixture.top_z_mm < fixture.bottom_z_mm + kThinnestMm)
            fail(pointer + "/top", fmt::format("expected a top above the bottom ({}), found {}",
                                               from["bottom"].dump(), from["top"].dump()));
        fixture.section = outline(from["outline"], pointer + "/outline");
        return fixture;
    }

    FixtureSolid solid(const json& from, const std::string& pointer) const {
        FixtureSolid solid;
        solid.name = from["name"];
        solid.pointer = file_name_ + pointer;
        const std::string file = from["file"];
        if (plainLine(file) != file)
            fail(pointer + "/file", "expected a file's name of printable characters");
        solid.file = file;
        const double turn_rad = degToRad(from.value("turn", 0.0));
        Eigen::Vector3d origin_mm;
        for (int axis = 0; axis < 3; ++axis)
            origin_mm[axis] = length(from["at"][axis], fmt::format("{}/at/{}", pointer, axis));
        solid.to_setup = Eigen::Translation3d(origin_mm) *
                         Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()) *
                         Eigen::Isometry3d(uprightAxes(from.value("up", "+z")));
        return solid;
    }

    Region outline(const json& from, const std::string& pointer) const {
        std::vector<Vec2> corners;
        for (std::size_t i = 0; i < from.size(); ++i) {
            const std::string corner = fmt::format("{}/{}", pointer, i);
            corners.emplace_back(length(from[i][0], corner + "/0"), length(from[i][1], corner + "/1"));
        }
        Region section = makePolygon(corners);
        if (const auto fault = diagnose(section))
            fail(pointer, "expected corners of an outline that does not cross itself: " + *fault);
        return section;
    }

    const json& from_;
    std::string file_name_;
    double mm_per_unit_ = 1;
};

}  // namespace

std::string toString(FixtureKind kind) {
    return wordOf(kFixtureKinds, kind);
}

std::optional<FixtureKind> fixtureKindFrom(std::string_view word) {
    return valueOf(kFixtureKinds, word);
}

FixtureFile fixturesFromText(std::string_view text, const std::string& file_name) {
    const ParsedJson parsed = checkedJson(text, schemaJson(SchemaName::Fixtures));
    throwFirstError(parsed.findings, file_name);
    FixtureFile file = FixtureReader(parsed.value, file_name).read();
    file.sha256 = sha256(text);
    return file;
}

FixtureFile readFixtures(const std::filesystem::path& path, std::uintmax_t max_bytes) {
    return fixturesFromText(readFile(path, max_bytes), path.filename().string());
}

}  // namespace stepmill
