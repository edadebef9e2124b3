#include "stepmill/planar/nearer_than.h"

#include <algorithm>

namespace stepmill {
namespace {

/// Has one of the loops its start in the region?
bool anyStartsIn(const Region& region, const Region& loops) {
    return std::any_of(loops.loops.begin(), loops.loops.end(),
                       [&](const Loop& loop) { return contains(region, loop.start); });
}

}  // namespace

bool isNearer(const Region& one, const EdgeIndex& edges_of_one, const Region& other, double distance_mm) {
    if (one.empty() || other.empty()) return false;
    const Box2 reach = grown(edges_of_one.box(), distance_mm);
    for (const Edge& edge : edgesOf(other))
        if (edge.box.intersects(reach) && edges_of_one.anyNearer(edge, distance_mm)) return true;
    // Where no boundaries are near, one lies wholly inside the other or they are apart.
    return anyStartsIn(other, one) || anyStartsIn(one, other);
}

}  // namespace stepmill
