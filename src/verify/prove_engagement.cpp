// The engagement of an adaptive operation's cuts.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stepmill/core/units.h"
#include "verify/prove_operation.h"

namespace stepmill::verify {
namespace {

/// The angle may be so much over the planned one: between two positions looked at, and by rounding.
constexpr double kRimAngleShare = 0.02;
/// Swept ground counts as narrower by this share of the radius, as for widths.
constexpr double kRimCuspShare = 0.005;
/// Heights are rounded twice [mm].
constexpr double kShallowMm = 2e-3;

}  // namespace

void proveEngagement(const ReadOperation& operation, const RecordedOperation& planned,
                     const CutGround& ground, double top_z_mm, const Findings& findings) {
    CutFollower follower(ground, planned.tool.radius_mm(), planned.step_down_mm, kRimCuspShare,
                         CutMeasures::WidthsAndAngles);
    const double allowed_rad = degToRad(planned.engagement_deg) * (1 + kRimAngleShare);
    Vec3 from = operation.start;
    for (const ReadMove& read : operation.moves) {
        const Move& move = read.fed.move;
        const MoveCut cut = follower.next(from, move);
        const double whole_mm =
            std::min(planned.step_down_mm, top_z_mm - std::min(from.z(), move.to.z())) - kShallowMm;
        from = move.to;
        // What a way in has left of its slope is no cut at depth.
        if (cut.depth_mm < whole_mm || cut.engaged_rad <= allowed_rad) continue;
        findings.add(read.line, fmt::format("engages {:.1f} degrees of the cutter's rim; planned are {:.1f}",
                                            cut.engaged_rad * 180 / kPi, planned.engagement_deg));
        return;
    }
}

}  // namespace stepmill::verify
