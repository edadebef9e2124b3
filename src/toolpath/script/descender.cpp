#include "toolpath/script/descender.h"

#include "stepmill/core/error.h"
#include "toolpath/patterns/ring_family.h"

namespace stepmill::toolpath {

Descender::Descender(const DepthTask& task, const RingFamily::Component& component, const SweptGround& before,
                     EntryDescent& entry, DepthProgress& progress)
    : task_(task), component_(component), before_(before), entry_(entry), progress_(progress) {}

void Descender::goOn() {
    for (const bool ready : {true, false}) {
        const std::vector<Joint> joints = progress_.waiting(ready);
        for (const Joint& joint : joints)
            if (comeDownInAir(joint)) return;
        for (const Joint& joint : joints)
            if (enter(joint, ready)) return;
    }
    const std::vector<Joint> joints = progress_.waiting(true);
    STEPMILL_CHECK(!joints.empty(), "the order of passes has a cycle");
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
    if (rampIsBetter(joint)) {
        entered_ = true;
        rampInto(joint);
        return true;
    }
    const Joint from_entry = progress_.jointWith(joint.pass, entry_.entry().at);
    if (!entry_.isFree(entry_.entry().at, from_entry.at.point)) return false;
    if (!entry_.goDown(from_entry.at.point)) return false;
    entered_ = true;
    goOnFromEntry(joint, from_entry);
    return true;
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

/// A ring saves the way from a helix or ramp; from an open edge the way to it may be longer than a ramp.
bool Descender::rampIsBetter(const Joint& joint) const {
    const Pass& pass = progress_.pass(joint.pass);
    const Path& path = pass.path;
    const EntryKind kind = entry_.entry().kind;
    if (pass.reversible && kind != EntryKind::Plunge && kind != EntryKind::OpenEdge)
        return entry_.isAsWide(Path{path.start, {path.segments.front()}});
    if (!pass.closed || kind == EntryKind::Plunge) return false;
    if (kind != EntryKind::OpenEdge) return entry_.isAsWide(path);
    return progress_.jointWith(joint.pass, entry_.entry().at).distance_mm > task_.rates.descent_mm &&
           boundingBox(path).sizes().maxCoeff() >= 2 * task_.radius_mm;
}

}  // namespace stepmill::toolpath
