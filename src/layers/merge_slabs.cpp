// Fewer slabs where they tell no more.

#include <algorithm>

#include "layers/cut_layer.h"
#include "layers/local_boolean.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::layers {

namespace {

bool sameStock(const Layer& a, const Layer& b) {
    return compareLoops(a.stock, b.stock).places.empty();
}

/// Is the lower shadow the upper one, but for what a section half a micrometre inside its slab shows of a
/// leaning wall?
bool sameShadow(const Layer& upper, const Layer& lower, const Tolerances& tol) {
    const double more = area(lower.shadow) - area(upper.shadow);
    return more <= tol.area_mm2 + tol.gouge_mm * perimeter(lower.shadow);
}

/// The vertex of a region that lies deepest in another.
Vec2 deepestVertex(const Region& region, const Region& inside) {
    Vec2 deepest = region.loops.front().start;
    double most = -1;
    for (const Loop& loop : region.loops)
        for (const Segment& segment : loop.segments) {
            const double depth = contains(inside, segment.to) ? distanceToBoundary(inside, segment.to) : -1;
            if (depth <= most) continue;
            most = depth;
            deepest = segment.to;
        }
    return deepest;
}

/// Does every component of what is removed above keep all but that share of its area if the lower shadow
/// is kept clear of above as well?
bool losesLittle(const Layer& upper, const Layer& lower, double share, const Tolerances& tol) {
    // If all components together lose more, one of them does.
    if (area(lower.shadow) - area(upper.shadow) > share * (area(upper.stock) - area(upper.shadow)))
        return false;
    const std::vector<Region> removed = components(subtract(upper.stock, upper.shadow, tol));
    std::vector<double> lost(removed.size(), 0);
    for (const Region& piece : components(subtract(lower.shadow, upper.shadow, tol))) {
        if (area(piece) <= tol.area_mm2) continue;
        std::size_t at = 0;
        while (at < removed.size() && !contains(removed[at], deepestVertex(piece, removed[at])))
            ++at;
        if (at == removed.size()) return false;
        lost[at] += area(piece);
        if (lost[at] > share * area(removed[at])) return false;
    }
    return true;
}

bool mayJoin(const Layer& upper, const CutLayer& lower, double thinnest_mm, const SliceOptions& options,
             const Tolerances& tol) {
    if (!lower.soft_top || !sameStock(upper, lower.layer)) return false;
    if (sameShadow(upper, lower.layer, tol)) return true;
    return upper.height_mm() < thinnest_mm &&
           losesLittle(upper, lower.layer, options.largest_hidden_share, tol);
}

void join(CutLayer& upper, CutLayer&& lower, const Tolerances& tol) {
    Layer& layer = upper.layer;
    layer.vertical_walls = layer.vertical_walls && lower.layer.vertical_walls &&
                           compareLoops(layer.part, lower.layer.part).places.empty();
    layer.bottom_z_mm = lower.layer.bottom_z_mm;
    // The wider region below hides the narrower one above: ask that way round first.
    layer.part = uniteLocally(lower.layer.part, layer.part, tol);
    layer.shadow = std::move(lower.layer.shadow);
    layer.stock_air_mm3 += lower.layer.stock_air_mm3;
    layer.mended_by_mm = std::max(layer.mended_by_mm, lower.layer.mended_by_mm);
    upper.part_volume_mm3 += lower.part_volume_mm3;
    for (const auto& [face, share] : lower.leaning)
        upper.leaning[face].add(share);
    std::move(lower.remarks.begin(), lower.remarks.end(), std::back_inserter(upper.remarks));
}

}  // namespace

std::vector<CutLayer> mergeSlabs(std::vector<CutLayer> cuts, const SliceOptions& options,
                                 const Tolerances& tol) {
    if (cuts.empty()) return cuts;
    // A millimetre is little on a part of common size; on a very small one a twentieth of its height is.
    const double height = cuts.front().layer.top_z_mm - cuts.back().layer.bottom_z_mm;
    const double thinnest = std::min(options.thinnest_slab_mm, 0.05 * height);
    std::vector<CutLayer> merged;
    // What the joined slab may cost is measured from its topmost slab, whose removal is the largest.
    Layer topmost;
    for (CutLayer& cut : cuts) {
        if (!merged.empty()) {
            topmost.bottom_z_mm = merged.back().layer.bottom_z_mm;
            if (mayJoin(topmost, cut, thinnest, options, tol)) {
                join(merged.back(), std::move(cut), tol);
                continue;
            }
        }
        topmost = cut.layer;
        merged.push_back(std::move(cut));
    }
    return merged;
}

}  // namespace stepmill::layers
