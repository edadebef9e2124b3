#include "feature/boundary.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/edge_index.h"
#include "stepmill/planar/path_parts.h"

namespace stepmill::feature {
namespace {

/// Walls that turn by less pass as smooth [rad]: a cutter of 10 mm radius leaves 3 um in such a corner.
constexpr double kSharpCornerRad = 0.05;

struct OpenOrClosed {
    Path path;
    bool open = false;
};

/// Cuts one edge where it meets or leaves the obstruction.
class EdgeSorter {
  public:
    EdgeSorter(const Region& obstruction, const Tolerances& tol)
        : obstruction_(obstruction), walls_(obstruction), tol_(tol) {}

    std::vector<OpenOrClosed> sort(const Vec2& from, const Segment& segment) const {
        // Targets are made by cutting stock with shadows, so an edge nearly always lies on a wall as a whole
        // or not at all; three points tell.
        constexpr std::array<double, 3> kProbes{0.1, 0.5, 0.9};
        const auto on_wall = std::count_if(kProbes.begin(), kProbes.end(),
                                           [&](double t) { return onWall(pointAt(from, segment, t)); });
        const Path edge{from, {segment}};
        if (on_wall == 0) return {{edge, true}};
        if (on_wall == static_cast<long>(kProbes.size())) return {{edge, false}};
        return cut(edge);
    }

  private:
    bool onWall(const Vec2& p) const { return walls_.distanceTo(p) <= tol_.sliver_mm; }

    std::vector<OpenOrClosed> cut(const Path& edge) const {
        const SplitPath pieces = split(edge, obstruction_, tol_);
        std::vector<OpenOrClosed> sorted;
        for (const Path& path : pieces.inside)
            sorted.push_back({path, false});
        for (const Path& path : pieces.on)
            sorted.push_back({path, false});
        for (const Path& path : pieces.outside)
            sorted.push_back({path, true});
        const auto along = [&](const Path& path) {
            const std::optional<Arc>& arc = edge.segments.front().arc;
            if (path.start == edge.start) return 0.0;
            return arc ? std::abs(sweepAngle(edge.start, path.start, *arc))
                       : (path.start - edge.start).norm();
        };
        std::stable_sort(sorted.begin(), sorted.end(), [&](const OpenOrClosed& a, const OpenOrClosed& b) {
            return along(a.path) < along(b.path);
        });
        return sorted;
    }

    const Region& obstruction_;
    EdgeIndex walls_;
    Tolerances tol_;
};

void append(std::vector<BoundaryPiece>& pieces, OpenOrClosed part) {
    if (!pieces.empty() && pieces.back().open == part.open) {
        append(pieces.back().path, part.path);
    } else {
        pieces.push_back({std::move(part.path), part.open});
    }
}

std::vector<BoundaryPiece> piecesOf(const Loop& loop, const EdgeSorter& sorter) {
    std::vector<BoundaryPiece> pieces;
    for (const auto& [from, segment] : eachEdge(loop)) {
        for (OpenOrClosed& part : sorter.sort(from, segment))
            append(pieces, std::move(part));
    }
    // The loop's start is no boundary between pieces: the last one runs on into the first.
    if (pieces.size() > 1 && pieces.front().open == pieces.back().open) {
        BoundaryPiece last = std::move(pieces.back());
        pieces.pop_back();
        append(last.path, pieces.front().path);
        pieces.front() = std::move(last);
    }
    return pieces;
}

bool turnsSharplyLeft(const Vec2& before, const Vec2& after) {
    return turnRad(before, after) > kSharpCornerRad;
}

bool hasSharpCorner(const Path& wall) {
    const std::size_t n = wall.segments.size();
    std::vector<Vec2> from{wall.start};
    for (const Segment& segment : wall.segments)
        from.push_back(segment.to);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        if (next == 0 && !wall.closed()) break;
        if (turnsSharplyLeft(tangentAt(from[i], wall.segments[i], 1),
                             tangentAt(from[next], wall.segments[next], 0)))
            return true;
    }
    return false;
}

}  // namespace

std::vector<BoundaryPiece> boundaryPieces(const Region& target, const Region& obstruction,
                                          const Tolerances& tol) {
    const EdgeSorter sorter(obstruction, tol);
    std::vector<BoundaryPiece> all;
    for (const Loop& loop : target.loops)
        for (BoundaryPiece& piece : piecesOf(loop, sorter))
            all.push_back(std::move(piece));
    return all;
}

bool hasSharpCorner(const std::vector<BoundaryPiece>& boundary) {
    return std::any_of(boundary.begin(), boundary.end(),
                       [](const BoundaryPiece& piece) { return !piece.open && hasSharpCorner(piece.path); });
}

std::optional<double> minCornerRadiusMm(const std::vector<BoundaryPiece>& boundary) {
    std::optional<double> smallest;
    for (const BoundaryPiece& piece : boundary) {
        if (piece.open) continue;
        if (hasSharpCorner(piece.path)) return std::nullopt;
        for (const Segment& segment : piece.path.segments) {
            // The target is on the left, so a counter-clockwise arc bulges away from it: an inner corner.
            if (!segment.arc || !segment.arc->ccw) continue;
            smallest = std::min(smallest.value_or(segment.arc->radius_mm), segment.arc->radius_mm);
        }
    }
    return smallest;
}

}  // namespace stepmill::feature
