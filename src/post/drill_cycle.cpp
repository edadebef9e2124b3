#include "post/drill_cycle.h"

#include <algorithm>

namespace stepmill {
namespace {

/// Positions closer than this are one: what the decimals of a program leave of equality [mm].
constexpr double kSamePlaceMm = 1e-3;

bool above(const Vec3& a, const Vec3& b) {
    return (a.head<2>() - b.head<2>()).norm() <= kSamePlaceMm;
}

}  // namespace

std::optional<FoundCycle> findCycle(const JobOperation& operation) {
    if (operation.pattern != "drill") return std::nullopt;
    const std::vector<FedMove>& moves = operation.moves;
    const auto feed = std::find_if(moves.begin(), moves.end(),
                                   [](const FedMove& m) { return m.move.kind != MoveKind::Rapid; });
    const std::size_t first = feed - moves.begin();
    // The rapid down to the R plane comes before the first feed, a rapid out ends it.
    if (first == 0 || feed == moves.end() || moves.back().move.kind != MoveKind::Rapid) return std::nullopt;
    FoundCycle found;
    found.moves_before = first - 1;
    DrillCycle& cycle = found.cycle;
    const Vec3 initial = first >= 2 ? moves[first - 2].move.to : operation.start;
    const Vec3 r = moves[first - 1].move.to;
    cycle.at = initial.head<2>();
    cycle.initial_z_mm = initial.z();
    cycle.r_z_mm = r.z();
    cycle.bottom_z_mm = r.z();
    cycle.feed_mm_per_min = feed->feed_mm_per_min;
    if (!above(r, initial) || r.z() > initial.z()) return std::nullopt;
    for (std::size_t i = first; i < moves.size(); ++i) {
        const Move& move = moves[i].move;
        if (!above(move.to, initial) || move.arc) return std::nullopt;
        if (move.kind == MoveKind::Rapid) continue;
        if (moves[i].feed_mm_per_min != cycle.feed_mm_per_min || move.to.z() >= cycle.bottom_z_mm)
            return std::nullopt;
        cycle.bottom_z_mm = move.to.z();
    }
    if (std::abs(moves.back().move.to.z() - initial.z()) > kSamePlaceMm) return std::nullopt;
    if (operation.depths > 1) cycle.peck_mm = operation.step_down_mm;
    return found;
}

}  // namespace stepmill
