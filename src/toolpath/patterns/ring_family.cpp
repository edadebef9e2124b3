// Contour-parallel rings of free centres.

#include "toolpath/patterns/ring_family.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/error.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/toolpath/path_frame.h"
#include "toolpath/patterns/parallel_lines.h"
#include "toolpath/patterns/stock_offset.h"

namespace stepmill {

namespace toolpath {

namespace {

/// Four guards tell "on the boundary" from "beside it" with rounding to spare.
constexpr double kGuardsOnBoundary = 4;
/// Rings of neighbouring levels are one step-over apart, but for rounding.
constexpr double kNeighbourSlack = 1.01;

}  // namespace

double onBoundaryMm(const Tolerances& tol) {
    return kGuardsOnBoundary * tol.guard_mm;
}

bool cutsNothing(const IndexedRegion& target, double radius_mm, const Vec2& p, const Tolerances& tol) {
    return !target.isNear(p, radius_mm - onBoundaryMm(tol));
}

bool cutsNothing(const IndexedRegion& target, double radius_mm, const Edge& edge, const Tolerances& tol) {
    const int looks = 1 + 2 * static_cast<int>(std::ceil(length(edge) / radius_mm));
    for (int i = 0; i < looks; ++i)
        if (!cutsNothing(target, radius_mm, pointAt(edge, (i + 0.5) / looks), tol)) return false;
    return true;
}

bool isAskedFor(const ClearingTask& task, Pattern pattern) {
    return task.pattern == Pattern::Best ? isAmong(task.patterns, pattern) : task.pattern == pattern;
}

bool adjacent(const EdgeIndex& a, const EdgeIndex& b, double step_over_mm) {
    const double reach = kNeighbourSlack * step_over_mm;
    if (!grown(a.box(), reach).intersects(b.box())) return false;
    return std::any_of(b.edges().begin(), b.edges().end(),
                       [&](const Edge& edge) { return a.anyNearer(edge, reach); });
}

bool isFreeWay(const RingFamily::Component& component, const Vec2& a, const Vec2& b, const Tolerances& tol) {
    if ((a - b).norm() < kGridMm) return true;
    const Edge way = makeLine(a, b);
    if (component.walls.anyNearer(way, tol.guard_mm - 2 * kGridMm)) return false;
    for (const Edge& side : component.open_sides)
        for (const Vec2& p : meetingPoints(way, side))
            if (std::min((p - a).norm(), (p - b).norm()) > onBoundaryMm(tol)) return false;
    return component.open_sides.empty() || component.indexed.contains((a + b) / 2);
}

}  // namespace toolpath

namespace {

using namespace toolpath;

/// Where the boundary of free centres turns back so sharply, the guard keeps rings out of its corner by more
/// than sixteen guards: the product of its directions is less.
constexpr double kTurnsBack = -0.992;
/// Rings lead into such a corner no farther [mm].
constexpr double kDeepestCuspMm = 0.3;

enum class Openness { Walled, Mixed, Open };

/// A ring, and whether the disc along it does no more than touch the target.
struct Inset {
    Loop loop;
    int level = 0;
    Openness openness = Openness::Walled;
    bool outside_in = false;
};

/// Where the boundary turns back: between walls that are there exactly as far apart as the cutter is wide.
std::vector<Vec2> cuspsOf(const Region& region) {
    std::vector<Vec2> cusps;
    for (const Loop& loop : region.loops) {
        const std::vector<Edge> edges = edgesOf(loop);
        for (std::size_t i = 0; i < edges.size(); ++i)
            if (tangentAt(edges[i], 1).dot(tangentAt(edges[(i + 1) % edges.size()], 0)) < kTurnsBack)
                cusps.push_back(edges[i].to());
    }
    return cusps;
}

/// The guard keeps a ring out of a cusp, which between round walls is ten times as deep as the corner that a
/// disc leaves: where it comes near one, the ring goes there and back.
void leadIntoCusps(const IndexedRegion& region, const std::vector<Vec2>& cusps, const Tolerances& tol,
                   Loop& ring) {
    for (const Vec2& cusp : cusps) {
        const auto nearest = std::min_element(
            ring.segments.begin(), ring.segments.end(), [&](const Segment& one, const Segment& other) {
                return (one.to - cusp).squaredNorm() < (other.to - cusp).squaredNorm();
            });
        const Vec2 corner = nearest->to;
        const double deep_mm = (corner - cusp).norm();
        if (deep_mm <= 2 * tol.sliver_mm || deep_mm > kDeepestCuspMm) continue;
        const auto on = [&](double share) { return Vec2(corner + share * (cusp - corner)); };
        const auto isFree = [&](double share) { return region.isNear(on(share), tol.linear_mm); };
        if (!isFree(0.25) || !isFree(0.5) || !isFree(0.75)) continue;
        // A sliver short of where the disc would touch both walls.
        const Vec2 end = snapToGrid(on(1 - tol.sliver_mm / deep_mm));
        ring.segments.insert(std::next(nearest), {{end, std::nullopt}, {corner, std::nullopt}});
    }
}

class FamilyMaker {
  public:
    FamilyMaker(const ClearingTask& task, double radius_mm, double step_over_mm, const Tolerances& tol)
        : task_(task), target_(task.target), radius_mm_(radius_mm), step_over_mm_(step_over_mm), tol_(tol) {}

