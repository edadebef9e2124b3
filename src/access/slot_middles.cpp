// Slots as wide as the cutter: their centres are a curve, not an area.

#include "access/slot_middles.h"

#include <algorithm>
#include <array>

#include "stepmill/access/slivers.h"
#include "stepmill/access/swept.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/indexed_region.h"
#include "stepmill/planar/path_parts.h"
#include "stepmill/planar/tangent_arc.h"

namespace stepmill::access {
namespace {

/// Shorter stretches are corners, or necks between rooms; in cutter radii.
constexpr double kShortestSlotRadii = 0.25;
/// Edges at the ends of a strip are no longer than so many of its widths.
constexpr double kEndWidths = 4;
/// A strip is drawn together to this share of the fit tolerance before its side is taken for its middle, ...
constexpr double kFromMiddleShare = 0.2;
/// ... unless it loses length.
constexpr double kSameLengthShare = 0.99;
/// Where a boundary turns back on itself its directions are opposite: their product is less than this.
constexpr double kTurnsBack = -0.9;
/// Of two that cross, each ends about a radius before the crossing: so far apart are its ends at most, in
/// radii, ...
constexpr double kAcrossRadii = 2.5;
/// ... and no farther is an end from another's middle.
constexpr double kToOtherRadii = 1.5;
/// Ways on lie ahead, their ends' middles nearly in the same direction: the product of the directions is
/// more.
constexpr double kStraightOn = 0.9;
constexpr double kSameDirection = 0.999;
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

/// Along one side of a way, `off_mm` to its left.
Segment beside(const Edge& way, double off_mm) {
    const Vec2 to = snapToGrid(Vec2(way.to() + off_mm * leftOf(tangentAt(way, 1))));
    if (!way.segment.arc) return {to, std::nullopt};
    Arc arc = *way.segment.arc;
    arc.radius_mm += arc.ccw ? -off_mm : off_mm;
    return {to, arc};
}

/// A strip from a little before the way's start, both sides `half_mm` from it.
Region stripAround(const Edge& way, double half_mm) {
    const Vec2 left = half_mm * leftOf(tangentAt(way, 0));
    const Vec2 before = way.from - half_mm * tangentAt(way, 0);
    const Path left_side = reversed(Path{snapToGrid(Vec2(way.from + left)), {beside(way, half_mm)}});
    Loop loop{snapToGrid(Vec2(before - left)), {}};
    const auto lineTo = [&](const Vec2& to) { loop.segments.push_back({snapToGrid(to), std::nullopt}); };
    lineTo(way.from - left);
    loop.segments.push_back(beside(way, -half_mm));
    lineTo(left_side.start);
    loop.segments.push_back(left_side.segments.front());
    lineTo(before + left);
    lineTo(loop.start);
    return {{std::move(loop)}};
}

/// The strip drawn together nearly to its middle, where it is as wide all along.
Region nearMiddle(const Region& strip, const Tolerances& tol) {
    const double half_mm = area(strip) / perimeter(strip);
    Region near = offset(strip, std::min(0.0, kFromMiddleShare * tol.fit_mm - half_mm), tol);
    const bool whole = components(near).size() == 1 && perimeter(near) > kSameLengthShare * perimeter(strip);
    return whole ? near : strip;
}

bool isLong(const Region& strip, double radius_mm) {
    return boundingBox(strip).sizes().norm() >= kShortestSlotRadii * radius_mm;
}

/// A slot a micrometre wider than the cutter that leads into a room is a strip of the room's centres, too
/// thin for passes: the centres without such strips.
Region withoutStrips(const Region& centres, double radius_mm, const Tolerances& tol) {
    if (centres.empty()) return centres;
    const Region rooms = ClearanceDiagram(centres, tol).opening(halfSliverMm(tol));
    std::vector<Region> strips;
    for (const Region& lost : components(subtract(centres, offset(rooms, 2 * tol.fit_mm, tol), tol)))
        if (isLong(lost, radius_mm)) strips.push_back(offset(lost, tol.fit_mm, tol));
    return strips.empty() ? centres : subtract(centres, strips, tol);
}

/// The middles of slots, to be led on beyond where they end: across others' crossings, up to where they meet
/// another, and out into the air.
class Middles {
  public:
    Middles(const FeatureGround& ground, double radius_mm)
        : ground_(ground),
          radius_mm_(radius_mm),
          near_mm_(radius_mm - ground.tolerances().fit_mm - ground.tolerances().linear_mm),
          walls_(ground.feature().obstruction) {}

