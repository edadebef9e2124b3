#include "toolpath/script/descender.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/error.h"
#include "toolpath/emit.h"
#include "toolpath/patterns/ring_family.h"

namespace stepmill::toolpath {

namespace {

/// A cutter goes so far off a wall, at 45 degrees to it, before it is lifted [mm].
constexpr double kLeaveMm = 0.5;

}  // namespace

Descender::Descender(const DepthTask& task, const RingFamily::Component& component, const SweptGround& before,
                     EntryDescent& entry, DepthProgress& progress)
    : task_(task), component_(component), before_(before), entry_(entry), progress_(progress) {}

void Descender::goOn() {
    leaveWall();
    for (const bool ready : {true, false}) {
        const std::vector<Joint> joints = progress_.waiting(ready);
        for (const Joint& joint : joints)
            if (comeDownInAir(joint)) return;
        for (const Joint& joint : joints)
            if (enter(joint, ready)) return;
    }
    const std::vector<Joint> joints = progress_.waiting(true);
    STEPMILL_CHECK(!joints.empty(), "the order of passes has a cycle");
    const Pass& pass = progress_.pass(joints.front().pass);
    if (mayPlungeOnto(pass) && minutesOfPlunge() < minutesAlong(pass))
        plungeOnto(joints.front());
    else
        rampInto(joints.front());
}

/// Down along the pass itself, which is then cut.
void Descender::rampInto(const Joint& joint) {
    const RampAlong ramp =
        rampAlong(progress_.from(joint), progress_.pass(joint.pass).closed, task_.rates.descent_mm);
    progress_.descend(ramp, ramp.lead.start);
    progress_.finish(joint.pass, ramp.curve);
}

void Descender::comeDown(const Vec2& at, bool needs_others) {
    progress_.descend(ComeDown{at, Over::Retract, before_.isClear(at, at)}, at, needs_others);
}

bool Descender::comeDownInAir(const Joint& joint) {
    const Pass& next = progress_.pass(joint.pass);
    const bool in_air = joint.backwards ? next.ends_in_air : next.starts_in_air;
    if (!in_air && !progress_.swept().isClear(joint.at.point, joint.at.point))
        return comeDownOnNeighbour(joint);
    comeDown(joint.at.point, !in_air);
    progress_.cut(joint);
    return true;
}

/// Down on a neighbouring pass that has been cut, and from there straight to this one.
bool Descender::comeDownOnNeighbour(const Joint& joint) {
    for (const int neighbour : progress_.pass(joint.pass).neighbours) {
        if (!progress_.wasCut(neighbour)) continue;
        // The pair of points that is nearest from the pass' start or, when closed, from the last place.
        const NearestPoint landing = nearestOn(progress_.pass(neighbour).path, joint.at.point);
        const Joint from_there = progress_.jointWith(joint.pass, landing.point);
        if (from_there.distance_mm > kNeighbourLink * task_.step_over_mm) continue;
        if (!isFreeWay(component_, landing.point, from_there.at.point, task_.tol)) continue;
        comeDown(landing.point, true);
        progress_.link(from_there.at.point, false);
        progress_.cut(from_there);
        return true;
    }
    return false;
}

bool Descender::enter(const Joint& joint, bool ready) {
    // The cutter goes down through material once per depth of a component, and only for a ready pass.
    if (!entry_.isOpen() && (!ready || entered_)) return false;
    const Joint from_entry = progress_.jointWith(joint.pass, entry_.entry().at);
    for (const PricedWay& way : waysDown(joint, from_entry)) {
        if (!goDown(way.way, joint, from_entry)) continue;
        entered_ = true;
        return true;
    }
    return false;
}

/// Beside a finished wall a plunge would show.
bool Descender::mayPlungeOnto(const Pass& pass) const {
    const bool at_wall = pass.closed && pass.level == 0;
    return task_.rates.may_plunge && !at_wall;
}

double Descender::minutesOfPlunge() const {
    return task_.rates.plunge_mm / task_.rates.plunge_feed_mm_per_min;
}

std::vector<Descender::PricedWay> Descender::waysDown(const Joint& joint, const Joint& from_entry) const {
    const Pass& pass = progress_.pass(joint.pass);
    const LinkRates& rates = task_.rates;
    const double plunge_min = minutesOfPlunge();
    const double link_min = from_entry.distance_mm / rates.feed_mm_per_min;
    std::vector<PricedWay> ways;
    if (mayRampAlong(pass)) ways.push_back({WayDown::AlongPass, minutesAlong(pass)});
    if (mayPlungeOnto(pass)) ways.push_back({WayDown::PlungeOntoPass, plunge_min});
    if (rates.may_plunge && !entry_.isOpen()) {
        // From there it cuts its whole width.
        const double slot_feed =
            std::min(rates.feed_mm_per_min, rates.rated_mm3_per_min / (2 * task_.radius_mm * depthOfCut()));
        ways.push_back({WayDown::PlungeAtEntry, plunge_min + from_entry.distance_mm / slot_feed});
    }
    ways.push_back({WayDown::ByEntry, minutesByEntry() + link_min});
    std::stable_sort(ways.begin(), ways.end(),
                     [](const PricedWay& a, const PricedWay& b) { return a.minutes < b.minutes; });
    return ways;
}

bool Descender::goDown(WayDown way, const Joint& joint, const Joint& from_entry) {
    if (way == WayDown::AlongPass) {
        rampInto(joint);
        return true;
    }
    if (way == WayDown::PlungeOntoPass) {
        plungeOnto(joint);
        return true;
    }
    if (!entry_.isFree(entry_.entry().at, from_entry.at.point)) return false;
    const bool down =
        way == WayDown::PlungeAtEntry ? entry_.goDownPlunge() : entry_.goDown(from_entry.at.point);
    if (down) goOnFromEntry(joint, from_entry);
    return down;
}

void Descender::plungeOnto(const Joint& joint) {
    progress_.descend(plungeAt(task_, component_, joint.at.point), joint.at.point);
    progress_.addSwept(makeLine(joint.at.point, joint.at.point));
    progress_.cut(joint);
}

/// From where the entry has ended to the pass: straight, or by way of the entry's own place.
void Descender::goOnFromEntry(const Joint& joint, const Joint& from_entry) {
    const Joint from_here = progress_.jointWith(joint.pass, progress_.at());
    const bool near = entry_.isFree(progress_.at(), from_here.at.point);
    const Joint& best = near ? from_here : from_entry;
    if (!near) progress_.link(entry_.entry().at, true);
    if (entry_.isOpen()) entry_.linkThroughAir(best.at.point);
    progress_.link(best.at.point, false);
    progress_.cut(best);
}

/// A curve narrower than the helix or ramp that was found is steep for the cutter's middle.
bool Descender::mayRampAlong(const Pass& pass) const {
    const Path& path = pass.path;
    if (entry_.isOpen()) return pass.closed && boundingBox(path).sizes().maxCoeff() >= 2 * task_.radius_mm;
    if (pass.closed) return entry_.isAsWide(path);
    return pass.reversible && entry_.isAsWide(Path{path.start, {path.segments.front()}});
}

/// Of a first ring that is cut down to the floor at once, the slope is taken away once. Along one that is
/// shorter than its ramp a cutter that may plunge goes a depth of cut down in a turn, and level at the end.
double Descender::minutesAlong(const Pass& pass) const {
    const LinkRates& rates = task_.rates;
    const double ramp_min = rates.descent_mm / rates.ramp_feed_mm_per_min;
    const bool at_once = pass.closed && !entry_.isOpen() && progress_.descents().empty();
    const double turn_mm = length(pass.path);
    if (at_once && turn_mm > rates.descent_mm) return ramp_min / rates.rings_at_once;
    if (!at_once || !rates.may_plunge) return ramp_min;
    const double level_mm = turn_mm * (1 - 1.0 / rates.rings_at_once);
    const double level_feed = std::min(
        rates.feed_mm_per_min, rates.rated_mm3_per_min / (widthAfterPlunge(pass.path) * depthOfCut()));
    const double down_min = std::hypot(turn_mm, depthOfCut()) / helixFeed(task_, turn_mm, depthOfCut());
    return std::max(0.0, down_min - level_mm / level_feed);
}

double Descender::depthOfCut() const {
    return task_.rates.plunge_mm - kDescentStartMm;
}

/// How wide a ring cuts that begins where the cutter has gone straight down: the ring between what it swept
/// there and what it sweeps here, along its length.
double Descender::widthAfterPlunge(const Path& ring) const {
    const double ring_radius_mm = boundingBox(ring).sizes().maxCoeff() / 2;
    return std::min(task_.radius_mm + ring_radius_mm / 2, 2 * task_.radius_mm);
}

double Descender::minutesByEntry() const {
    const LinkRates& rates = task_.rates;
    if (entry_.isCleared()) return rates.deep_approach_mm / rates.plunge_feed_mm_per_min;
    switch (entry_.entry().kind) {
        case EntryKind::OpenEdge:
            return rates.approach_mm / rates.plunge_feed_mm_per_min;
        case EntryKind::Plunge:
            return minutesOfPlunge();
        case EntryKind::Helix:
        case EntryKind::Ramp:
            break;
    }
    return rates.descent_mm / rates.ramp_feed_mm_per_min;
}

void Descender::leaveWall() {
    const Vec2 at = progress_.at();
    if (progress_.last() < 0 || !component_.walls.anyNearer(makeLine(at, at), kLeaveMm / 2)) return;
    SweptGround own = before_;
    progress_.addSpotTo(own);
    for (const double side : {1.0, -1.0}) {
        const Vec2 off = (progress_.along() + side * leftOf(progress_.along())).normalized() * kLeaveMm;
        const Vec2 to = snapToGrid(Vec2(at + off));
        const bool off_wall = !component_.walls.anyNearer(makeLine(to, to), kLeaveMm / 2);
        if (!off_wall || !isFreeWay(component_, at, to, task_.tol) || !own.isClear(at, to)) continue;
        return progress_.link(to, true);
    }
}

}  // namespace stepmill::toolpath
