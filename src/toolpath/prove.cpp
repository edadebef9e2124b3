// The moves against what must stay, whatever they were made by.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "stepmill/planar/edge_index.h"
#include "stepmill/planar/indexed_region.h"
#include "stepmill/toolpath/toolpath.h"
#include "toolpath/emit.h"
#include "toolpath/swept_ground.h"

namespace stepmill {

namespace {

/// A disc that cuts into material by less than this many guards only touches it.
constexpr double kSlackGuards = 8;

class Prover {
  public:
    Prover(const ClearingTask& task, double radius_mm, const Tolerances& tol)
        : task_(task), radius_mm_(radius_mm), tol_(tol), walls_(task.obstruction), skirt_(task.skirt) {}

    PathProof run(const Toolpath& path) {
        PathProof proof;
        proof.least_clearance_mm = std::numeric_limits<double>::infinity();
        Vec3 from = path.start;
        for (const Move& move : path.moves) {
            if (move.kind == MoveKind::Rapid) {
                proof.rapids_clear = proof.rapids_clear && rapidIsClear(from, move);
                outside_ = outside_ && from.head<2>() == move.to.head<2>();
            } else {
                cut_.push_back({edgeOf(from, move), std::max(from.z(), move.to.z())});
            }
            const bool crosses = move.kind == MoveKind::Rapid && from.head<2>() != move.to.head<2>();
            if (std::min(from.z(), move.to.z()) < (crosses ? task_.retract_z_mm : task_.top_z_mm))
                proof.least_clearance_mm = std::min(proof.least_clearance_mm, clearance(from, move));
            from = move.to;
        }
        return proof;
    }

  private:
    struct Level {
        Edge edge;
        double top_z_mm;  ///< the higher of its ends
    };

    /// Beyond this distance clearances are all alike; keeps the search local.
    double farMm() const { return 4 * radius_mm_; }

    double clearance(const Vec3& from, const Move& move) {
        const Edge edge = edgeOf(from, move);
        const bool first_time =
            known_
                .insert({edge.from.x(), edge.from.y(), edge.segment.to.x(), edge.segment.to.y(),
                         move.arc ? move.arc->centre.x() : 0, move.arc ? move.arc->centre.y() : 0,
                         move.arc ? (move.arc->ccw ? 1 : -1) * move.arc->radius_mm : 0})
                .second;
        if (!first_time) return std::numeric_limits<double>::infinity();
        // The circle the controller follows runs through the end points; rounding of centre and radius
        // may differ from it by as much.
        double off_circle = 0;
        if (move.arc)
            for (const Vec2& end : {edge.from, edge.segment.to})
                off_circle =
                    std::max(off_circle, std::abs((end - move.arc->centre).norm() - move.arc->radius_mm));
        const double distance = walls_.distanceTo(edge, farMm());
        // A move that starts outside and meets no wall stays outside.
        if (!outside_ || distance == 0) {
            const double inside = insideDepth(edge.segment.to);
            outside_ = inside == 0;
            if (!outside_) return -inside - radius_mm_;
        }
        return distance - off_circle - radius_mm_;
    }

    /// How deep a point lies in the obstruction; 0 outside.
    double insideDepth(const Vec2& p) const {
        return contains(task_.obstruction, p) ? distanceToBoundary(task_.obstruction, p) : 0;
    }

    bool rapidIsClear(const Vec3& from, const Move& move) const {
        const double low = std::min(from.z(), move.to.z());
        if (low >= task_.retract_z_mm) return true;
        const Vec2 at = from.head<2>();
        const Vec2 to = move.to.head<2>();
        const bool beside = low < task_.stands_to_mm && move.to.z() <= from.z();
        if (beside && meetsSkirt(at, to)) return false;
        if (at != to) {
            // Material higher than the top belongs to the obstruction, which clearance() looks at.
            if (move.arc || from.z() != move.to.z()) return false;
            return low >= task_.top_z_mm || isClear(at, to, low);
        }
        if (move.to.z() > from.z()) return true;  // up the way it came
        if (low >= task_.top_z_mm) return true;
        const double slack = kSlackGuards * tol_.guard_mm;
        if (distanceToRegion(task_.target, at) >= radius_mm_ - slack) return true;
        if (!task_.cleared_centres.empty() && distanceToRegion(task_.cleared_centres, at) <= slack)
            return true;
        const bool on_cut = std::any_of(cut_.begin(), cut_.end(), [&](const Level& level) {
            return level.top_z_mm <= low && distanceTo(at, level.edge) <= 2 * kGridMm;
        });
        return on_cut || isClear(at, at, low);
    }

    /// Does a level or falling rapid enter what the stock may have too much of beside what must stay?
    bool meetsSkirt(const Vec2& a, const Vec2& b) const {
        return skirt_.isNear(makeLine(a, b), radius_mm_ - kSlackGuards * tol_.guard_mm);
    }

    /// Has everything under a straight way been cut down to z by the moves before?
    bool isClear(const Vec2& a, const Vec2& b, double z) const {
        toolpath::SweptGround ground(task_, radius_mm_);
        for (const Level& level : cut_)
            if (level.top_z_mm <= z) ground.add(level.edge);
        return ground.isClear(a, b);
    }

    const ClearingTask& task_;
    double radius_mm_;
    const Tolerances& tol_;
    EdgeIndex walls_;
    IndexedRegion skirt_;
    bool outside_ = false;  ///< where the cutter is, is known to be outside the obstruction
    std::vector<Level> cut_;
    std::set<std::array<double, 7>> known_;
};

}  // namespace

PathProof prove(const Toolpath& path, const ClearingTask& task, double tool_radius_mm,
                const Tolerances& tol) {
    return Prover(task, tool_radius_mm, tol).run(path);
}

}  // namespace stepmill
