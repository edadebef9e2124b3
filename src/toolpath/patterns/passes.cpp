// The passes of one depth: curves of a pattern clipped to what is left to cut.

#include "toolpath/patterns/passes.h"

#include <algorithm>

#include "stepmill/planar/path_parts.h"
#include "toolpath/patterns/parallel_lines.h"

namespace stepmill::toolpath {

class PassMaker::Clipper {
  public:
    Clipper(const PassMaker& maker, const RingFamily::Component& component,
            const RingFamily::Variant& variant)
        : maker_(maker),
          task_(maker.task_),
          tol_(maker.tol_),
          component_(component),
          variant_(variant),
          on_mm_(onBoundaryMm(maker.tol_)),
          ring_cutters_(ringCutters()) {}

    std::vector<Pass> make() {
        for (const RingFamily::Ring& line : variant_.lines)
            clip(line);
        if (variant_.pattern == Pattern::Zigzag) join();
        lines_ = passes_.size();
        for (const RingFamily::Ring& ring : variant_.rings)
            clip(ring);
        if (maker_.limited_ && !component_.slot) addLimits();
        order();
        return std::move(passes_);
    }

  private:
    bool isCleared(const Vec2& p) const { return maker_.cleared_.isNear(p, on_mm_); }
    /// Of an edge that nothing crosses. Cleared ground that touches it half-way leaves it towards its ends.
    bool isCleared(const Edge& edge) const {
        return isCleared(pointAt(edge, 0.5)) && isCleared(edge.from) && isCleared(edge.to());
    }
    /// At a point, or all along an edge.
    template <typename Place>
    bool cutsNothing(const Place& place) const {
        return toolpath::cutsNothing(maker_.target_, maker_.family_.radiusMm(), place, tol_);
    }

    bool meetsNothing(const Vec2& p) const { return isCleared(p) || cutsNothing(p); }

    static void append(std::vector<Edge>& edges, const std::vector<Edge>& more) {
        edges.insert(edges.end(), more.begin(), more.end());
    }

    /// Where rings are cut: at what has been cleared, at the limits of the task and, where rings leave the
    /// component, at its boundary.
    EdgeIndex ringCutters() const {
        std::vector<Edge> cutters = maker_.cleared_.boundary().edges();
        append(cutters, maker_.centres_.boundary().edges());
        if (variant_.leaves_component) append(cutters, component_.indexed.boundary().edges());
        return EdgeIndex(std::move(cutters));
    }

    void clip(const RingFamily::Ring& ring) {
        keep(ring, ring_cutters_, [&](const Edge& edge) {
            const Vec2 p = pointAt(edge, 0.5);
            if (variant_.leaves_component && !component_.indexed.isNear(p, on_mm_)) return false;
            if (ring.level == 0 && cutsNothing(edge)) return false;
            return !isCleared(edge) && (!maker_.limited_ || maker_.centres_.isNear(p, on_mm_));
        });
    }

    /// Boundary of a limited task inside the free centres: neither wall nor cleared ground, so no other
    /// pass makes sure that what lies beside it gets cut.
    void addLimits() {
        std::vector<Edge> limits = maker_.cleared_.boundary().edges();
        append(limits, component_.indexed.boundary().edges());
        const EdgeIndex cutters(std::move(limits));
        for (const Loop& loop : task_.centres.loops)
            keep({loop, 0, false}, cutters, [&](const Edge& edge) {
                const Vec2 p = pointAt(edge, 0.5);
                return component_.indexed.contains(p) &&
                       !component_.indexed.boundary().anyNearer(p, on_mm_) && !isCleared(edge) &&
                       !cutsNothing(edge);
            });
    }

    /// A stretch of an edge by shares of its length.
    struct Stretch {
        double from = 0;
        double to = 1;
    };

    /// Cuts the ring at the cutters. Pieces that are needed become passes.
    template <typename Needed>
    void keep(const RingFamily::Ring& ring, const EdgeIndex& cutters, Needed needed) {
        std::vector<Path> pieces;
        bool whole = true;
        bool goes_on = false;
        for (const Edge& edge : edgesOf(ring.path)) {
            const std::vector<Stretch> kept = neededOf(edge, cutters, needed);
            whole = whole && kept.size() == 1 && kept.front().from == 0 && kept.front().to == 1;
            for (const Stretch& stretch : kept) {
                const std::optional<Edge> part = cutOut(edge, stretch.from, stretch.to);
                if (!part) continue;
                if (!goes_on || stretch.from > 0) pieces.push_back({part->from, {}});
                pieces.back().segments.push_back(part->segment);
            }
            goes_on = !kept.empty() && kept.back().to == 1;
        }
        if (whole && !pieces.empty()) return addPass(ring.path, ring.path.closed(), ring);
        // The loop's start is no end of a pass: join the pieces before and after it.
        if (ring.path.closed() && pieces.size() > 1 && goes_on && pieces.front().start == ring.path.start) {
            stepmill::append(pieces.back(), pieces.front());
            pieces.erase(pieces.begin());
        }
        for (const Path& piece : pieces)
            if (length(piece) > tol_.sliver_mm) addPass(piece, false, ring);
    }

