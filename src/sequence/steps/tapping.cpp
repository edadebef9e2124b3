#include "stepmill/sequence/tapping.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sequence/steps/hole_room.h"
#include "stepmill/access/access.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/drilling.h"

namespace stepmill {
namespace {

/// The tip of a tap stays so many pitches over the end of a blind hole's whole width.
constexpr double kOverEndPitches = 1;
/// And goes so many beyond its lead through a hole, so that the last turn is full at the far side.
constexpr double kBeyondPitches = 1;

/// Does what stays lie in the hole's width, and not in the rim or the point that a drill leaves below?
bool narrowsHole(const Residual& residual) {
    return residual.volume_mm3 > 0 && !(residual.reason == Reason::DrillPoint);
}

}  // namespace

TapDepth tapDepth(const TapTask& task, const ToolAssembly& tap) {
    const Feature& hole = task.hole;
    const double deepest_z = deepestTapTipZ(hole, tap, task.bored_to_z_mm);
    TapDepth depth;
    depth.full_z_mm = std::max(deepest_z + tap.lead_mm, hole.floor_z_mm);
    if (task.thread_depth_mm > 0) depth.full_z_mm = task.top_z_mm - task.thread_depth_mm;
    if (hole.through) depth.full_z_mm = std::max(depth.full_z_mm, hole.floor_z_mm);
    depth.tip_z_mm = depth.full_z_mm - tap.lead_mm;
    // As asked for through a hole: the last turn is full at the far side.
    if (hole.through && depth.full_z_mm <= hole.floor_z_mm) depth.tip_z_mm = deepest_z;
    const double most_mm = task.top_z_mm - deepest_z - tap.lead_mm;
    if (depth.tip_z_mm < deepest_z - 1e-9)
        depth.trouble = fmt::format(
            "{:.4g} mm of thread were asked for, the hole of {:.4g} mm lets {} make {:.4g} mm: its lead is "
            "{:.4g} mm",
            task.thread_depth_mm, task.top_z_mm - task.bored_to_z_mm, tap.id, std::max(0.0, most_mm),
            tap.lead_mm);
    else if (task.top_z_mm - depth.full_z_mm < tap.thread->pitch_mm)
        depth.trouble = fmt::format("the hole of {:.4g} mm is too shallow for the {:.4g} mm lead of {}",
                                    task.top_z_mm - task.bored_to_z_mm, tap.lead_mm, tap.id);
    return depth;
}

std::optional<double> boredToZ(const Feature& hole, const ToolSequence& made, const ToolLibrary& library) {
    if (made.steps.empty() || std::any_of(made.residual.begin(), made.residual.end(), narrowsHole))
        return std::nullopt;
    const SequenceStep& last = made.steps.back();
    if (last.role == Role::Drill) return drilledToZ(hole, library.tool(last.tool_id));
    return made.floor_z_mm;
}

Feature asTapFinds(Feature hole, const ToolAssembly& tap, const std::vector<Fixture>& fixtures,
                   const Tolerances& tol) {
    if (!hole.through) return hole;
    const double deepest_z = deepestTapTipZ(hole, tap, hole.floor_z_mm);
    const std::vector<Vec2> axes = holeCentres(hole);
    const auto lies_below = [&](const Fixture& fixture) {
        if (fixture.bottom_z_mm >= hole.floor_z_mm || fixture.top_z_mm <= deepest_z) return false;
        return std::any_of(axes.begin(), axes.end(), [&](const Vec2& axis) {
            return area(intersect(fixture.section, makeCircle(axis, tap.radius_mm()), tol)) > 0;
        });
    };
    const bool room = !hole.room_below_mm || deepest_z >= hole.floor_z_mm - *hole.room_below_mm;
    hole.through = room && std::none_of(fixtures.begin(), fixtures.end(), lies_below);
    return hole;
}

double deepestTapTipZ(const Feature& hole, const ToolAssembly& tap, double bored_to_z_mm) {
    const double pitch_mm = tap.thread->pitch_mm;
    if (hole.through) return hole.floor_z_mm - tap.lead_mm - kBeyondPitches * pitch_mm;
    return std::max(bored_to_z_mm, hole.floor_z_mm) + kOverEndPitches * pitch_mm;
}

std::string tapShankTrouble(const Feature& hole, const ToolAssembly& tap, double tip_z_mm) {
    const double depth_mm = hole.top_z_mm - tip_z_mm;
    const double hole_mm = 2 * holeRadiusMm(hole);
    const double slim_mm = tap.shank.diameter_mm < hole_mm ? tap.stick_out_mm : tap.flute_length_mm;
    if (depth_mm > slim_mm)
        return fmt::format("{} reaches {:.4g} mm into a hole of {:.4g} mm, its tip must go {:.4g} mm deep",
                           tap.id, slim_mm, hole_mm, depth_mm);
    return troubleBeside(hole, tap, tip_z_mm);
}

double tapSpeedRpm(const ToolAssembly& tap, const CuttingData& cutting, const Machine& machine) {
    double speed_rpm = cutting.speed_rpm;
    if (machine.max_speed_rpm > 0) speed_rpm = std::min(speed_rpm, machine.max_speed_rpm);
    if (machine.max_feed_mm_per_min > 0)
        speed_rpm = std::min(speed_rpm, machine.max_feed_mm_per_min / tap.thread->pitch_mm);
    return std::floor(speed_rpm + 1e-9);
}

TapStep tapStep(const TapTask& task, const ToolAssembly& tap, const CuttingData& cutting,
                const Machine& machine) {
    const double hole_mm = 2 * holeRadiusMm(task.hole);
    const CoreRange core = coreRange(*tap.thread);
    if (!isCoreOf(*tap.thread, hole_mm))
        return {{},
                fmt::format("the hole is {:.4g} mm wide, {} is tapped into {:.3f} to {:.3f} mm", hole_mm,
                            tap.thread->name, core.least_mm, core.most_mm)};
    const TapDepth depth = tapDepth(task, tap);
    if (!depth.trouble.empty()) return {{}, depth.trouble};
    if (std::string trouble = tapShankTrouble(task.hole, tap, depth.tip_z_mm); !trouble.empty())
        return {{}, std::move(trouble)};
    const double speed_rpm = tapSpeedRpm(tap, cutting, machine);
    if (speed_rpm < 1) return {{}, fmt::format("{} is too slow for {}", machine.name, tap.id)};
    SequenceStep step;
    step.tool_id = tap.id;
    step.role = Role::Tap;
    step.speed_rpm = speed_rpm;
    step.holes = static_cast<int>(task.places.size());
    step.thread = {*tap.thread, depth.tip_z_mm, depth.full_z_mm, shortestTour(task.places)};
    step.path = tapHoles(step.thread->places, task.hole.top_z_mm, depth.tip_z_mm, task.retract_z_mm, tap,
                         speed_rpm, machine);
    step.least_stick_out_mm = leastStickOutMm(tap, [&](const ToolAssembly& shorter) {
        return tapShankTrouble(task.hole, shorter, depth.tip_z_mm).empty();
    });
    return {std::move(step), {}};
}

}  // namespace stepmill
