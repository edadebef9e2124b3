// Slots as wide as the cutter: their centres are a curve, not an area.

#include "access/slot_middles.h"

#include <algorithm>

#include "stepmill/access/slivers.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/indexed_region.h"

namespace stepmill::access {
namespace {

/// Shorter stretches are corners, or necks between rooms; in cutter radii.
constexpr double kShortestSlotRadii = 0.25;
/// Edges at the ends of a strip are no longer than so many of its widths.
constexpr double kEndWidths = 4;
/// A strip is drawn together by this share of the fit tolerance before its side is taken for its middle, ...
constexpr double kToMiddleShare = 0.8;
/// ... unless it loses length.
constexpr double kSameLengthShare = 0.99;
/// Where a boundary turns back on itself its directions are opposite: their product is less than this.
constexpr double kTurnsBack = -0.9;
/// The middle runs on so far beyond where the disc leaves the target [mm].
constexpr double kBeyondMm = 0.01;
/// Steps in which it is looked for where the disc leaves the target, in radii, ...
constexpr double kStepRadii = 0.25;
/// ... as far as two radii and this beyond the slot: stock may stand before it [mm].
constexpr double kFarthestMm = 2;

/// A closed strip's boundary goes along it and back: one of the two. A ring's goes round it once and has a
/// hole; of a strip that forks all is kept.
Path middleOf(const Region& strip, double width_mm) {
    const Loop& loop = strip.loops.front();
    const std::vector<Edge> edges = edgesOf(loop);
    std::vector<std::size_t> sides;
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (length(edges[i]) > kEndWidths * width_mm) sides.push_back(i);
    std::vector<std::size_t> after_turns;  // in `sides`
    for (std::size_t k = 0; k < sides.size(); ++k) {
        const Edge& before = edges[sides[(k + sides.size() - 1) % sides.size()]];
        if (tangentAt(before, 1).dot(tangentAt(edges[sides[k]], 0)) < kTurnsBack) after_turns.push_back(k);
    }
    if (after_turns.size() != 2) return loop;
    const std::size_t first = sides[after_turns[0]];
    const std::size_t last = sides[after_turns[1] - 1];
    Path middle{edges[first].from, {}};
    for (std::size_t i = first; i <= last; ++i)
        middle.segments.push_back(edges[i].segment);
    return middle;
}

/// How far beyond an end of the middle the disc has left the target; nothing where it meets a wall before.
std::optional<Vec2> outInTheAir(const FeatureGround& ground, double radius_mm, const Vec2& end,
                                const Vec2& outward) {
    const Tolerances& tol = ground.tolerances();
    if (ground.walledIn()) return std::nullopt;
    const Feature& feature = ground.feature();
    const IndexedRegion walls(feature.obstruction);
    const double near_mm = radius_mm - tol.fit_mm - tol.linear_mm;
    const double farthest_mm = 2 * radius_mm + kFarthestMm;
    for (double out_mm = kBeyondMm; out_mm <= farthest_mm; out_mm += kStepRadii * radius_mm) {
        const Vec2 at = snapToGrid(Vec2(end + outward * out_mm));
        if (walls.contains(at) || walls.boundary().anyNearer(makeEdge(end, {at, std::nullopt}), near_mm))
            return std::nullopt;
        if (distanceToRegion(feature.target, at) >= radius_mm + tol.guard_mm) return at;
    }
    return std::nullopt;
}

/// A straight strip, both sides `half_mm` from its middle.
Region stripAround(const Vec2& from, const Vec2& to, double half_mm) {
    const Vec2 along = (to - from).normalized() * half_mm;
    const Vec2 side = leftOf(along);
    return makePolygon({from - along - side, to - side, to + side, from - along + side});
}

/// The strip drawn together nearly to its middle, where it is as wide all along.
Region nearMiddle(const Region& strip, const Tolerances& tol) {
    Region near = offset(strip, -kToMiddleShare * tol.fit_mm, tol);
    const bool whole = components(near).size() == 1 && perimeter(near) > kSameLengthShare * perimeter(strip);
    return whole ? near : strip;
}

/// Lengthens the middle over the slot's open ends.
void openEnds(const FeatureGround& ground, double radius_mm, SlotCentres& slot) {
    if (slot.middle.closed()) return;
    const double half_mm = ground.tolerances().fit_mm;
    std::vector<Region> strips{slot.along};
    for (int end = 0; end < 2; ++end) {
        slot.middle = reversed(slot.middle);
        const Vec2 last = slot.middle.end();
        const Edge edge = edgesOf(slot.middle).back();
        const auto out = outInTheAir(ground, radius_mm, last, tangentAt(edge, 1));
        if (!out) continue;
        slot.middle.segments.push_back({*out, std::nullopt});
        strips.push_back(stripAround(last, *out, half_mm));
    }
    if (strips.size() > 1) slot.along = unite(strips, ground.tolerances());
}

}  // namespace

std::vector<SlotCentres> slotCentres(const FeatureGround& ground, double radius_mm, const Region& usual,
                                     const Region& narrow) {
    const Tolerances& tol = ground.tolerances();
    const Region rest = usual.empty() ? narrow : subtract(narrow, offset(usual, 2 * tol.fit_mm, tol), tol);
    std::vector<SlotCentres> slots;
    for (const Region& component : components(rest)) {
        if (boundingBox(component).sizes().norm() < kShortestSlotRadii * radius_mm) continue;
        SlotCentres slot{middleOf(nearMiddle(component, tol), 2 * tol.fit_mm), component, {}};
        openEnds(ground, radius_mm, slot);
        slot.strip = offset(slot.along, tol.sliver_mm - tol.fit_mm, tol);
        slots.push_back(std::move(slot));
    }
    return slots;
}

Region besideSlots(const FeatureGround& ground, double radius_mm, const Region& usual,
                   const std::vector<SlotCentres>& slots) {
    if (usual.empty()) return {};
    const Tolerances& tol = ground.tolerances();
    std::vector<Region> grown;
    std::vector<Region> swept_by;
    for (const SlotCentres& slot : slots) {
        grown.push_back(offset(slot.strip, tol.fit_mm, tol));
        swept_by.push_back(offset(slot.strip, radius_mm, tol));
    }
    const Region left = subtract(ground.feature().target, unite(swept_by, tol), tol);
    Region kept;
    for (const Region& component : components(subtract(usual, unite(grown, tol), tol))) {
        const Region clears = intersect(left, offset(component, radius_mm, tol), tol);
        if (withoutSliverComponents(clears, tol).empty()) continue;
        kept.loops.insert(kept.loops.end(), component.loops.begin(), component.loops.end());
    }
    return kept;
}

}  // namespace stepmill::access
