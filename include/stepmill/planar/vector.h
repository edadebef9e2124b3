#pragma once

#include <cmath>

#include <Eigen/Core>

namespace stepmill {

/// A point or vector in the plane of a setup [mm].
using Vec2 = Eigen::Vector2d;

/// Planar points, arc centres and radii are multiples of 1 nm, so that "the same point" and "the same
/// arc" are plain equality.
inline constexpr double kGridMm = 1e-6;
double snapToGrid(double value_mm);
Vec2 snapToGrid(const Vec2& point);

/// Twice the signed area of the triangle that two vectors span: positive where `b` points to the left of `a`.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Angle from the direction of `a` to that of `b`, counter-clockwise, in (-pi, pi] [rad].
inline double turnRad(const Vec2& a, const Vec2& b) {
    return std::atan2(cross(a, b), a.dot(b));
}

/// The vector turned by a quarter turn counter-clockwise.
inline Vec2 leftOf(const Vec2& v) {
    return {-v.y(), v.x()};
}

}  // namespace stepmill
