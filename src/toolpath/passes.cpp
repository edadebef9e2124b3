// The family of contour-parallel passes of one layer.

#include "toolpath/passes.h"

#include <algorithm>
#include <cmath>

#include "stepmill/planar/clearance_diagram.h"
#include "toolpath/curve.h"

namespace stepmill::toolpath {

namespace {

/// Rings are the guard away from boundaries they belong to; four guards tell "on the boundary" from
/// "beside it" with rounding to spare.
constexpr double kGuardsOnBoundary = 4;
/// Rings of neighbouring levels are one step-over apart, but for rounding.
constexpr double kNeighbourSlack = 1.01;

enum class Openness { Walled, Mixed, Open };

/// A ring before clipping.
struct Ring {
    Loop loop;
    int level = 0;
    bool open = false;        ///< lies wholly where the disc only touches the target
    bool outside_in = false;  ///< all rings around it, up to the boundary, are open
};

class PassMaker {
  public:
    PassMaker(const ClearingTask& task, double radius_mm, double step_over_mm, const Tolerances& tol)
        : task_(task),
          radius_mm_(radius_mm),
          step_over_mm_(step_over_mm),
          tol_(tol),
          on_mm_(kGuardsOnBoundary * tol.guard_mm),
          cleared_edges_(edgesOf(task.cleared_centres)) {
        const double rest = area(task.free_centres) - area(task.cleared_centres) - area(task.centres);
        limited_ = rest > tol.area_mm2 + tol.sliver_mm * perimeter(task.free_centres);
        if (limited_) centre_edges_ = edgesOf(task.centres);
    }

    PassSet make() {
        set_.components = components(task_.free_centres);
        const Box2 wanted = boundingBox(task_.centres);
        for (std::size_t i = 0; i < set_.components.size(); ++i) {
            const Region& component = set_.components[i];
            if (!boundingBox(component).overlaps(wanted)) continue;
            const std::size_t first = set_.passes.size();
            addComponent(component, static_cast<int>(i));
            orderByLevel(first);
        }
        return std::move(set_);
    }

  private:
    void addComponent(const Region& component, int index) {
        const ClearanceDiagram diagram(component, tol_);
        std::vector<Ring> rings = ringsOf(diagram);
        const bool mixed = std::any_of(rings.begin(), rings.end(), [&](const Ring& ring) {
            return ring.level == 0 && openness(ring.loop) == Openness::Mixed;
        });
        if (mixed) {
            addWallCurves(component, index);
        } else {
            markOutsideIn(rings);
            for (const Ring& ring : rings)
                if (!ring.open) clip(ring.outside_in ? reversed(ring.loop) : ring.loop, ring, index, nullptr);
        }
        if (limited_) addLimits(component, index);
    }

    std::vector<Ring> ringsOf(const ClearanceDiagram& diagram) const {
        std::vector<Ring> rings;
        int level = 0;
        for (const Region& inset : diagram.rings(tol_.guard_mm, step_over_mm_)) {
            for (const Loop& loop : inset.loops)
                rings.push_back({loop, level, level == 0 && openness(loop) == Openness::Open, false});
            ++level;
        }
        return rings;
    }

    /// Does a disc here do no more than touch the target?
    bool cutsNothing(const Vec2& p) const { return distanceToRegion(task_.target, p) >= radius_mm_ - on_mm_; }

    Openness openness(const Loop& loop) const {
        std::size_t open = 0;
        for (const Edge& edge : edgesOf(loop))
            open += cutsNothing(pointAt(edge.from, edge.segment, 0.5)) ? 1 : 0;
        if (open == 0) return Openness::Walled;
        return open == loop.segments.size() ? Openness::Open : Openness::Mixed;
    }

    /// Walls come last and open sides first: a ring is cut from outside in if every ring it follows from
    /// belongs to an open side.
    void markOutsideIn(std::vector<Ring>& rings) const {
        if (std::none_of(rings.begin(), rings.end(), [](const Ring& ring) { return ring.open; })) return;
        const bool all_open = std::all_of(rings.begin(), rings.end(),
                                          [](const Ring& ring) { return ring.level > 0 || ring.open; });
        for (std::size_t i = 0; i < rings.size(); ++i) {
            Ring& ring = rings[i];
            ring.outside_in = ring.level == 0 ? ring.open : true;
            if (all_open) continue;
            for (std::size_t j = 0; j < i; ++j)
                if (rings[j].level == ring.level - 1 && !rings[j].outside_in &&
                    adjacent(rings[j].loop, ring.loop))
                    ring.outside_in = false;
        }
    }

    /// Curves at r, r + step-over, ... from the walls, inside the component: where walls and open sides
    /// share a boundary these cut from the open side towards the wall, one step-over at a time.
    void addWallCurves(const Region& component, int index) {
        const ClearanceDiagram walls(wallsAround(component), tol_);
        for (int level = 0;; ++level) {
            const Region grown = walls.offset(radius_mm_ + tol_.guard_mm + level * step_over_mm_);
            const bool reached = std::any_of(grown.loops.begin(), grown.loops.end(), [&](const Loop& loop) {
                const std::vector<Edge> edges = edgesOf(loop);
                return std::any_of(edges.begin(), edges.end(), [&](const Edge& edge) {
                    return isIn(component, pointAt(edge.from, edge.segment, 0.5)) ||
                           anyNearer(edgesOf(component), edge, tol_.linear_mm);
                });
            });
            if (!reached) return;
            for (const Loop& loop : grown.loops)
                clip(reversed(loop), {{}, level, false, false}, index, &component);
        }
    }

