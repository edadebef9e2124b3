#include "stepmill/feature/region_compare.h"

#include <cmath>

#include "stepmill/planar/boolean.h"
#include "stepmill/planar/wider_than.h"

namespace stepmill::feature {
namespace {

bool identicalPaths(const Path& a, const Path& b) {
    if (a.start != b.start || a.segments.size() != b.segments.size()) return false;
    for (std::size_t i = 0; i < a.segments.size(); ++i)
        if (a.segments[i].to != b.segments[i].to || a.segments[i].arc != b.segments[i].arc) return false;
    return true;
}

}  // namespace

bool identical(const Region& a, const Region& b) {
    if (&a == &b) return true;
    if (a.loops.size() != b.loops.size()) return false;
    for (std::size_t i = 0; i < a.loops.size(); ++i)
        if (!identicalPaths(a.loops[i], b.loops[i])) return false;
    return true;
}

bool isSliver(const Region& region, const Tolerances& tol) {
    for (const Region& component : components(region))
        if (isWiderThan(component, tol.sliver_mm, tol)) return false;
    return true;
}

double areaSlack(const Region& region, const Tolerances& tol) {
    return tol.sliver_mm * perimeter(region) + tol.area_mm2;
}

bool sameRegion(const Region& a, const Region& b, const Tolerances& tol) {
    if (identical(a, b)) return true;
    if (std::abs(area(a) - area(b)) > areaSlack(a, tol)) return false;
    return isSliver(subtract(a, b, tol), tol) && isSliver(subtract(b, a, tol), tol);
}

}  // namespace stepmill::feature
