#include "planar/boolean/curve_pairs.h"

#include <cmath>
#include <limits>

#include "planar/segment.h"
#include "stepmill/core/units.h"

namespace stepmill::planar {

bool adjacent(const Curve& a, const Curve& b) {
    return a.loop == b.loop && (a.segment.to == b.from || b.segment.to == a.from);
}

bool crossesBesideCorner(const Curve& a, const Curve& b, const Vec2& p) {
    double from_corner = std::numeric_limits<double>::infinity();
    if (a.segment.to == b.from) from_corner = std::min(from_corner, (p - b.from).norm());
    if (b.segment.to == a.from) from_corner = std::min(from_corner, (p - a.from).norm());
    constexpr double kDeepMm = 10 * kGridMm;
    if (from_corner / 4 <= kDeepMm) return false;
    const Vec2 ta = tangentAt(a.from, a.segment, shareOf(p, a.from, a.segment));
    const Vec2 tb = tangentAt(b.from, b.segment, shareOf(p, b.from, b.segment));
    // The two curves part by about a quarter of chord times angle in between.
    return from_corner * std::abs(cross(ta, tb)) / 4 > kDeepMm;
}

}  // namespace stepmill::planar