    RingFamily::Component make(const Region& region) {
        RingFamily::Component component;
        component.region = region;
        component.indexed = IndexedRegion(region);
        std::vector<Edge> walls;
        for (const Edge& edge : component.indexed.boundary().edges())
            (isOpen(edge) ? component.open_sides : walls).push_back(edge);
        component.walls = EdgeIndex(std::move(walls));
        if (addMiddles(component)) return component;
        const std::vector<Inset> insets = insetsOf(region);
        for (const Inset& inset : insets)
            if (inset.level == 0) component.guarded.loops.push_back(inset.loop);
        addContours(component, insets);
        if (isWanted(Pattern::StockOffset))
            if (auto variant = stockOffset(component, step_over_mm_, tol_))
                component.variants.push_back(*variant);
        addCusps(component);
        if (isWanted(Pattern::Zigzag) || isWanted(Pattern::OneWay)) addLines(component);
        return component;
    }

  private:
    bool isWanted(Pattern pattern) const { return isAskedFor(task_, pattern); }

    /// In slots as wide as the cutter one pass along the middle of each is all.
    bool addMiddles(RingFamily::Component& component) const {
        RingFamily::Variant along;
        for (const Path& middle : task_.slot_middles)
            if (component.indexed.contains(middle.start)) along.rings.push_back({middle, 0, false, true});
        if (along.rings.empty()) return false;
        component.slot = true;
        component.guarded = component.region;
        component.variants.push_back(std::move(along));
        return true;
    }

    std::vector<Inset> insetsOf(const Region& region) const {
        std::vector<Inset> insets;
        int level = 0;
        for (const Region& inset : ClearanceDiagram(region, tol_).rings(tol_.guard_mm, step_over_mm_)) {
            for (const Loop& loop : inset.loops)
                insets.push_back({loop, level, level == 0 ? openness(loop) : Openness::Walled, false});
            ++level;
        }
        return insets;
    }

    bool isOpen(const Edge& edge) const { return cutsNothing(target_, radius_mm_, edge, tol_); }

    Openness openness(const Loop& loop) const {
        std::size_t open = 0;
        for (const Edge& edge : edgesOf(loop))
            if (isOpen(edge)) ++open;
        if (open == 0) return Openness::Walled;
        return open == loop.segments.size() ? Openness::Open : Openness::Mixed;
    }

    void addContours(RingFamily::Component& component, std::vector<Inset> insets) const {
        RingFamily::Variant contour;
        contour.leaves_component = std::any_of(insets.begin(), insets.end(), [](const Inset& inset) {
            return inset.openness == Openness::Mixed;
        });
        if (contour.leaves_component) {
            addWallCurves(component, contour);
            component.variants.push_back(std::move(contour));
            return;
        }
        markOutsideIn(insets);
        bool all_outside_in = true;
        RingFamily::Variant walls_first;
        walls_first.pattern = Pattern::ContourOutsideIn;
        for (const Inset& inset : insets) {
            if (inset.openness == Openness::Open) continue;
            all_outside_in = all_outside_in && inset.outside_in;
            contour.rings.push_back(
                {inset.outside_in ? reversed(inset.loop) : inset.loop, inset.level, inset.outside_in});
            // Along the wall the cutter is in full width; there the wall decides what is climb milling.
            walls_first.rings.push_back(
                {inset.level > 0 ? reversed(inset.loop) : inset.loop, inset.level, true});
        }
        component.variants.push_back(std::move(contour));
        if (!all_outside_in && isWanted(Pattern::ContourOutsideIn))
            component.variants.push_back(std::move(walls_first));
    }

