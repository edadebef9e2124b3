#include "post/drill_cycle.h"

#include <algorithm>

namespace stepmill {
namespace {

/// Moves of one hole, from the first after the way to it.
struct HoleMoves {
    std::size_t first = 0;
    std::size_t end = 0;
};

/// Where the moves stay over one place: a hole each.
/// \param first  of the first hole
std::vector<HoleMoves> holesIn(const JobOperation& operation, std::size_t first) {
    const std::vector<FedMove>& moves = operation.moves;
    std::vector<HoleMoves> holes{{first, first}};
    for (std::size_t i = first; i < moves.size(); ++i) {
        const bool leaves = i > first && !above(moves[i].move.to, moves[i - 1].move.to);
        if (leaves)
            holes.push_back({i + 1, i + 1});
        else
            holes.back().end = i + 1;
    }
    return holes;
}

Vec3 startOf(const JobOperation& operation, std::size_t move) {
    return move == 0 ? operation.start : operation.moves[move - 1].move.to;
}

/// One hole's moves as a cycle: a rapid down, feeds that go deeper and deeper, rapids, back where it began.
std::optional<DrillCycle> cycleOf(const JobOperation& operation, const HoleMoves& hole) {
    const std::vector<FedMove>& moves = operation.moves;
    const Vec3 initial = startOf(operation, hole.first);
    if (hole.end < hole.first + 3 || moves[hole.first].move.kind != MoveKind::Rapid) return std::nullopt;
    DrillCycle cycle;
    cycle.places = {initial.head<2>()};
    cycle.initial_z_mm = initial.z();
    cycle.r_z_mm = cycle.bottom_z_mm = moves[hole.first].move.to.z();
    cycle.feed_mm_per_min = moves[hole.first + 1].feed_mm_per_min;
    if (cycle.r_z_mm > cycle.initial_z_mm) return std::nullopt;
    for (std::size_t i = hole.first; i < hole.end; ++i) {
        const Move& move = moves[i].move;
        if (!above(move.to, initial) || move.arc) return std::nullopt;
        if (move.kind == MoveKind::Rapid) continue;
        if (moves[i].feed_mm_per_min != cycle.feed_mm_per_min) return std::nullopt;
        const bool out = i + 2 == hole.end && i > hole.first + 1 && sameHeight(move.to.z(), cycle.r_z_mm);
        cycle.feeds_out = cycle.feeds_out || out;
        if (out) continue;
        if (move.to.z() >= cycle.bottom_z_mm) return std::nullopt;
        cycle.bottom_z_mm = move.to.z();
    }
    const Move& out = moves[hole.end - 1].move;
    if (out.kind != MoveKind::Rapid || !sameHeight(out.to.z(), initial.z())) return std::nullopt;
    return cycle;
}

bool sameHole(const DrillCycle& one, const DrillCycle& other) {
    return one.hasHeightsOf(other) && one.feeds_out == other.feeds_out &&
           one.feed_mm_per_min == other.feed_mm_per_min;
}

/// The move that comes down to the first hole's R plane: the last rapid before the first feed.
std::optional<std::size_t> firstDown(const std::vector<FedMove>& moves) {
    const auto feed = std::find_if(moves.begin(), moves.end(),
                                   [](const FedMove& one) { return one.move.kind != MoveKind::Rapid; });
    if (feed == moves.begin() || feed == moves.end()) return std::nullopt;
    return feed - moves.begin() - 1;
}

}  // namespace

std::optional<FoundCycle> findCycle(const JobOperation& operation) {
    const bool sinks = isForHoles(operation.role) || operation.pattern == kCountersinkPattern;
    if (!sinks || operation.thread) return std::nullopt;
    const std::optional<std::size_t> down = firstDown(operation.moves);
    if (!down) return std::nullopt;
    FoundCycle found;
    found.moves_before = *down;
    for (const HoleMoves& hole : holesIn(operation, *down)) {
        const std::optional<DrillCycle> cycle = cycleOf(operation, hole);
        const bool first = found.cycle.places.empty();
        if (!cycle || (!first && !sameHole(found.cycle, *cycle))) return std::nullopt;
        if (first)
            found.cycle = *cycle;
        else
            found.cycle.places.push_back(cycle->places.front());
    }
    if (operation.depths > 1) found.cycle.peck_mm = operation.step_down_mm;
    found.cycle.breaks_chips = operation.depths > 1 && operation.pattern == kChipBreakPattern;
    return found;
}

}  // namespace stepmill
