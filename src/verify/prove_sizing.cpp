// Reamers and boring heads: the bore before them, their own width, and how deep they go.

#include <algorithm>

#include <fmt/format.h>

#include "stepmill/feature/hole_group.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/sizing.h"
#include "stepmill/toolpath/swept_region.h"
#include "verify/prove_state.h"

namespace stepmill::verify {
namespace {

/// Nothing stands in the bore nearer to its axis than the tool may find it.
std::string boreTrouble(const RecordedOperation& planned, const FeatureState& state, const Tolerances& tol) {
    const Feature& feature = state.feature;
    const double tip_z_mm = sizerTipZ(feature, planned.tool, planned.z_floor_mm);
    const Region& standing = state.standingAt(std::max(tip_z_mm, feature.floor_z_mm));
    const double before_mm = boreBefore(planned.tool, 2 * holeRadiusMm(feature)).least_mm;
    for (const Vec2& axis : holeCentres(feature)) {
        const Region in_bore = intersect(standing, makeCircle(axis, before_mm / 2), tol);
        if (!toolpath::piecesBeyondSkins(in_bore, tol).empty())
            return fmt::format("comes to Z{:.4f} where no bore of {:.4f} mm is made before", tip_z_mm,
                               before_mm);
    }
    return {};
}

/// A blind bore ends under the tip; a through one has its whole width down to the far side.
std::string depthTrouble(const RecordedOperation& planned, const Feature& feature) {
    const double tip_z_mm = sizerTipZ(feature, planned.tool, planned.z_floor_mm);
    if (!feature.through && tip_z_mm < feature.floor_z_mm - kSamePostedHeightMm)
        return fmt::format("goes to Z{:.4f}, the bore ends at Z{:.4f}", tip_z_mm, feature.floor_z_mm);
    if (feature.through && planned.z_floor_mm < feature.floor_z_mm - kSamePostedHeightMm)
        return fmt::format("sizes the bore down to Z{:.4f}, the hole ends at Z{:.4f}", planned.z_floor_mm,
                           feature.floor_z_mm);
    return {};
}

/// A rapid in the bore marks its wall.
void checkWays(const ReadOperation& operation, double top_z_mm, const Findings& findings) {
    double from_z_mm = operation.start.z();
    for (const ReadMove& read : operation.moves) {
        const double low_z_mm = std::min(from_z_mm, read.fed.move.to.z());
        from_z_mm = read.fed.move.to.z();
        if (read.fed.move.kind != MoveKind::Rapid || low_z_mm >= top_z_mm - kSamePostedHeightMm) continue;
        return findings.add(read.line, fmt::format("a rapid goes to Z{:.4f}, into the bore", low_z_mm));
    }
}

}  // namespace

void proveSizing(const ReadOperation& operation, const RecordedOperation& planned, const FeatureState& state,
                 const Tolerances& tol, const Findings& findings) {
    const Feature& feature = state.feature;
    if (!planned.tool.isSizer() || !isHole(feature.feature_class) || feature.target.empty()) return;
    const auto tell = [&](const std::string& trouble) {
        if (!trouble.empty()) findings.add(operation.line, trouble);
    };
    const double bored_to_z_mm =
        feature.through ? feature.floor_z_mm : planned.z_floor_mm - planned.tool.lead_mm;
    tell(planned.fit ? sizingTrouble({feature, *planned.fit, bored_to_z_mm, state.safe_z_mm}, planned.tool)
                     : "sizes a bore to no fit");
    tell(depthTrouble(planned, feature));
    tell(boreTrouble(planned, state, tol));
    checkWays(operation, feature.top_z_mm, findings);
}

}  // namespace stepmill::verify
