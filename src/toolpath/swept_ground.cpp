// Exact cover of a way's capsule by discs, by halving squares.

#include "toolpath/swept_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "stepmill/core/units.h"

namespace stepmill::toolpath {

namespace {

/// So many points of a disc's rim are looked at before its ground is proven to be clear ...
constexpr int kLookedAt = 12;
/// ... at this share of the radius: those on the rim itself rounding may put outside.
constexpr double kLookedAtShare = 0.99;

}  // namespace

SweptGround::SweptGround(const ClearingTask& task, double radius_mm)
    : boundaries_(std::make_shared<const Boundaries>(
          Boundaries{EdgeIndex(task.target), EdgeIndex(task.cleared_centres)})),
      task_(&task),
      radius_mm_(radius_mm) {}

bool SweptGround::isClear(const Edge& way, double cusp_mm) const {
    return isClear(way, radius_mm_, cusp_mm);
}

bool SweptGround::isClearFor(double disc_mm, const Vec2& a, const Vec2& b) const {
    return isClear(makeLine(a, b), disc_mm, kCuspShare * radius_mm_);
}

bool SweptGround::isClear(const Edge& way, double disc_mm, double cusp_mm) const {
    const bool beside_target = !boundaries_->target.anyNearer(way, disc_mm);
    if (beside_target && !contains(task_->target, way.from)) return true;
    const Box2 box = grown(way.box, disc_mm);
    Near near;
    near.disc_mm = disc_mm;
    near.cusp_mm = cusp_mm;
    for (const Edge& edge : swept_)
        if (grown(edge.box, radius_mm_).intersects(box)) near.swept.push_back(&edge);
    // The square is as wide as the box is long.
    const double half = box.sizes().maxCoeff() / 2;
    const Vec2 centre = (box.min() + box.max()) / 2;
    const Box2 square = Box2{centre - Vec2(half, half), centre + Vec2(half, half)};
    boundaries_->target.forEachIn(square, [&](const Edge& edge) { near.target.push_back(&edge); });
    boundaries_->cleared.forEachIn(grown(square, radius_mm_),
                                   [&](const Edge& edge) { near.cleared.push_back(&edge); });
    near.off_cleared = task_->cleared_centres.empty();
    return !meetsAtOnce(way, near) && isClear(way, {centre, half}, near);
}

bool SweptGround::meetsAtOnce(const Edge& way, const Near& near) const {
    const double rim_mm = kLookedAtShare * (near.disc_mm - near.cusp_mm);
    for (const double share : {1.0, 0.5, 0.0}) {
        const Vec2 at = pointAt(way, share);
        if (isMaterial(at, near)) return true;
        for (int i = 0; i < kLookedAt; ++i) {
            const double angle_rad = 2 * kPi * i / kLookedAt;
            if (isMaterial(at + rim_mm * Vec2(std::cos(angle_rad), std::sin(angle_rad)), near)) return true;
        }
        if (way.from == way.to()) break;
    }
    return false;
}

bool SweptGround::isMaterial(const Vec2& p, const Near& near) const {
    const auto covers = [&](const Edge* edge) { return distanceTo(p, *edge) <= radius_mm_; };
    return std::none_of(near.swept.begin(), near.swept.end(), covers) &&
           std::none_of(near.cleared.begin(), near.cleared.end(), covers) && contains(task_->target, p) &&
           (near.off_cleared || !contains(task_->cleared_centres, p));
}

bool SweptGround::isClear(const Edge& way, const Square& square, const Near& near) const {
    const Vec2& p = square.centre;
    const double reach = square.half_mm * std::numbers::sqrt2;
    const double inner = near.disc_mm - near.cusp_mm;
    const double off_way = distanceTo(p, way);
    if (off_way - reach >= inner) return true;
    Near within;
    within.disc_mm = near.disc_mm;
    within.cusp_mm = near.cusp_mm;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Edge* edge : near.swept) {
        const double distance = distanceTo(p, *edge);
        if (distance + reach <= radius_mm_) return true;
        nearest = std::min(nearest, distance);
        if (distance - reach < radius_mm_) within.swept.push_back(edge);
    }
    // A square that no boundary meets lies on one side of it: one question answers for all its parts.
    bool cleared_meets = false;
    for (const Edge* edge : near.cleared) {
        const double distance = distanceTo(p, *edge);
        if (distance + reach <= radius_mm_) return true;
        nearest = std::min(nearest, distance);
        cleared_meets = cleared_meets || distance <= reach;
        if (distance - reach < radius_mm_) within.cleared.push_back(edge);
    }
    within.off_cleared = near.off_cleared;
    if (!within.off_cleared && !cleared_meets) {
        if (contains(task_->cleared_centres, p)) return true;
        within.off_cleared = true;
    }
    for (const Edge* edge : near.target)
        if (distanceTo(p, *edge) <= reach) within.target.push_back(edge);
    within.in_target = near.in_target;
    if (!within.in_target && within.target.empty()) {
        if (!contains(task_->target, p)) return true;
        within.in_target = true;
    }
    if (off_way < inner && nearest > radius_mm_ && (within.in_target || contains(task_->target, p)) &&
        (within.off_cleared || !contains(task_->cleared_centres, p)))
        return false;
    // Covers that end within half a cusp of the way's rim are no covers.
    if (reach < near.cusp_mm / 2) return false;
    const double half = square.half_mm / 2;
    for (const double x : {-half, half})
        for (const double y : {-half, half})
            if (!isClear(way, {p + Vec2(x, y), half}, within)) return false;
    return true;
}

}  // namespace stepmill::toolpath