    void add(const Region& component) {
        const Tolerances& tol = ground_.tolerances();
        middles_.push_back(middleOf(nearMiddle(component, tol), 2 * tol.fit_mm));
        strips_.push_back(component);
    }

    /// Where two cross, the disc has room between the corners, and each ends on both sides of it.
    void leadAcross() {
        std::vector<Gap> gaps;
        for (std::size_t i = 0; i < middles_.size(); ++i)
            for (std::size_t j = i; j < middles_.size(); ++j)
                addGaps(i, j, gaps);
        std::stable_sort(gaps.begin(), gaps.end(),
                         [](const Gap& a, const Gap& b) { return length(a.way) < length(b.way); });
        std::vector<std::array<const Gap*, 2>> gap_at(middles_.size(), {nullptr, nullptr});
        for (const Gap& gap : gaps) {
            const Gap*& one = gap_at[gap.from.middle][gap.from.at_end];
            const Gap*& other = gap_at[gap.to.middle][gap.to.at_end];
            if (one == nullptr && other == nullptr) one = other = &gap;
        }
        joinOver(gap_at);
    }

    /// Where one ends beside another it goes on to it.
    void leadToOthers() {
        const std::vector<Path> others = middles_;
        for (std::size_t i = 0; i < middles_.size(); ++i)
            leadOn(i,
                   [&](const Vec2& end, const Vec2& outward) { return nextMiddle(others, i, end, outward); });
    }

    /// Over open ends they go on into the air.
    void leadOut() {
        for (std::size_t i = 0; i < middles_.size(); ++i)
            leadOn(i, [&](const Vec2& end, const Vec2& outward) { return outInTheAir(end, outward); });
    }

    /// Those that cross or meet belong together.
    std::vector<SlotCentres> together() const {
        const Tolerances& tol = ground_.tolerances();
        std::vector<SlotCentres> slots;
        for (Region& along : components(unite(strips_, tol)))
            slots.push_back({{}, std::move(along), {}});
        if (slots.empty()) return slots;
        for (const Path& middle : middles_)
            // It may start on the strip's very end.
            std::min_element(slots.begin(), slots.end(), [&](const SlotCentres& a, const SlotCentres& b) {
                return distanceToRegion(a.along, middle.start) < distanceToRegion(b.along, middle.start);
            })->middles.push_back(middle);
        std::erase_if(slots, [](const SlotCentres& slot) { return slot.middles.empty(); });
        for (SlotCentres& slot : slots)
            slot.strip = offset(slot.along, tol.sliver_mm - tol.fit_mm, tol);
        return slots;
    }

  private:
    struct End {
        std::size_t middle = 0;
        bool at_end = false;
    };
    /// Between the ends of two middles, or of one that a crossing parts.
    struct Gap {
        End from;
        End to;
        Edge way;
    };

    Vec2 pointAt(const End& end) const {
        return end.at_end ? middles_[end.middle].end() : middles_[end.middle].start;
    }
    Vec2 outwardAt(const End& end) const {
        const std::vector<Edge> edges = edgesOf(middles_[end.middle]);
        return end.at_end ? tangentAt(edges.back(), 1) : Vec2(-tangentAt(edges.front(), 0));
    }
    bool isFree(const Edge& way) const { return !walls_.boundary().anyNearer(way, near_mm_); }

    void addGaps(std::size_t i, std::size_t j, std::vector<Gap>& gaps) const {
        if (middles_[i].closed() || middles_[j].closed()) return;
        for (const bool from_end : {false, true})
            for (const bool to_end : {false, true}) {
                if (i == j && (from_end || !to_end)) continue;
                const End from{i, from_end};
                const End to{j, to_end};
                const double apart_mm = (pointAt(to) - pointAt(from)).norm();
                if (apart_mm < kGridMm || apart_mm > kAcrossRadii * radius_mm_) continue;
                const Edge way = makeEdge(pointAt(from), arcTo(pointAt(from), outwardAt(from), pointAt(to)));
                const bool straight_on =
                    outwardAt(from).dot(pointAt(to) - pointAt(from)) > kStraightOn * apart_mm &&
                    tangentAt(way, 1).dot(outwardAt(to)) < -kSameDirection;
                if (straight_on && isFree(way)) gaps.push_back({from, to, way});
            }
    }

