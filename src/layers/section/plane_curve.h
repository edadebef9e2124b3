#pragma once

#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// A line, a circle or a chain of points: what a face shows at a height, or an edge seen from above.
struct PlaneCurve {
    enum class Kind { Line, Circle, Points };
    Kind kind = Kind::Points;
    Vec2 normal = Vec2::Zero();  ///< unit, of a Line
    double offset = 0;
    Arc arc;          ///< of a Circle
    double turn = 0;  ///< angle the facets turn about the centre [rad]
    std::vector<Vec2> points;

    /// Signed distance from the line or circle.
    double distance(const Vec2& p) const {
        return kind == Kind::Line ? normal.dot(p) - offset : (p - arc.centre).norm() - arc.radius_mm;
    }
    Vec2 gradient(const Vec2& p) const {
        return kind == Kind::Line ? normal : Vec2((p - arc.centre).normalized());
    }
    Vec2 project(const Vec2& p) const {
        return kind == Kind::Points ? p : Vec2(p - distance(p) * gradient(p));
    }
};

/// The closed loop of curves that follow one another, material on the left; no segments where it is too
/// small to matter. `joints[i]` lies between curve i - 1 and curve i: where those two cross, their
/// intersection near it takes its place. Points are fitted on the safe side (see fitSafeSide).
Loop joinCurves(const std::vector<PlaneCurve>& curves, const std::vector<Vec2>& joints, double tolerance_mm);

/// The loop of one curve that closes on itself.
Loop wholeLoop(const PlaneCurve& curve, double tolerance_mm);

/// A stretch of one curve between two points, snapped to the grid.
Path openPath(const PlaneCurve& curve, const Vec2& from, const Vec2& to, double tolerance_mm);

}  // namespace stepmill::layers
