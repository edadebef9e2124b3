// Exact cover of a way's capsule by discs, by halving squares.

#include "toolpath/swept_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stepmill::toolpath {

bool SweptGround::isClear(const Edge& way) const {
    const Box2 box = way.box.grown(radius_mm_);
    Edges near;
    for (const Edge& edge : swept_)
        if (edge.box.grown(radius_mm_).overlaps(box)) near.push_back(&edge);
    return isClear(way, {(box.min + box.max) / 2, box.size().maxCoeff() / 2}, near);
}

bool SweptGround::isClear(const Edge& way, const Square& square, const Edges& near) const {
    const Vec2& p = square.centre;
    const double reach = square.half_mm * std::numbers::sqrt2;
    const double inner = radius_mm_ * (1 - kCuspShare);
    const double off_way = distanceTo(p, way.from, way.segment);
    if (off_way - reach >= inner) return true;
    double nearest = std::numeric_limits<double>::infinity();
    Edges still_near;
    for (const Edge* edge : near) {
        const double distance = distanceTo(p, edge->from, edge->segment);
        if (distance + reach <= radius_mm_) return true;
        nearest = std::min(nearest, distance);
        if (distance - reach < radius_mm_) still_near.push_back(edge);
    }
    if (!task_->cleared_centres.empty()) {
        const double distance = distanceToRegion(task_->cleared_centres, p);
        if (distance + reach <= radius_mm_) return true;
        nearest = std::min(nearest, distance);
    }
    const double off_target = distanceToRegion(task_->target, p);
    if (off_target >= reach) return true;
    if (off_way < inner && off_target == 0 && nearest > radius_mm_) return false;
    // Covers that end within half a cusp of the way's rim are no covers.
    if (reach < radius_mm_ * kCuspShare / 2) return false;
    const double half = square.half_mm / 2;
    for (const double x : {-half, half})
        for (const double y : {-half, half})
            if (!isClear(way, {p + Vec2(x, y), half}, still_near)) return false;
    return true;
}

}  // namespace stepmill::toolpath
