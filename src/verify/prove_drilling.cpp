// How deep a drill goes in every hole, and in how many pecks.

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "stepmill/feature/hole_group.h"
#include "stepmill/sequence/drilling.h"
#include "verify/hole_places.h"
#include "verify/prove_state.h"

namespace stepmill::verify {
namespace {

/// P words are rounded to milliseconds [s].
constexpr double kDwellRoundingS = 1e-3;

void checkDepth(const ReadOperation& operation, const Vec2& axis, double tip_z_mm, const Findings& findings) {
    const ReadMove* lowest = nullptr;
    for (const ReadMove& read : operation.moves) {
        const Vec3& to = read.fed.move.to;
        if (isOver(to, axis) && (lowest == nullptr || to.z() < lowest->fed.move.to.z())) lowest = &read;
    }
    if (lowest != nullptr && lowest->fed.move.to.z() <= tip_z_mm + kSamePostedHeightMm) return;
    if (lowest == nullptr)
        findings.add(operation.line,
                     fmt::format("drills no hole {}, planned is one to Z{:.4f}", placeWords(axis), tip_z_mm));
    else
        findings.add(lowest->line, fmt::format("drills to Z{:.4f} {}, planned is Z{:.4f}",
                                               lowest->fed.move.to.z(), placeWords(axis), tip_z_mm));
}

/// A lift that breaks a chip, less what the last decimals of two heights leave of it [mm].
constexpr double kLeastLiftMm = kChipBreakLiftMm - 2 * kSamePostedHeightMm;

/// Chips come out when the drill is lifted out of the hole, and break when it is lifted at all: between two
/// such lifts it may sink a peck.
void checkPecks(const ReadOperation& operation, const RecordedOperation& planned, double top_z_mm,
                double tip_z_mm, const Findings& findings) {
    const bool breaks = planned.pattern == kChipBreakPattern;
    if (breaks && top_z_mm - tip_z_mm > kChipBreakDiameters * planned.tool.diameter_mm + kSamePostedHeightMm)
        findings.add(operation.line,
                     fmt::format("is too deep for its chips to be broken alone: over {:g} diameters",
                                 kChipBreakDiameters));
    double drilled_mm = top_z_mm;
    double emptied_at_mm = top_z_mm;
    Vec3 from = operation.start;
    for (const ReadMove& read : operation.moves) {
        const Vec3& to = read.fed.move.to;
        if (!isOver(to, from.head<2>())) drilled_mm = emptied_at_mm = top_z_mm;
        const bool lifted = breaks && to.z() - from.z() >= kLeastLiftMm;
        if (to.z() >= top_z_mm || lifted) emptied_at_mm = drilled_mm;
        drilled_mm = std::min(drilled_mm, to.z());
        from = to;
        const double sunk_mm = emptied_at_mm - drilled_mm;
        if (sunk_mm <= planned.step_down_mm + 2 * kSamePostedHeightMm) continue;
        findings.add(read.line,
                     fmt::format("drills {:.4f} mm without {}, planned are pecks of {:.4f} mm", sunk_mm,
                                 breaks ? "breaking the chip" : "coming out", planned.step_down_mm));
        return;
    }
}

}  // namespace

void proveDwells(const ReadOperation& operation, const RecordedOperation& planned, double tip_z_mm,
                 std::size_t holes, const Findings& findings) {
    std::size_t stays = 0;
    double shortest_s = std::numeric_limits<double>::infinity();
    for (const ReadDwell& dwell : operation.dwells) {
        if (dwell.z_mm > tip_z_mm + kSamePostedHeightMm) continue;
        ++stays;
        shortest_s = std::min(shortest_s, dwell.seconds);
    }
    const double stayed_s = stays >= holes ? shortest_s : 0;
    if (stayed_s < planned.dwell_s - kDwellRoundingS)
        findings.add(operation.line,
                     fmt::format("stays {:.3f} s at the bottom of the hole, planned are {:.3f} s", stayed_s,
                                 planned.dwell_s));
}

void proveDrilling(const ReadOperation& operation, const RecordedOperation& planned,
                   const FeatureState& state, const Findings& findings) {
    if (!planned.tool.isForHoles() || planned.tool.isTap()) return;
    if (!isHole(state.feature.feature_class) || state.feature.target.empty())
        return findings.add(operation.line, fmt::format("{}s what is no hole", toString(planned.role)));
    const double tip_z_mm = lowestZ(planned, state.feature);
    const std::vector<Vec2> axes = holeCentres(state.feature);
    for (const Vec2& axis : axes)
        checkDepth(operation, axis, tip_z_mm, findings);
    checkPecks(operation, planned, state.feature.top_z_mm, tip_z_mm, findings);
    proveDwells(operation, planned, tip_z_mm, axes.size(), findings);
}

}  // namespace stepmill::verify
