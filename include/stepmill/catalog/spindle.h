#pragma once

#include <optional>

#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"

namespace stepmill {

/// Nm times rev/min that make a kilowatt: 60000 / (2 pi).
inline constexpr double kNmRpmPerKw = 9549.2966;

/// From the tip to the gauge line, where the holder sits in the spindle: the top of its last cylinder, or the
/// stick-out of a tool without one [mm].
double gaugeLengthMm(const ToolAssembly& tool);

/// The tool as it stands in the machine: its holder with the machine's clearance, over it the spindle's nose,
/// as far up as that is told. What keeps clear of holders keeps clear of the nose.
ToolAssembly inSpindle(ToolAssembly tool, const Machine& machine);

/// What the spindle's motor gives at a speed.
struct SpindlePower {
    double power_kw = 0;
    bool by_torque = false;  ///< below the speed at which it first gives its most: its torque is the limit
};

/// By the machine's curve; nothing where it has none. Nothing is left beyond the curve's last speed.
std::optional<SpindlePower> spindlePower(const Machine& machine, double speed_rpm);

}  // namespace stepmill
