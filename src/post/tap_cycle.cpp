#include "post/tap_cycle.h"

namespace stepmill {
namespace {

/// An operation's places: its start, then where each move ends.
std::vector<Vec3> placesOf(const JobOperation& operation) {
    std::vector<Vec3> places{operation.start};
    for (const FedMove& one : operation.moves)
        places.push_back(one.move.to);
    return places;
}

bool isRapid(const FedMove& one) {
    return one.move.kind == MoveKind::Rapid;
}

}  // namespace

std::optional<FoundTapCycle> findTapCycle(const JobOperation& operation) {
    if (!operation.thread) return std::nullopt;
    const std::vector<FedMove>& moves = operation.moves;
    const std::vector<Vec3> at = placesOf(operation);
    FoundTapCycle found;
    TapCycle& cycle = found.cycle;
    cycle.pitch_mm = operation.thread->thread.pitch_mm;
    cycle.speed_rpm = operation.speed_rpm;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        if (isRapid(moves[i])) continue;
        // Move i goes down from places[i], the next one back up there.
        if (i + 1 == moves.size() || isRapid(moves[i + 1]) || !above(at[i], at[i + 1]) ||
            !above(at[i], at[i + 2]) || !sameHeight(at[i].z(), at[i + 2].z()) || at[i + 1].z() >= at[i].z())
            return std::nullopt;
        const bool from_rapid = i > 0 && above(at[i - 1], at[i]) && at[i - 1].z() > at[i].z();
        const HoleCycle hole{{}, from_rapid ? at[i - 1].z() : at[i].z(), at[i].z(), at[i + 1].z()};
        if (cycle.places.empty()) {
            found.moves_before = from_rapid ? i - 1 : i;
            static_cast<HoleCycle&>(cycle) = hole;
        }
        if (!cycle.hasHeightsOf(hole)) return std::nullopt;
        cycle.places.emplace_back(at[i].head<2>());
        ++i;
    }
    if (cycle.places.empty() || !sameHeight(at.back().z(), cycle.initial_z_mm)) return std::nullopt;
    return found;
}

}  // namespace stepmill
