#include "stepmill/planar/indexed_region.h"

#include "planar/segment.h"

namespace stepmill {

bool IndexedRegion::contains(const Vec2& p) const {
    if (boundary_.empty()) return false;
    // Edges away from the ray that winding numbers are counted along have no share in them.
    const double right_mm = std::max(p.x(), boundary_.box().max().x());
    const Box2 ray = grown(Box2(p, Vec2(right_mm, p.y())), 2 * kGridMm);
    int winding = 0;
    boundary_.forEachIn(
        ray, [&](const Edge& edge) { winding += planar::windingShare(edge.from, edge.segment, p); });
    if (winding > 0) return true;
    bool on_boundary = false;
    boundary_.forEachIn(grown(Box2(p), 2 * kGridMm), [&](const Edge& edge) {
        on_boundary = on_boundary || distanceTo(p, edge) <= kGridMm;
    });
    return on_boundary;
}

}  // namespace stepmill