    /// Middles that gaps join become one; those that lead back to their own start are closed.
    void joinOver(const std::vector<std::array<const Gap*, 2>>& gap_at) {
        std::vector<Path> joined;
        std::vector<bool> taken(middles_.size(), false);
        // From an end that nothing joins; what is left after that are rings.
        for (const bool rings : {false, true})
            for (std::size_t i = 0; i < middles_.size(); ++i)
                for (const bool at_end : {false, true})
                    if (!taken[i] && (rings || gap_at[i][at_end] == nullptr))
                        joined.push_back(chainFrom({i, at_end}, gap_at, taken));
        middles_ = std::move(joined);
    }

    Path chainFrom(End at, const std::vector<std::array<const Gap*, 2>>& gap_at, std::vector<bool>& taken) {
        Path chain{pointAt(at), {}};
        for (;;) {
            taken[at.middle] = true;
            const Path next = at.at_end ? reversed(middles_[at.middle]) : middles_[at.middle];
            chain.segments.insert(chain.segments.end(), next.segments.begin(), next.segments.end());
            const Gap* gap = gap_at[at.middle][!at.at_end];
            if (gap == nullptr) return chain;
            const bool forward = gap->from.middle == at.middle && gap->from.at_end != at.at_end;
            at = forward ? gap->to : gap->from;
            strips_.push_back(stripAround(gap->way, ground_.tolerances().fit_mm));
            const Path way{gap->way.from, {gap->way.segment}};
            chain.segments.push_back((forward ? way : reversed(way)).segments.front());
            if (taken[at.middle]) return chain;
        }
    }

    /// Where to lead middle i on from each of its ends, if anywhere: a function of the end and its direction.
    template <typename Where>
    void leadOn(std::size_t i, const Where& where) {
        Path& middle = middles_[i];
        if (middle.closed()) return;
        for (int end = 0; end < 2; ++end) {
            middle = reversed(middle);
            const Vec2 last = middle.end();
            const std::optional<Vec2> to = where(last, tangentAt(edgesOf(middle).back(), 1));
            if (!to) continue;
            middle.segments.push_back({*to, std::nullopt});
            strips_.push_back(stripAround(makeLine(last, *to), ground_.tolerances().fit_mm));
        }
    }

    std::optional<Vec2> nextMiddle(const std::vector<Path>& others, std::size_t own, const Vec2& end,
                                   const Vec2& outward) const {
        for (std::size_t j = 0; j < others.size(); ++j) {
            if (j == own) continue;
            const Vec2 on = snapToGrid(nearestOn(others[j], end).point);
            const double length_mm = (on - end).norm();
            if (length_mm < kGridMm || length_mm > kToOtherRadii * radius_mm_) continue;
            if ((on - end).dot(outward) > kStraightOn * length_mm && isFree(makeLine(end, on))) return on;
        }
        return std::nullopt;
    }

    /// How far beyond an end of a middle the disc has left the target; nothing where it meets a wall before.
    std::optional<Vec2> outInTheAir(const Vec2& end, const Vec2& outward) const {
        if (ground_.walledIn()) return std::nullopt;
        const double farthest_mm = 2 * radius_mm_ + kFarthestMm;
        for (double out_mm = kBeyondMm; out_mm <= farthest_mm; out_mm += kStepRadii * radius_mm_) {
            const Vec2 at = snapToGrid(Vec2(end + outward * out_mm));
            if (walls_.contains(at) || !isFree(makeLine(end, at))) return std::nullopt;
            if (distanceToRegion(ground_.feature().target, at) >= radius_mm_ + ground_.tolerances().guard_mm)
                return at;
        }
        return std::nullopt;
    }

    const FeatureGround& ground_;
    double radius_mm_;
    double near_mm_;  ///< the axis comes no nearer to walls
    IndexedRegion walls_;
    std::vector<Path> middles_;
    std::vector<Region> strips_;
};

}  // namespace

std::vector<SlotCentres> slotCentres(const FeatureGround& ground, double radius_mm, const Region& usual,
                                     const Region& narrow) {
    const Tolerances& tol = ground.tolerances();
    const Region rooms = withoutStrips(usual, radius_mm, tol);
    const Region rest = rooms.empty() ? narrow : subtract(narrow, offset(rooms, 2 * tol.fit_mm, tol), tol);
    Middles middles(ground, radius_mm);
    for (const Region& component : components(rest))
        if (isLong(component, radius_mm)) middles.add(component);
    middles.leadAcross();
    middles.leadToOthers();
    middles.leadOut();
    return middles.together();
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
        append(kept, component);
    }
    return kept;
}

}  // namespace stepmill::access
