// The order of the passes of one depth of cut and the ways between them.

#include "toolpath/script/depth_script.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/toolpath/path_frame.h"
#include "toolpath/script/block_partition.h"
#include "toolpath/script/depth_progress.h"
#include "toolpath/script/descender.h"
#include "toolpath/script/entry_descent.h"
#include "toolpath/script/linker.h"
#include "toolpath/script/needless_passes.h"

namespace stepmill::toolpath {

namespace {

/// A lead shorter than this share of the ramp is dropped: the change of slope is below rounding.
constexpr double kLeastRampLeadShare = 1e-9;
/// Turns that exceed a whole number by no more than this are rounding.
constexpr double kRounding = 1e-9;

/// A hole less than a quarter wider than the cutter leaves chips no room beside it: the places of its axis
/// are less than so many radii apart.
constexpr double kRoomForChipsRadii = 0.5;

/// Is it more than a way to leave a wall?
bool isCutOrDescent(const ScriptStep& step) {
    return !std::holds_alternative<Link>(step);
}

RampAlong levelled(RampAlong ramp) {
    ramp.level = true;
    return ramp;
}

/// The whole depth as one block, with the heights of the ways over.
DepthBlock wholeBlock(const DepthTask& task, const DepthProgress& cut) {
    const std::vector<Descent>& descents = cut.descents();
    DepthBlock whole;
    whole.steps = cut.steps();
    whole.begin = descents.front().to;
    whole.end = cut.at();
    // The depths after the first begin where this one ends.
    whole.next_over = overWay(task.standing, cut.swept(), whole.end, whole.begin);
    for (const Descent& descent : descents)
        setOver(whole.steps[descent.step], overWay(task.standing, cut.swept(), descent.from, descent.to));
    return whole;
}

/// The ring that the depth begins with, then the rest from where the ring ends: over ground that is clear
/// down to the floor by then.
std::vector<DepthBlock> ringFirst(const DepthTask& task, const DepthProgress& cut, const DepthBlock& whole) {
    const auto* ramp = std::get_if<RampAlong>(&whole.steps.front());
    const bool lone = std::count_if(whole.steps.begin(), whole.steps.end(), isCutOrDescent) < 2;
    if (ramp == nullptr || !ramp->closed || lone) return {};
    const Vec2 at = ramp->curve.end();
    DepthBlock ring{{levelled(*ramp)}, whole.begin, at, Over::Retract};
    DepthBlock rest{whole.steps, at, whole.end, overWay(task.standing, cut.swept(), whole.end, at)};
    rest.steps.front() = ComeDown{at, Over::Retract, true};
    return {std::move(ring), std::move(rest)};
}

}  // namespace

DepthScript scriptDepth(const DepthTask& task, const RingFamily::Component& component, const Entry& entry,
                        const std::vector<Pass>& passes) {
    const SweptGround& before = task.untouched;
    DepthProgress progress(passes, before);
    NeedlessPasses needless(task, progress);
    needless.dropInnermost();
    const SweptGround passes_ground = needless.groundOfPasses();
    EntryDescent entry_descent(task, component, entry, before, passes_ground, progress);
    Linker linker(task, component, before, progress);
    Descender descender(task, component, before, entry_descent, progress);
    for (needless.dropCleared(); progress.left() > 0; needless.dropCleared())
        if (!linker.linkOn()) descender.goOn();
    descender.leaveWall();
    if (progress.steps().empty()) return {};
    STEPMILL_CHECK(!progress.descents().empty() && progress.descents().front().step == 0,
                   "a depth begins from above");
    DepthScript script{wholeBlock(task, progress), blocksApart(task, progress), {}};
    if (task.rates.rings_at_once > 1) script.ring_first = ringFirst(task, progress, script.whole);
    return script;
}

Over overWay(const Standing& standing, const SweptGround& ground, const Vec2& from, const Vec2& to) {
    if (!standing.isClearForAll(from, to)) return Over::Retract;
    return ground.isClear(from, to) ? Over::LastFloor : Over::Top;
}

PlungeDown plungeAt(const DepthTask& task, const RingFamily::Component& component, const Vec2& at) {
    PlungeDown down{at};
    const double room_mm = boundingBox(component.region).sizes().maxCoeff();
    if (room_mm < kRoomForChipsRadii * task.radius_mm) down.lifts_each_mm = 2 * task.radius_mm;
    return down;
}

RampAlong rampAlong(const Path& curve, bool closed, double descent_mm) {
    const double whole = length(curve);
    if (!closed) {
        const Path lead = descent_mm / 2 < whole ? firstPart(curve, descent_mm / 2) : curve;
        const int turns = static_cast<int>(std::ceil(descent_mm / 2 / length(lead) - kRounding));
        return {lead, curve, false, std::max(1, turns)};
    }
    const int turns = static_cast<int>(std::floor(descent_mm / whole));
    const double rest = descent_mm - turns * whole;
    if (rest < kLeastRampLeadShare * descent_mm) return {Path{curve.start, {}}, curve, true, turns};
    return {reversed(firstPart(reversed(curve), rest)), curve, true, turns};
}

double helixFeed(const DepthTask& task, double turn_mm, double pitch_mm) {
    const LinkRates& rates = task.rates;
    const double wide_mm = helixWidth(turn_mm / (2 * kPi), task.radius_mm);
    return std::min({rates.ramp_feed_mm_per_min, rates.rated_mm3_per_min / (wide_mm * pitch_mm),
                     rates.plunge_feed_mm_per_min * std::hypot(turn_mm, pitch_mm) / pitch_mm});
}

void setOver(ScriptStep& step, Over over) {
    std::visit(
        [over](auto& s) {
            if constexpr (requires { s.over; }) s.over = over;
        },
        step);
}

}  // namespace stepmill::toolpath