    /// The obstruction without the holes that do not concern this component.
    Region wallsAround(const Region& component) const {
        const Box2 box = boundingBox(component).grown(2 * radius_mm_);
        Region walls;
        for (const Loop& loop : task_.obstruction.loops)
            if (signedArea(loop) > 0 || boundingBox(loop).overlaps(box)) walls.loops.push_back(loop);
        return walls;
    }

    /// Boundary of a limited task inside the free centres: neither wall nor cleared ground, so no other
    /// pass makes sure that what lies beside it gets cut.
    void addLimits(const Region& component, int index) {
        const std::vector<Edge> boundary = edgesOf(component);
        const auto needed = [&](const Vec2& p) {
            return contains(component, p) && distanceToBoundary(component, p) > on_mm_ && !isCleared(p) &&
                   !cutsNothing(p);
        };
        std::vector<Edge> cutters = cleared_edges_;
        cutters.insert(cutters.end(), boundary.begin(), boundary.end());
        for (const Loop& loop : task_.centres.loops)
            keep(loop, cutters, needed, {{}, 0, false, false}, index);
    }

    void clip(const Loop& loop, const Ring& ring, int index, const Region* component) {
        std::vector<Edge> cutters = cleared_edges_;
        cutters.insert(cutters.end(), centre_edges_.begin(), centre_edges_.end());
        if (component) {
            const std::vector<Edge> boundary = edgesOf(*component);
            cutters.insert(cutters.end(), boundary.begin(), boundary.end());
        }
        const auto needed = [&](const Vec2& p) {
            if (component && !isIn(*component, p)) return false;
            if (ring.level == 0 && cutsNothing(p)) return false;
            return !isCleared(p) && (!limited_ || isIn(task_.centres, p));
        };
        keep(loop, cutters, needed, ring, index);
    }

    bool isIn(const Region& region, const Vec2& p) const {
        return contains(region, p) || distanceToBoundary(region, p) < on_mm_;
    }
    bool isCleared(const Vec2& p) const {
        return !task_.cleared_centres.empty() && isIn(task_.cleared_centres, p);
    }

    /// Cuts the loop at the cutters and makes passes of the pieces whose middle is needed.
    template <typename Needed>
    void keep(const Loop& loop, const std::vector<Edge>& cutters, Needed needed, const Ring& ring,
              int index) {
        std::vector<Path> pieces;
        bool whole = true;
        bool last_kept = false;
        for (const Edge& edge : edgesOf(loop)) {
            std::vector<double> shares{0, 1};
            for (const Edge& cutter : cutters)
                for (const Vec2& p : meetingPoints(edge, cutter))
                    shares.push_back(shareOf(edge, p));
            std::sort(shares.begin(), shares.end());
            for (std::size_t i = 1; i < shares.size(); ++i) {
                const std::optional<Edge> part = cutOut(edge, shares[i - 1], shares[i]);
                if (!part) continue;
                const bool kept = needed(pointAt(part->from, part->segment, 0.5));
                whole = whole && kept;
                if (kept && !last_kept) pieces.push_back({part->from, {}});
                if (kept) pieces.back().segments.push_back(part->segment);
                last_kept = kept;
            }
        }
        if (whole && !pieces.empty()) return addPass(loop, true, ring, index);
        // The loop's start is only a name: join what it has cut in two.
        if (pieces.size() > 1 && last_kept && pieces.front().start == loop.start) {
            Path& last = pieces.back();
            last.segments.insert(last.segments.end(), pieces.front().segments.begin(),
                                 pieces.front().segments.end());
            pieces.erase(pieces.begin());
        }
        for (const Path& piece : pieces)
            if (length(piece) > tol_.sliver_mm) addPass(piece, false, ring, index);
    }

    void addPass(const Path& path, bool closed, const Ring& ring, int index) {
        Pass pass;
        pass.path = path;
        pass.closed = closed;
        pass.component = index;
        pass.level = ring.level;
        pass.starts_in_air = !closed && (isCleared(path.start) || cutsNothing(path.start));
        set_.passes.push_back(std::move(pass));
        outside_in_.push_back(ring.outside_in);
    }

    bool adjacent(const Path& a, const Path& b) const {
        const double reach = kNeighbourSlack * step_over_mm_;
        if (!boundingBox(a).grown(reach).overlaps(boundingBox(b))) return false;
        const std::vector<Edge> edges = edgesOf(a);
        for (const Edge& edge : edgesOf(b))
            if (anyNearer(edges, edge, reach)) return true;
        return false;
    }

    /// Links passes of neighbouring levels and says which of them comes first.
    void orderByLevel(std::size_t first) {
        std::vector<Pass>& passes = set_.passes;
        for (std::size_t i = first; i < passes.size(); ++i)
            for (std::size_t j = first; j < passes.size(); ++j) {
                if (passes[j].level != passes[i].level + 1 || !adjacent(passes[i].path, passes[j].path))
                    continue;
                passes[i].neighbours.push_back(static_cast<int>(j));
                passes[j].neighbours.push_back(static_cast<int>(i));
                if (outside_in_[i])
                    passes[j].after.push_back(static_cast<int>(i));
                else
                    passes[i].after.push_back(static_cast<int>(j));
            }
    }

    const ClearingTask& task_;
    double radius_mm_;
    double step_over_mm_;
    const Tolerances& tol_;
    double on_mm_;
    std::vector<Edge> cleared_edges_;
    std::vector<Edge> centre_edges_;
    /// The task's centres are less than free centres without cleared ones.
    bool limited_ = false;
    PassSet set_;
    std::vector<bool> outside_in_;
};

}  // namespace

PassSet contourParallel(const ClearingTask& task, double radius_mm, double step_over_mm,
                        const Tolerances& tol) {
    return PassMaker(task, radius_mm, step_over_mm, tol).make();
}

}  // namespace stepmill::toolpath
