#pragma once

#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"

namespace stepmill {

/// From the tip to the gauge line, where the holder sits in the spindle: the top of its last cylinder, or the
/// stick-out of a tool without one [mm].
double gaugeLengthMm(const ToolAssembly& tool);

/// The tool as it stands in the machine: over its holder the spindle's nose, as far up as that is told. What
/// keeps clear of holders keeps clear of the nose. A tool of a machine without a nose stays as it is.
ToolAssembly inSpindle(ToolAssembly tool, const Machine& machine);

}  // namespace stepmill
