// The engagement of an adaptive operation's cuts.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stepmill/core/units.h"
#include "verify/prove_operation.h"

namespace stepmill::verify {
void proveEngagement(const ReadOperation& operation, const RecordedOperation& planned,
                     const CutGround& ground, double top_z_mm, const Findings& findings) {
    CutFollower follower(ground, planned.tool.radius_mm(), planned.step_down_mm, kProofCuspShare,
                         CutMeasures::WidthsAndAngles);
    const double allowed_rad = degToRad(planned.engagement_deg) * (1 + kProofAngleShare);
    Vec3 from = operation.start;
    for (const ReadMove& read : operation.moves) {
        const Move& move = read.fed.move;
        const MoveCut cut = follower.next(from, move);
        const double whole_mm =
            std::min(planned.step_down_mm, top_z_mm - std::min(from.z(), move.to.z())) - kDepthRoundingMm;
        from = move.to;
        // What a way in has left of its slope is no cut at depth.
        if (cut.depth_mm < whole_mm || cut.engaged_rad <= allowed_rad) continue;
        findings.add(read.line, fmt::format("engages {:.1f} degrees of the cutter's rim; planned are {:.1f}",
                                            radToDeg(cut.engaged_rad), planned.engagement_deg));
        return;
    }
}

}  // namespace stepmill::verify
