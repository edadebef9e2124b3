#include "stepmill/planar/tangent_arc.h"

#include <cmath>

namespace stepmill {
namespace {

/// Wider arcs are straight [mm].
constexpr double kWidestArcMm = 9e4;

}  // namespace

Segment arcTo(const Vec2& from, const Vec2& along, const Vec2& to) {
    const Vec2 chord = to - from;
    const double side = cross(along, chord);
    if (chord.squaredNorm() >= 2 * std::abs(side) * kWidestArcMm) return {to, std::nullopt};
    const double radius_mm = chord.squaredNorm() / (2 * side);
    const Vec2 centre = from + radius_mm * leftOf(along);
    return {to, Arc{centre, std::abs(radius_mm), radius_mm > 0}};
}

}  // namespace stepmill
