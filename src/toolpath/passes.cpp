// The passes of one layer: rings clipped to what is left to cut.

#include "toolpath/passes.h"

#include <algorithm>

#include "toolpath/curve.h"
#include "toolpath/ring_family.h"

namespace stepmill::toolpath {

namespace {

class PassMaker {
  public:
    PassMaker(const ClearingTask& task, const RingFamily& family, const Tolerances& tol)
        : task_(task),
          family_(family),
          tol_(tol),
          on_mm_(onBoundaryMm(tol)),
          cleared_edges_(edgesOf(task.cleared_centres)) {
        const double rest = area(task.free_centres) - area(task.cleared_centres) - area(task.centres);
        limited_ = rest > tol.area_mm2 + tol.sliver_mm * perimeter(task.free_centres);
        if (limited_) centre_edges_ = edgesOf(task.centres);
    }

    PassSet make() {
        const Box2 wanted = boundingBox(task_.centres);
        for (const RingFamily::Component& component : family_.components()) {
            set_.components.push_back(component.region);
            if (!boundingBox(component.region).overlaps(wanted)) continue;
            const std::size_t first = set_.passes.size();
            for (const RingFamily::Ring& ring : component.rings)
                clip(ring, component);
            if (limited_) addLimits(component);
            orderByLevel(first);
        }
        return std::move(set_);
    }

  private:
    bool isIn(const Region& region, const Vec2& p) const {
        return contains(region, p) || distanceToBoundary(region, p) < on_mm_;
    }
    bool isCleared(const Vec2& p) const {
        return !task_.cleared_centres.empty() && isIn(task_.cleared_centres, p);
    }
    bool cutsNothing(const Vec2& p) const {
        return toolpath::cutsNothing(task_.target, family_.radiusMm(), p, tol_);
    }

    void clip(const RingFamily::Ring& ring, const RingFamily::Component& component) {
        std::vector<Edge> cutters = cleared_edges_;
        cutters.insert(cutters.end(), centre_edges_.begin(), centre_edges_.end());
        if (component.follows_walls)
            cutters.insert(cutters.end(), component.boundary.begin(), component.boundary.end());
        keep(ring, cutters, [&](const Vec2& p) {
            if (component.follows_walls && !isIn(component.region, p)) return false;
            if (ring.level == 0 && cutsNothing(p)) return false;
            return !isCleared(p) && (!limited_ || isIn(task_.centres, p));
        });
    }

    /// Boundary of a limited task inside the free centres: neither wall nor cleared ground, so no other
    /// pass makes sure that what lies beside it gets cut.
    void addLimits(const RingFamily::Component& component) {
        std::vector<Edge> cutters = cleared_edges_;
        cutters.insert(cutters.end(), component.boundary.begin(), component.boundary.end());
        for (const Loop& loop : task_.centres.loops)
            keep({loop, 0, false}, cutters, [&](const Vec2& p) {
                return contains(component.region, p) && distanceToBoundary(component.region, p) > on_mm_ &&
                       !isCleared(p) && !cutsNothing(p);
            });
    }

    /// Cuts the ring at the cutters and makes passes of the pieces whose middle is needed.
    template <typename Needed>
    void keep(const RingFamily::Ring& ring, const std::vector<Edge>& cutters, Needed needed) {
        std::vector<Path> pieces;
        bool whole = true;
        bool last_kept = false;
        for (const Edge& edge : edgesOf(ring.loop)) {
            const std::vector<double> shares = sharesOf(edge, cutters);
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
        if (whole && !pieces.empty()) return addPass(ring.loop, true, ring);
        // The loop's start is only a name: join what it has cut in two.
        if (pieces.size() > 1 && last_kept && pieces.front().start == ring.loop.start) {
            Path& last = pieces.back();
            last.segments.insert(last.segments.end(), pieces.front().segments.begin(),
                                 pieces.front().segments.end());
            pieces.erase(pieces.begin());
        }
        for (const Path& piece : pieces)
            if (length(piece) > tol_.sliver_mm) addPass(piece, false, ring);
    }

    static std::vector<double> sharesOf(const Edge& edge, const std::vector<Edge>& cutters) {
        std::vector<double> shares{0, 1};
        for (const Edge& cutter : cutters)
            for (const Vec2& p : meetingPoints(edge, cutter))
                shares.push_back(shareOf(edge, p));
        std::sort(shares.begin(), shares.end());
        return shares;
    }

    void addPass(const Path& path, bool closed, const RingFamily::Ring& ring) {
        Pass pass;
        pass.path = path;
        pass.closed = closed;
        pass.component = static_cast<int>(set_.components.size()) - 1;
        pass.level = ring.level;
        pass.starts_in_air = !closed && (isCleared(path.start) || cutsNothing(path.start));
        set_.passes.push_back(std::move(pass));
        outside_in_.push_back(ring.outside_in);
        edges_.push_back(edgesOf(path));
    }

    /// Links passes of neighbouring levels and says which of them comes first.
    void orderByLevel(std::size_t first) {
        std::vector<Pass>& passes = set_.passes;
        for (std::size_t i = first; i < passes.size(); ++i)
            for (std::size_t j = first; j < passes.size(); ++j) {
                if (passes[j].level != passes[i].level + 1) continue;
                if (!adjacent(edges_[i], edges_[j], family_.stepOverMm())) continue;
                passes[i].neighbours.push_back(static_cast<int>(j));
                passes[j].neighbours.push_back(static_cast<int>(i));
                if (outside_in_[i])
                    passes[j].after.push_back(static_cast<int>(i));
                else
                    passes[i].after.push_back(static_cast<int>(j));
            }
    }

    const ClearingTask& task_;
    const RingFamily& family_;
    const Tolerances& tol_;
    double on_mm_;
    std::vector<Edge> cleared_edges_;
    std::vector<Edge> centre_edges_;
    /// The task's centres are less than free centres without cleared ones.
    bool limited_ = false;
    PassSet set_;
    std::vector<bool> outside_in_;
    std::vector<std::vector<Edge>> edges_;
};

}  // namespace

PassSet contourParallel(const ClearingTask& task, const RingFamily& family, const Tolerances& tol) {
    return PassMaker(task, family, tol).make();
}

}  // namespace stepmill::toolpath
