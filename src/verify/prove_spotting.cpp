// Spot drills: a cone in the hole, the whole width over it.

#include <fmt/format.h>

#include "stepmill/sequence/spotting.h"
#include "verify/prove_state.h"

namespace stepmill::verify {

void proveStarting(const ReadOperation& operation, const RecordedOperation& planned,
                   const FeatureState& state, const Findings& findings) {
    if (!planned.tool.isSpot()) return;
    if (!spotFits(state.feature, planned.tool))
        findings.add(
            operation.line,
            fmt::format("{} cannot start the hole: it is too shallow, or something stands in the way",
                        planned.tool.id));
    else if (planned.z_floor_mm < state.feature.floor_z_mm - kSamePostedHeightMm)
        findings.add(operation.line, fmt::format("spots down to Z{:.4f}, below the floor at Z{:.4f}",
                                                 planned.z_floor_mm, state.feature.floor_z_mm));
}

}  // namespace stepmill::verify
