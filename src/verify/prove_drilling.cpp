// How deep a drill goes, and in how many pecks.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stepmill/sequence/drilling.h"
#include "verify/prove_state.h"

namespace stepmill::verify {
namespace {

/// P words are rounded to milliseconds [s].
constexpr double kDwellRoundingS = 1e-3;

/// How deep the tip must come; nothing for what is no hole.
double plannedTipZ(const RecordedOperation& planned, const Feature& feature) {
    return std::min(planned.z_floor_mm, drillTipZ(feature, planned.tool));
}

void checkDepth(const ReadOperation& operation, double tip_z_mm, const Findings& findings) {
    const ReadMove* lowest = nullptr;
    for (const ReadMove& read : operation.moves)
        if (lowest == nullptr || read.fed.move.to.z() < lowest->fed.move.to.z()) lowest = &read;
    if (lowest != nullptr && lowest->fed.move.to.z() <= tip_z_mm + kSamePostedHeightMm) return;
    findings.add(lowest == nullptr ? operation.line : lowest->line,
                 fmt::format("drills to Z{:.4f}, planned is Z{:.4f}",
                             lowest == nullptr ? 0.0 : lowest->fed.move.to.z(), tip_z_mm));
}

/// Chips come out when the drill is lifted out of the hole: between two such lifts it may sink a peck.
void checkPecks(const ReadOperation& operation, const RecordedOperation& planned, double top_z_mm,
                const Findings& findings) {
    double drilled_mm = top_z_mm;
    double emptied_at_mm = top_z_mm;
    for (const ReadMove& read : operation.moves) {
        const double z_mm = read.fed.move.to.z();
        if (z_mm >= top_z_mm) emptied_at_mm = drilled_mm;
        drilled_mm = std::min(drilled_mm, z_mm);
        const double sunk_mm = emptied_at_mm - drilled_mm;
        if (sunk_mm <= planned.step_down_mm + 2 * kSamePostedHeightMm) continue;
        findings.add(read.line,
                     fmt::format("drills {:.4f} mm without coming out, planned are pecks of {:.4f} mm",
                                 sunk_mm, planned.step_down_mm));
        return;
    }
}

void checkDwell(const ReadOperation& operation, const RecordedOperation& planned, double tip_z_mm,
                const Findings& findings) {
    double stayed_s = 0;
    for (const ReadDwell& dwell : operation.dwells)
        if (dwell.z_mm <= tip_z_mm + kSamePostedHeightMm) stayed_s += dwell.seconds;
    if (stayed_s < planned.dwell_s - kDwellRoundingS)
        findings.add(operation.line,
                     fmt::format("stays {:.3f} s at the bottom of the hole, planned are {:.3f} s", stayed_s,
                                 planned.dwell_s));
}

}  // namespace

void proveDrilling(const ReadOperation& operation, const RecordedOperation& planned,
                   const FeatureState& state, const Findings& findings) {
    if (!planned.tool.isDrill()) return;
    const double tip_z_mm = plannedTipZ(planned, state.feature);
    checkDepth(operation, tip_z_mm, findings);
    checkPecks(operation, planned, state.feature.top_z_mm, findings);
    checkDwell(operation, planned, tip_z_mm, findings);
}

}  // namespace stepmill::verify
