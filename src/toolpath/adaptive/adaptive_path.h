#pragma once

#include <optional>

#include "stepmill/toolpath/toolpath.h"
#include "toolpath/patterns/ring_family.h"

namespace stepmill::toolpath {

/// The task at constant engagement over all depths of cut, in bites: docs/algorithms/adaptive.md. Nothing
/// where that cannot take less than `to_beat_s`, where a region has no way in for it (neither cleared ground
/// nor an open side nor a helix), or where some of the ground cannot be cleared without engaging more.
/// \param family  of the task
std::optional<Toolpath> adaptivePath(const ClearingTask& task, const RingFamily& family,
                                     const ToolAssembly& tool, const CuttingData& cutting,
                                     const Machine& machine, const Tolerances& tol, double to_beat_s);

}  // namespace stepmill::toolpath
