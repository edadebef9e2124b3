#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/catalog/tool.h"
#include "stepmill/core/units.h"

namespace stepmill {

/// Clearances of machine files that do not name them [mm].
inline constexpr double kSideClearanceMm = 2;
inline constexpr double kTopClearanceMm = 2;
inline constexpr double kInsideClearanceMm = 0.5;
/// As exactly as a cutter is set out of its holder by a rule.
inline constexpr double kHolderClearanceMm = 1;

/// What making ready for a clamping takes where the machine file does not say [min].
inline constexpr double kSetupTimeMin = 20;
inline constexpr double kIndexedSetupTimeMin = 40;
/// What clamping and releasing a piece takes where the machine file does not say [s].
inline constexpr double kLoadTimeS = 60;

/// How a program takes the spindle up to the top of its travel.
enum class HomeBy {
    G53,     ///< G53 G0 Z0: to the machine's own zero
    G28,     ///< G91 G28 Z0: to the place that G28 is set to
    Nothing  ///< not at all: the machine has no such place
};
std::string toString(HomeBy way);
/// The reverse; nothing for another word.
std::optional<HomeBy> homeByFrom(std::string_view word);

/// What the spindle gives at a speed. Between two points power grows evenly with speed; below the first one
/// the torque stays, beyond the last one there is nothing.
struct SpindlePoint {
    double speed_rpm = 0;
    double power_kw = 0;
    double torque_nm = 0;
};

/// What a milling machine can do and what its hour costs. Zero means "not given"; the comments say what then
/// holds.
struct Machine {
    std::string name;
    double rapid_mm_per_min = 0;
    double max_feed_mm_per_min = 0;  ///< 0: no limit
    double max_speed_rpm = 0;        ///< 0: no limit
    double tool_change_s = 0;        ///< chip to chip
    /// To make ready for a clamping, once a lot, and for one that is tilted off the box's directions [min].
    double setup_time_min = kSetupTimeMin;
    double indexed_setup_time_min = kIndexedSetupTimeMin;
    double load_time_s = kLoadTimeS;  ///< to clamp and release a piece, in each clamping [s]
    double hourly_rate = 0;           ///< 0: machine time is free
    std::string currency;
    std::array<double, 3> travel_mm{};  ///< along x, y, z; 0: not checked
    int magazine_size = 0;              ///< places for tools; 0: no limit
    double acceleration_mm_per_s2 = 0;  ///< of the axes; 0: not given, times are those of the feeds alone
    /// How far the axes may cut a corner short to go round it without a stop; also without acceleration
    /// given.
    double junction_deviation_mm = 0.01;
    /// The spindle over the tool: cylinders from the gauge line up, heights over that line; empty: not given.
    std::vector<HolderCylinder> spindle_nose;
    /// What the spindle's motor gives, by ascending speed; empty: not given, nothing is checked against it.
    std::vector<SpindlePoint> spindle_curve;
    double spindle_efficiency = 1;  ///< what of the motor's power gets to the cutter
    /// How near to the table and how far over it the gauge line may be; 0, 0: not checked.
    std::array<double, 2> gauge_over_table_mm{};
    /// How far behind the spindle's axis, towards +Y, the machine's column stands; 0: not given, not checked.
    double column_behind_mm = 0;
    double safe_height_mm = 0;       ///< retract this far over the stock's top between features
    double side_clearance_mm = 0;    ///< rapids down beside the stock keep this off it, as large as it may be
    double top_clearance_mm = 0;     ///< rapids over a raw top keep this off it, as high as it may be
    double inside_clearance_mm = 0;  ///< rapids down inside the part keep this off what stands there
    double holder_clearance_mm = 0;  ///< holders and nose keep this off all that stands, beside and below
    /// Fields the file does not name and what then holds, for people: "side_clearance_mm 2".
    std::vector<std::string> by_default;
    std::string dialect;            ///< post processor: "linuxcnc", "fanuc", "grbl"
    std::optional<HomeBy> home_by;  ///< empty: as is usual for the dialect
    /// Where the table goes at the end of a program, x and y in the machine's own coordinates; empty: it
    /// stays.
    std::optional<std::array<double, 2>> part_change_mm;

    double settingUpMin(bool indexed) const { return indexed ? indexed_setup_time_min : setup_time_min; }
    /// Of its time, at the hourly rate.
    double costOf(double seconds) const { return seconds / kSecondsPerHour * hourly_rate; }
};

}  // namespace stepmill
