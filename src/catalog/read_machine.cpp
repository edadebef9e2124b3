// Machine files.

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "catalog/embedded.h"
#include "catalog/schema_check.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/catalog/spindle.h"
#include "stepmill/core/error.h"

namespace stepmill {

using nlohmann::json;

namespace {

/// Cylinders from below to above.
/// \throws Error(InvalidCatalog) with the pointer of one that is not
std::vector<HolderCylinder> spindleNose(const json& machine, const std::string& file_name) {
    std::vector<HolderCylinder> nose;
    if (!machine.contains("spindle_nose")) return nose;
    for (std::size_t i = 0; i < machine["spindle_nose"].size(); ++i) {
        const json& from = machine["spindle_nose"][i];
        const HolderCylinder cylinder{from["diameter_mm"], from["bottom_mm"], from["top_mm"]};
        const std::string pointer = fmt::format("{}#/spindle_nose/{}", file_name, i);
        if (cylinder.top_mm <= cylinder.bottom_mm)
            throw Error(ErrorCode::InvalidCatalog, pointer + "/top_mm",
                        fmt::format("expected more than the bottom, {:g}, found {:g}", cylinder.bottom_mm,
                                    cylinder.top_mm));
        const double above_mm = nose.empty() ? 0 : nose.back().top_mm;
        if (cylinder.bottom_mm < above_mm)
            throw Error(ErrorCode::InvalidCatalog, pointer + "/bottom_mm",
                        fmt::format("expected at least the top of the cylinder below, {:g}, found {:g}",
                                    above_mm, cylinder.bottom_mm));
        nose.push_back(cylinder);
    }
    return nose;
}

/// What two fields of the spindle say together.
/// \throws Error(InvalidCatalog) with the pointer of the wrong one
class SpindleReader {
  public:
    SpindleReader(const json& machine, const std::string& file_name)
        : curve_(machine["spindle"]["curve"]),
          max_speed_rpm_(machine["max_speed_rpm"]),
          pointer_(file_name + "#/spindle/curve") {}

    std::vector<SpindlePoint> curve() const {
        std::vector<SpindlePoint> points;
        for (std::size_t i = 0; i < curve_.size(); ++i) {
            const json& from = curve_[i];
            points.push_back({from["speed_rpm"], from["power_kw"], from["torque_nm"]});
            const std::string pointer = fmt::format("{}/{}", pointer_, i);
            checkAgreement(points.back(), pointer);
            if (i > 0 && points[i].speed_rpm <= points[i - 1].speed_rpm)
                fail(pointer + "/speed_rpm",
                     fmt::format("expected more than the speed before, {:g}, found {:g}",
                                 points[i - 1].speed_rpm, points[i].speed_rpm));
        }
        if (points.back().speed_rpm < max_speed_rpm_)
            fail(pointer_, fmt::format("expected points up to max_speed_rpm, {:g}; the last is at {:g}",
                                       max_speed_rpm_, points.back().speed_rpm));
        return points;
    }

  private:
    void checkAgreement(const SpindlePoint& point, const std::string& pointer) const {
        const double power_kw = point.torque_nm * point.speed_rpm / kNmRpmPerKw;
        if (std::abs(power_kw - point.power_kw) > kAgreeingShare * point.power_kw)
            fail(pointer + "/power_kw",
                 fmt::format("expected the power of {:g} Nm at {:g} rpm, {:.3g} kW, found {:g}",
                             point.torque_nm, point.speed_rpm, power_kw, point.power_kw));
    }

    [[noreturn]] static void fail(const std::string& pointer, const std::string& what) {
        throw Error(ErrorCode::InvalidCatalog, pointer, what);
    }

    /// Torque and power of makers' sheets are rounded.
    static constexpr double kAgreeingShare = 0.05;

    const json& curve_;
    double max_speed_rpm_;
    std::string pointer_;
};

std::array<double, 2> gaugeOverTable(const json& range, const std::string& file_name) {
    const std::array<double, 2> found = range.get<std::array<double, 2>>();
    if (found[1] <= found[0])
        throw Error(ErrorCode::InvalidCatalog, file_name + "#/gauge_over_table_mm/1",
                    fmt::format("expected more than the lowest, {:g}, found {:g}", found[0], found[1]));
    return found;
}

}  // namespace

Machine machineFromText(std::string_view text, const std::string& file_name) {
    const ParsedJson parsed = checkedJson(text, schemaJson(SchemaName::Machine));
    throwFirstError(parsed.findings, file_name);
    const json& from = parsed.value;
    Machine machine;
    machine.name = from["name"];
    machine.rapid_mm_per_min = from["rapid_mm_per_min"];
    machine.max_feed_mm_per_min = from["max_feed_mm_per_min"];
    machine.max_speed_rpm = from["max_speed_rpm"];
    machine.tool_change_s = from["tool_change_s"];
    machine.setup_time_min = from.value("setup_time_min", machine.setup_time_min);
    machine.indexed_setup_time_min = from.value("indexed_setup_time_min", machine.indexed_setup_time_min);
    machine.load_time_s = from.value("load_time_s", machine.load_time_s);
    machine.hourly_rate = from["hourly_rate"];
    machine.currency = from["currency"];
    machine.travel_mm = from["travel_mm"].get<std::array<double, 3>>();
    machine.magazine_size = from["magazine_size"];
    machine.acceleration_mm_per_s2 = from.value("acceleration_mm_per_s2", 0.0);
    machine.junction_deviation_mm = from.value("junction_deviation_mm", machine.junction_deviation_mm);
    machine.safe_height_mm = from["safe_height_mm"];
    const auto lengthOr = [&](const char* field, double otherwise_mm) {
        if (from.contains(field)) return from[field].get<double>();
        machine.by_default.push_back(fmt::format("{} {:g}", field, otherwise_mm));
        return otherwise_mm;
    };
    machine.side_clearance_mm = lengthOr("side_clearance_mm", kSideClearanceMm);
    machine.top_clearance_mm = lengthOr("top_clearance_mm", kTopClearanceMm);
    machine.inside_clearance_mm = lengthOr("inside_clearance_mm", kInsideClearanceMm);
    machine.holder_clearance_mm = lengthOr("holder_clearance_mm", kHolderClearanceMm);
    machine.spindle_nose = spindleNose(from, file_name);
    if (machine.spindle_nose.empty())
        machine.by_default.push_back("no spindle_nose: nothing over the holders is kept clear");
    if (from.contains("spindle")) {
        machine.spindle_curve = SpindleReader(from, file_name).curve();
        machine.spindle_efficiency = from["spindle"]["efficiency"];
    } else {
        machine.by_default.push_back("no spindle: feeds are the library's, whatever is cut");
    }
    if (from.contains("gauge_over_table_mm"))
        machine.gauge_over_table_mm = gaugeOverTable(from["gauge_over_table_mm"], file_name);
    machine.column_behind_mm = from.value("column_behind_mm", 0.0);
    machine.dialect = from["dialect"];
    machine.home_by = homeByFrom(from.value("home_by", ""));
    if (from.contains("part_change_mm"))
        machine.part_change_mm = from["part_change_mm"].get<std::array<double, 2>>();
    return machine;
}

Machine readMachine(const std::filesystem::path& path, std::uintmax_t max_bytes) {
    return machineFromText(readFile(path, max_bytes), path.filename().string());
}

Machine defaultMachine() {
    return machineFromText(embedded::kDefaultMachine, "machine_vmc.json");
}

}  // namespace stepmill
