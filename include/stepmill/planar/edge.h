#pragma once

#include <optional>
#include <span>
#include <vector>

#include "stepmill/planar/box.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// One line or arc with its start, and the box around it: an edge that can be asked on its own.
/// An arc that ends where it starts is a full circle.
struct Edge {
    Vec2 from;
    Segment segment;
    Box2 box;

    const Vec2& to() const { return segment.to; }
};

// Construction -------------------------------------------------------------------------------------------

Edge makeEdge(const Vec2& from, const Segment& segment);
/// The straight edge between two points.
Edge makeLine(const Vec2& from, const Vec2& to);
/// The edges of a path in its direction; of a region loop by loop, the region on their left.
std::vector<Edge> edgesOf(const Path& path);
std::vector<Edge> edgesOf(const Region& region);

/// An edge in the path that holds it: no copy, no box.
struct EdgeView {
    const Vec2& from;
    const Segment& segment;
};

/// Edges one after another, for a loop over them; see eachEdge().
class EdgeViews {
  public:
    explicit EdgeViews(std::span<const Path> paths) : paths_(paths) {}

    struct End {};
    class Iterator {
      public:
        explicit Iterator(std::span<const Path> paths) : paths_(paths) { enterPath(); }
        EdgeView operator*() const { return {*from_, *segment_}; }
        Iterator& operator++() {
            from_ = &segment_->to;
            if (++segment_ != last_) return *this;
            paths_ = paths_.subspan(1);
            enterPath();
            return *this;
        }
        bool operator==(End /*end*/) const { return paths_.empty(); }

      private:
        /// Goes to the first edge of the next path that has any.
        void enterPath() {
            while (!paths_.empty() && paths_.front().segments.empty())
                paths_ = paths_.subspan(1);
            if (paths_.empty()) return;
            const Path& path = paths_.front();
            from_ = &path.start;
            segment_ = path.segments.data();
            last_ = segment_ + path.segments.size();
        }

        std::span<const Path> paths_;  ///< the one that the edge is in, and those after it
        const Vec2* from_ = nullptr;
        const Segment* segment_ = nullptr;
        const Segment* last_ = nullptr;  ///< past the path's
    };

    Iterator begin() const { return Iterator(paths_); }
    End end() const { return {}; }

  private:
    std::span<const Path> paths_;
};

/// The edges of a path in its direction, of a region loop by loop:
///
///     for (const auto& [from, segment] : eachEdge(region))
///         sum_mm += length(from, segment);
///
/// Nothing is copied: the path or region must stay as it is meanwhile.
inline EdgeViews eachEdge(const Path& path) {
    return EdgeViews({&path, 1});
}
inline EdgeViews eachEdge(const Region& region) {
    return EdgeViews(region.loops);
}
EdgeViews eachEdge(Path&&) = delete;
EdgeViews eachEdge(Region&&) = delete;

// One edge -----------------------------------------------------------------------------------------------

/// Length of the edge [mm].
inline double length(const Edge& edge) {
    return length(edge.from, edge.segment);
}
/// Point at the share t in [0, 1] of the edge's length.
inline Vec2 pointAt(const Edge& edge, double t) {
    return pointAt(edge.from, edge.segment, t);
}
/// Unit direction of travel at the share t in [0, 1] of the edge's length.
inline Vec2 tangentAt(const Edge& edge, double t) {
    return tangentAt(edge.from, edge.segment, t);
}
/// Distance from p to the edge [mm].
inline double distanceTo(const Vec2& p, const Edge& edge) {
    return distanceTo(p, edge.from, edge.segment);
}
/// The point of the edge nearest to p, not snapped to the grid. From the centre of an arc, to within
/// rounding, all its points are equally far: its nearer end stands for them, the later of two equally near.
Vec2 nearestPoint(const Edge& edge, const Vec2& p);
/// Share in [0, 1] of the edge's length at which p, a point on it, lies.
double shareOf(const Edge& edge, const Vec2& p);
/// The part of an edge between two shares of its length, joints on the 1 nm grid. Nothing where the ends
/// coincide on the grid (for an arc they would mean a full circle).
std::optional<Edge> cutOut(const Edge& edge, double from_share, double to_share);

// Two edges ----------------------------------------------------------------------------------------------

/// Points that lie on both edges, within 1 nm; at most two. Where edges overlap along a length: none, or its
/// ends.
std::vector<Vec2> meetingPoints(const Edge& a, const Edge& b);

/// Least distance between two edges [mm], 0 where they meet; exact but for rounding.
double separation(const Edge& a, const Edge& b);

}  // namespace stepmill