    /// Rings along the boundary lead into its cusps.
    void addCusps(RingFamily::Component& component) const {
        const std::vector<Vec2> cusps = cuspsOf(component.region);
        if (cusps.empty()) return;
        for (RingFamily::Variant& contour : component.variants)
            for (RingFamily::Ring& ring : contour.rings)
                if (ring.level == 0) leadIntoCusps(component.indexed, cusps, tol_, ring.path);
    }

    void addLines(RingFamily::Component& component) {
        std::vector<RingFamily::Ring> wall_rings;
        const RingFamily::Variant& contour = component.variants.front();
        for (const RingFamily::Ring& ring : contour.rings)
            if (ring.level == 0) wall_rings.push_back({ring.path, 0, false});
        component.line_ground = component.guarded;
        // A disc on a line need not go beyond an open side farther than clears the target's edge.
        if (!component.open_sides.empty()) {
            if (near_target_.empty()) near_target_ = offset(task_.target, step_over_mm_ / 2, tol_);
            component.line_ground = intersect(component.guarded, near_target_, tol_);
        }
        RingFamily::Variant lines = zigzag(component, wall_rings, step_over_mm_);
        if (lines.lines.empty()) return;
        lines.leaves_component = contour.leaves_component;
        RingFamily::Variant one_way = oneWay(lines);
        component.variants.push_back(std::move(lines));
        component.variants.push_back(std::move(one_way));
    }

    /// Open sides first and walls last: a ring is cut from outside in if every ring it follows from
    /// belongs to an open side.
    void markOutsideIn(std::vector<Inset>& insets) const {
        std::vector<EdgeIndex> edges;
        for (std::size_t i = 0; i < insets.size(); ++i) {
            Inset& inset = insets[i];
            inset.outside_in = inset.level > 0 || inset.openness == Openness::Open;
            edges.emplace_back(inset.loop);
            for (std::size_t j = 0; j < i && inset.outside_in && inset.level > 0; ++j)
                if (insets[j].level == inset.level - 1 && !insets[j].outside_in &&
                    adjacent(edges[j], edges[i], step_over_mm_))
                    inset.outside_in = false;
        }
    }

    /// Curves at r, r + step-over, ... from the walls: where walls and open sides share a boundary these
    /// cut from the open side towards the wall, one step-over at a time.
    void addWallCurves(const RingFamily::Component& component, RingFamily::Variant& contour) const {
        const ClearanceDiagram walls(wallsAround(component.region), tol_);
        for (int level = 0;; ++level) {
            const Region grown = walls.offset(radius_mm_ + tol_.guard_mm + level * step_over_mm_);
            const std::size_t before = contour.rings.size();
            for (const Loop& loop : grown.loops)
                if (reaches(component, loop)) contour.rings.push_back({reversed(loop), level, false});
            // Distances from the walls have no gaps in a component, so the first level beyond it is the last.
            if (contour.rings.size() == before) return;
        }
    }

    bool reaches(const RingFamily::Component& component, const Loop& loop) const {
        const std::vector<Edge> edges = edgesOf(loop);
        return std::any_of(edges.begin(), edges.end(), [&](const Edge& edge) {
            return component.indexed.contains(edge.from) ||
                   component.indexed.boundary().anyNearer(edge, onBoundaryMm(tol_));
        });
    }

    /// The obstruction without the holes that do not concern this component.
    Region wallsAround(const Region& region) const {
        const Box2 box = grown(boundingBox(region), 2 * radius_mm_);
        Region walls;
        for (const Loop& loop : task_.obstruction.loops)
            if (signedArea(loop) > 0 || boundingBox(loop).intersects(box)) walls.loops.push_back(loop);
        return walls;
    }

    const ClearingTask& task_;
    IndexedRegion target_;
    Region near_target_;  ///< half a step-over beyond it; made when a component asks for it
    double radius_mm_;
    double step_over_mm_;
    const Tolerances& tol_;
};

}  // namespace

RingFamily::RingFamily(const ClearingTask& task, double radius_mm, double step_over_mm, const Tolerances& tol)
    : radius_mm_(radius_mm), step_over_mm_(step_over_mm) {
    STEPMILL_CHECK(step_over_mm > 0 && step_over_mm <= radius_mm, "rings further apart than the radius");
    FamilyMaker maker(task, radius_mm, step_over_mm, tol);
    for (const Region& region : stepmill::components(task.free_centres))
        components_.push_back(maker.make(region));
}

std::shared_ptr<const RingFamily> makeRings(const ClearingTask& task, const ToolAssembly& tool,
                                            const CuttingData& cutting, const Tolerances& tol) {
    const double r = tool.radius_mm();
    return std::make_shared<const RingFamily>(task, r, usedStepOver(cutting, r), tol);
}

}  // namespace stepmill