    /// The stretches that are needed, each as long as it goes.
    template <typename Needed>
    std::vector<Stretch> neededOf(const Edge& edge, const EdgeIndex& cutters, const Needed& needed) const {
        std::vector<Stretch> kept;
        bool goes_on = false;
        double from = 0;
        for (const double to : sharesOf(edge, cutters)) {
            const std::optional<Edge> part = cutOut(edge, from, to);
            if (!part) continue;
            const bool is_needed = needed(*part);
            if (is_needed && !goes_on) kept.push_back({from, to});
            if (is_needed) kept.back().to = to;
            goes_on = is_needed;
            from = to;
        }
        if (goes_on) kept.back().to = 1;
        return kept;
    }

    /// Where the need may change: where the edge meets cutters, and where these, having run along it nearer
    /// than is told apart, turn off.
    std::vector<double> sharesOf(const Edge& edge, const EdgeIndex& cutters) const {
        std::vector<double> shares = sharesWhereMet(edge, cutters);
        cutters.forEachIn(grown(edge.box, on_mm_), [&](const Edge& cutter) {
            if (distanceTo(cutter.from, edge) < on_mm_) shares.push_back(shareOf(edge, cutter.from));
        });
        std::sort(shares.begin(), shares.end());
        return shares;
    }

    void addPass(const Path& path, bool closed, const RingFamily::Ring& ring) {
        Pass pass;
        pass.path = path;
        pass.closed = closed;
        pass.level = ring.level;
        pass.reversible = !closed && ring.either_way;
        pass.starts_in_air = !closed && meetsNothing(path.start);
        pass.ends_in_air = pass.reversible && meetsNothing(path.end());
        passes_.push_back(std::move(pass));
        outside_in_.push_back(ring.outside_in);
        edges_.emplace_back(path);
    }

    /// Lines as they came from clipping become groups that are cut in one go, from either end.
    void join() {
        std::vector<RingFamily::Ring> pieces;
        for (Pass& pass : passes_)
            pieces.push_back({std::move(pass.path), pass.level, true});
        passes_.clear();
        outside_in_.clear();
        edges_.clear();
        for (const Path& path : joinedLines(component_, variant_, pieces, tol_))
            addPass(path, false, {path, 1, true, true});
    }

    void link(std::size_t first, std::size_t then) {
        passes_[first].neighbours.push_back(static_cast<int>(then));
        passes_[then].neighbours.push_back(static_cast<int>(first));
        passes_[then].after.push_back(static_cast<int>(first));
    }

    bool sideBySide(std::size_t i, std::size_t j) const {
        return adjacent(edges_[i], edges_[j], maker_.family_.stepOverMm());
    }

    /// Links passes of neighbouring levels and says which of them comes first.
    void order() {
        for (std::size_t i = lines_; i < passes_.size(); ++i)
            for (std::size_t j = lines_; j < passes_.size(); ++j) {
                if (passes_[j].level != passes_[i].level + 1 || !sideBySide(i, j)) continue;
                if (outside_in_[i])
                    link(i, j);
                else
                    link(j, i);
            }
        // Rows one after another, walls after all.
        for (std::size_t i = 0; i < lines_; ++i) {
            for (std::size_t j = 0; j < lines_; ++j)
                if (passes_[j].level == passes_[i].level + 1 && sideBySide(i, j)) link(i, j);
            for (std::size_t j = lines_; j < passes_.size(); ++j)
                if (sideBySide(i, j)) link(i, j);
        }
    }

    const PassMaker& maker_;
    const ClearingTask& task_;
    const Tolerances& tol_;
    const RingFamily::Component& component_;
    const RingFamily::Variant& variant_;
    double on_mm_;
    EdgeIndex ring_cutters_;
    std::vector<Pass> passes_;
    std::size_t lines_ = 0;  ///< the first passes are lines: their number
    std::vector<bool> outside_in_;
    std::vector<EdgeIndex> edges_;
};

PassMaker::PassMaker(const ClearingTask& task, const RingFamily& family, const Tolerances& tol)
    : task_(task),
      family_(family),
      tol_(tol),
      target_(task.target),
      cleared_(task.cleared_centres),
      wanted_(boundingBox(task.centres)) {
    const double rest = area(task.free_centres) - area(task.cleared_centres) - area(task.centres);
    limited_ = rest > tol.area_mm2 + tol.sliver_mm * perimeter(task.free_centres);
    if (limited_) centres_ = IndexedRegion(task.centres);
}

bool PassMaker::concerns(const RingFamily::Component& component) const {
    return boundingBox(component.region).intersects(wanted_);
}

std::vector<Pass> PassMaker::make(const RingFamily::Component& component,
                                  const RingFamily::Variant& variant) const {
    return Clipper(*this, component, variant).make();
}

}  // namespace stepmill::toolpath
