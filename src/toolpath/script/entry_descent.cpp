#include "toolpath/script/entry_descent.h"

#include <algorithm>

#include "toolpath/patterns/ring_family.h"

namespace stepmill::toolpath {

namespace {

/// A helix or ramp smaller than this is not worth the name [mm].
constexpr double kLeastEntryMm = 0.05;
/// Halvings of a way in over an open edge that find where its air ends.
constexpr int kAirHalvings = 20;

}  // namespace

EntryDescent::EntryDescent(const DepthTask& task, const RingFamily::Component& component, const Entry& entry,
                           const SweptGround& before, const SweptGround& passes_ground,
                           DepthProgress& progress)
    : task_(task),
      component_(component),
      entry_(entry),
      before_(before),
      passes_ground_(passes_ground),
      progress_(progress) {}

bool EntryDescent::isFree(const Vec2& a, const Vec2& b) const {
    return isOpen() ? task_.standing.isClear(a, b) : isFreeWay(component_, a, b, task_.tol);
}

bool EntryDescent::isCleared() const {
    return !isOpen() && before_.isClear(entry_.at, entry_.at);
}

bool EntryDescent::goDown(const Vec2& towards) {
    if (isCleared()) {
        progress_.descend(ComeDown{entry_.at, Over::Retract, true}, entry_.at);
        return true;
    }
    switch (entry_.kind) {
        case EntryKind::Helix:
            return goDownHelix(towards);
        case EntryKind::Ramp:
            return goDownRamp();
        case EntryKind::Plunge:
            return goDownPlunge();
        case EntryKind::OpenEdge:
            return goDownBeside();
    }
    return false;
}

bool EntryDescent::goDownPlunge() {
    progress_.descend(plungeAt(task_, component_, entry_.at), entry_.at);
    progress_.addSwept(makeLine(entry_.at, entry_.at));
    return true;
}

bool EntryDescent::goDownBeside() {
    progress_.descend(ComeDown{entry_.at, Over::Retract, before_.isClear(entry_.at, entry_.at)}, entry_.at);
    return true;
}

bool EntryDescent::goDownHelix(const Vec2& towards) {
    const double room = distanceToBoundary(component_.region, entry_.at);
    const double radius = snapToGrid(std::min(entry_.helix_radius_mm, room - task_.tol.guard_mm - kGridMm));
    if (radius < kLeastEntryMm) return false;
    const Vec2 away = towards - entry_.at;
    const Vec2 direction = away.norm() > kGridMm ? Vec2(away.normalized()) : Vec2(1, 0);
    const Vec2 start = snapToGrid(Vec2(entry_.at + radius * direction));
    const Vec2 opposite = snapToGrid(Vec2(2 * entry_.at - start));
    const Arc arc{entry_.at, radius, true};
    RampAlong helix = rampAlong(Path{start, {{opposite, arc}, {start, arc}}}, true, task_.rates.descent_mm);
    helix.level = needsLevel(edgesOf(helix.curve));
    progress_.descend(helix, helix.lead.start);
    progress_.standAt(start);
    return true;
}

bool EntryDescent::goDownRamp() {
    const Edge ramp = makeLine(entry_.at, entry_.ramp_to);
    if (length(ramp) < kLeastEntryMm) return false;
    if (component_.walls.anyNearer(ramp, task_.tol.guard_mm - 2 * kGridMm)) return false;
    progress_.descend(RampDown{entry_.at, entry_.ramp_to, needsLevel({ramp})}, entry_.at);
    return true;
}

/// Does the slope a descent leaves have to be taken away, since no pass does? Ground that is not made
/// level does not count as swept.
bool EntryDescent::needsLevel(const std::vector<Edge>& descent) {
    const bool level = !std::all_of(descent.begin(), descent.end(),
                                    [&](const Edge& edge) { return passes_ground_.isClear(edge); });
    if (level)
        for (const Edge& edge : descent)
            progress_.addSwept(edge);
    return level;
}

bool EntryDescent::isAsWide(const Path& curve) const {
    const double width = boundingBox(curve).sizes().maxCoeff();
    if (entry_.kind == EntryKind::Plunge) return width >= kLeastEntryMm;
    const double entry_width =
        entry_.kind == EntryKind::Helix ? 2 * entry_.helix_radius_mm : (entry_.ramp_to - entry_.at).norm();
    // A helix that fills its room is a ring but for the guard.
    return width >= entry_width - 2 * onBoundaryMm(task_.tol);
}

void EntryDescent::linkThroughAir(const Vec2& to) {
    const Vec2 from = progress_.at();
    double air = 0;
    double cutting = 1;
    for (int i = 0; i < kAirHalvings; ++i) {
        const double middle = (air + cutting) / 2;
        const bool in_air =
            distanceToRegion(task_.clearing.target, Vec2(from + middle * (to - from))) >= task_.radius_mm;
        (in_air ? air : cutting) = middle;
    }
    if (air > 0) progress_.link(snapToGrid(Vec2(from + air * (to - from))), true);
}

}  // namespace stepmill::toolpath
