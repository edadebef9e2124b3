#pragma once

#include "report/page/element.h"
#include "stepmill/plan/plan.h"

namespace stepmill::report {

/// One step of a feature's sequence seen from the spindle: target, obstruction, the area the tool sweeps,
/// its path in the deepest layer, and what stays after the whole sequence. `step` indexes
/// planned.sequence.steps; `path` is the operation's.
Element stepDrawing(const PlannedFeature& planned, std::size_t step, const Toolpath& path);

/// A feature no tool can machine: target, obstruction and what stays.
Element unmachinedDrawing(const PlannedFeature& planned);

/// All features of a setup on its stock, each in its own tint.
Element setupDrawing(const PlannedSetup& setup);

}  // namespace stepmill::report
