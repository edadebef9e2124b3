// Fewer slabs where they tell no more.

#include <algorithm>
#include <optional>

#include "layers/slab/cut_layer.h"
#include "layers/slab/local_boolean.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/path_parts.h"
#include "stepmill/planar/wider_than.h"

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

/// What of the upper slab joining may cost.
struct AllowedLoss {
    double share = 0;  ///< of the area of each component of what is removed
    /// Stairs on walls may be so wide, what is wider stands there for itself; nothing: as wide as they are.
    std::optional<double> widest_mm;
    bool holes_too = false;  ///< else none on the wall of a hole: a drill makes it round
};

/// Does every component of what is removed above lose no more than that if the lower shadow is kept clear of
/// above as well?
bool losesLittle(const Layer& upper, const Layer& lower, const AllowedLoss& allowed, const Tolerances& tol) {
    // If all components together lose more, one of them does.
    if (area(lower.shadow) - area(upper.shadow) > allowed.share * (area(upper.stock) - area(upper.shadow)))
        return false;
    const std::vector<Region> removed = components(subtract(upper.stock, upper.shadow, tol));
    std::vector<double> lost(removed.size(), 0);
    for (const Region& piece : components(subtract(lower.shadow, upper.shadow, tol))) {
        if (area(piece) <= tol.area_mm2) continue;
        if (allowed.widest_mm && isWiderThan(piece, *allowed.widest_mm, tol)) return false;
        std::size_t at = 0;
        while (at < removed.size() && !contains(removed[at], deepestVertex(piece, removed[at])))
            ++at;
        if (at == removed.size()) return false;
        const bool hole = removed[at].loops.size() == 1 && isFullCircle(removed[at].loops.front());
        if (hole && !allowed.holes_too) return false;
        lost[at] += area(piece);
        if (lost[at] > allowed.share * area(removed[at])) return false;
    }
    return true;
}

bool mayJoin(const Layer& upper, const CutLayer& lower, double thinnest_mm, const SliceOptions& options,
             const Tolerances& tol) {
    if (!lower.soft_top || !sameStock(upper, lower.layer)) return false;
    if (sameShadow(upper, lower.layer, tol)) return true;
    const bool thin = upper.height_mm() < thinnest_mm;
    const AllowedLoss allowed = thin ? AllowedLoss{options.largest_hidden_share, std::nullopt, true}
                                     : AllowedLoss{options.largest_joined_share, options.widest_stair_mm};
    return losesLittle(upper, lower.layer, allowed, tol);
}

const Region& halfWay(const Layer& layer) {
    return layer.stock_air_mm3 > 0 ? layer.stock_half_way : layer.stock;
}

void join(CutLayer& upper, CutLayer&& lower, const Tolerances& tol) {
    Layer& layer = upper.layer;
    layer.stock_half_way = uniteLocally(halfWay(lower.layer), halfWay(layer), tol);
    layer.vertical_walls = layer.vertical_walls && lower.layer.vertical_walls &&
                           compareLoops(layer.part, lower.layer.part).places.empty();
    layer.bottom_z_mm = lower.layer.bottom_z_mm;
    // The wider region below hides the narrower one above: ask that way round first.
    layer.part = uniteLocally(lower.layer.part, layer.part, tol);
    layer.shadow = std::move(lower.layer.shadow);
    layer.mended_by_mm = std::max(layer.mended_by_mm, lower.layer.mended_by_mm);
    upper.part_volume_mm3 += lower.part_volume_mm3;
    for (const auto& [face, share] : lower.leaning)
        upper.leaning[face].add(share);
    for (const auto& [face, volume_mm3] : lower.in_cones_mm3)
        upper.in_cones_mm3[face] += volume_mm3;
    std::move(lower.remarks.begin(), lower.remarks.end(), std::back_inserter(upper.remarks));
}

/// What the slabs joined to one hold, each for itself.
struct Contents {
    double stock_mm3 = 0;
    double air_mm3 = 0;  ///< in `stock_mm3`
    double shadow_mm3 = 0;

    void add(const CutLayer& cut) {
        const Layer& layer = cut.layer;
        stock_mm3 += area(layer.stock) * layer.height_mm() - cut.shared_air_mm3;
        air_mm3 += layer.stock_air_mm3;
        shadow_mm3 += area(layer.shadow) * layer.height_mm();
    }
};

/// The stock of both slabs where they may be joined over stock that differs: all slabs so joined then cover
/// air and hide removal of no more than `worthless_mm3`.
std::optional<Region> commonStock(const Layer& upper, const CutLayer& lower, Contents apart,
                                  double worthless_mm3, const Tolerances& tol) {
    if (!lower.soft_top || worthless_mm3 <= 0) return std::nullopt;
    // Where the stock's walls stand upright a vise can hold it: such slabs do not join leaning ones.
    if ((upper.stock_air_mm3 > 0) != (lower.layer.stock_air_mm3 > 0)) return std::nullopt;
    apart.add(lower);
    const double height = upper.top_z_mm - lower.layer.bottom_z_mm;
    const double hidden_mm3 = area(lower.layer.shadow) * height - apart.shadow_mm3;
    const double widest_mm2 = std::max(area(upper.stock), area(lower.layer.stock));
    if (hidden_mm3 + widest_mm2 * height - apart.stock_mm3 > worthless_mm3) return std::nullopt;
    Region stock = uniteLocally(lower.layer.stock, upper.stock, tol);
    if (hidden_mm3 + area(stock) * height - apart.stock_mm3 > worthless_mm3) return std::nullopt;
    return stock;
}

}  // namespace

std::vector<CutLayer> mergeSlabs(std::vector<CutLayer> cuts, double worthless_mm3,
                                 const SliceOptions& options, const Tolerances& tol) {
    if (cuts.empty()) return cuts;
    // A millimetre is little on a part of common size; on a very small one a twentieth of its height is.
    const double height = cuts.front().layer.top_z_mm - cuts.back().layer.bottom_z_mm;
    const double thinnest = std::min(options.thinnest_slab_mm, 0.05 * height);
    std::vector<CutLayer> merged;
    // What the joined slab may cost is measured from its topmost slab, whose removal is the largest.
    Layer topmost;
    Contents apart;
    for (CutLayer& cut : cuts) {
        if (!merged.empty()) {
            Layer& above = merged.back().layer;
            topmost.bottom_z_mm = above.bottom_z_mm;
            if (mayJoin(topmost, cut, thinnest, options, tol)) {
                apart.add(cut);
                const double more_air_mm3 = cut.layer.stock_air_mm3;
                join(merged.back(), std::move(cut), tol);
                above.stock_air_mm3 += more_air_mm3;
                continue;
            }
            if (std::optional<Region> stock = commonStock(above, cut, apart, worthless_mm3, tol)) {
                apart.add(cut);
                join(merged.back(), std::move(cut), tol);
                above.stock_air_mm3 =
                    std::max(0.0, apart.air_mm3 + area(*stock) * above.height_mm() - apart.stock_mm3);
                above.stock = topmost.stock = std::move(*stock);
                continue;
            }
        }
        topmost = cut.layer;
        apart = {};
        apart.add(cut);
        merged.push_back(std::move(cut));
    }
    return merged;
}

}  // namespace stepmill::layers
