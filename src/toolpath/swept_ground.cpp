// Exact cover of a way's capsule by discs, by halving squares.

#include "toolpath/swept_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "stepmill/core/units.h"

namespace stepmill::toolpath {

namespace {

/// So many points of a disc's rim are looked at before its ground is proven to be clear ...
constexpr int kLookedAt = 12;
/// ... at this share of the radius: those on the rim itself rounding may put outside.
constexpr double kLookedAtShare = 0.99;

/// A disc that goes along a way.
struct DiscWay {
    const Edge& way;
    double disc_mm;
    double cusp_mm;  ///< what is thinner counts as none

    double innerMm() const { return disc_mm - cusp_mm; }
};

struct Square {
    Vec2 centre;
    double half_mm;
};

/// One question: is all that the disc meets cleared?
class Cover {
  public:
    Cover(const DiscWay& disc, double swept_radius_mm, const IndexedRegion& target,
          const IndexedRegion& cleared)
        : disc_(disc), radius_mm_(swept_radius_mm), target_(target), cleared_(cleared) {}

    bool isWhole(const std::vector<Edge>& swept) {
        const Box2 box = grown(disc_.way.box, disc_.disc_mm);
        // The square is as wide as the box is long.
        const double half_mm = box.sizes().maxCoeff() / 2;
        const Square all{(box.min() + box.max()) / 2, half_mm};
        const Box2 square(all.centre - Vec2(half_mm, half_mm), all.centre + Vec2(half_mm, half_mm));
        Near near;
        for (const Edge& edge : swept)
            if (grown(edge.box, radius_mm_).intersects(box)) edges_.push_back(&edge);
        near.swept = {0, edges_.size()};
        cleared_.boundary().forEachIn(grown(square, radius_mm_),
                                      [&](const Edge& edge) { edges_.push_back(&edge); });
        near.cleared = {near.swept.end, edges_.size()};
        target_.boundary().forEachIn(square, [&](const Edge& edge) { edges_.push_back(&edge); });
        near.target = {near.cleared.end, edges_.size()};
        near.off_cleared = cleared_.boundary().empty();
        return !meetsAtOnce(near) && isClear(all, near);
    }

  private:
    /// Of `edges_`.
    struct Range {
        std::size_t begin = 0;
        std::size_t end = 0;
    };
    /// The edges that matter to a square.
    struct Near {
        Range swept;
        Range cleared;  ///< edges of the cleared centres that, or whose discs, may meet the square
        Range target;   ///< boundary edges that may meet the square
        /// The square is known to lie inside the target or outside the cleared centres: its parent does.
        bool in_target = false;
        bool off_cleared = false;
    };

    /// A quick look for material on a way that is blocked; most of those that are asked for are.
    bool meetsAtOnce(const Near& near) const {
        const double rim_mm = kLookedAtShare * disc_.innerMm();
        for (const double share : {1.0, 0.5, 0.0}) {
            const Vec2 at = pointAt(disc_.way, share);
            if (isMaterial(at, near)) return true;
            for (int i = 0; i < kLookedAt; ++i) {
                const double angle_rad = 2 * kPi * i / kLookedAt;
                const Vec2 on_rim = at + rim_mm * Vec2(std::cos(angle_rad), std::sin(angle_rad));
                if (isMaterial(on_rim, near)) return true;
            }
            if (disc_.way.from == disc_.way.to()) break;
        }
        return false;
    }

    bool isMaterial(const Vec2& p, const Near& near) const {
        const auto covers = [&](std::size_t i) {
            const Edge& edge = *edges_[i];
            return edge.box.squaredExteriorDistance(p) <= radius_mm_ * radius_mm_ &&
                   distanceTo(p, edge) <= radius_mm_;
        };
        for (std::size_t i = near.swept.begin; i < near.cleared.end; ++i)
            if (covers(i)) return false;
        return target_.contains(p) && (near.off_cleared || !cleared_.contains(p));
    }

    /// Squares are halved until each lies beside the way, beside the target or within one disc.
    bool isClear(const Square& square, const Near& near) {
        const std::size_t before = edges_.size();
        const bool clear = isClearBy(square, near);
        edges_.resize(before);
        return clear;
    }

    bool isClearBy(const Square& square, const Near& near) {
        const Vec2& p = square.centre;
        const double reach = square.half_mm * std::numbers::sqrt2;
        const double off_way = distanceTo(p, disc_.way);
        if (off_way - reach >= disc_.innerMm()) return true;
        Near within;
        const double to_swept_mm = toNearest(p, near.swept, reach, within.swept);
        if (to_swept_mm + reach <= radius_mm_) return true;
        const double to_cleared_mm = toNearest(p, near.cleared, reach, within.cleared);
        if (to_cleared_mm + reach <= radius_mm_) return true;
        within.off_cleared = near.off_cleared;
        // A square that no boundary meets lies on one side of it: one question answers for all its parts.
        if (!within.off_cleared && to_cleared_mm > reach) {
            if (cleared_.contains(p)) return true;
            within.off_cleared = true;
        }
        within.target.begin = edges_.size();
        for (std::size_t i = near.target.begin; i < near.target.end; ++i)
            if (distanceTo(p, *edges_[i]) <= reach) edges_.push_back(edges_[i]);
        within.target.end = edges_.size();
        within.in_target = near.in_target;
        if (!within.in_target && within.target.begin == within.target.end) {
            if (!target_.contains(p)) return true;
            within.in_target = true;
        }
        if (off_way < disc_.innerMm() && std::min(to_swept_mm, to_cleared_mm) > radius_mm_ &&
            (within.in_target || target_.contains(p)) && (within.off_cleared || !cleared_.contains(p)))
            return false;
        // Covers that end within half a cusp of the way's rim are no covers.
        if (reach < disc_.cusp_mm / 2) return false;
        const double half_mm = square.half_mm / 2;
        for (const double x : {-half_mm, half_mm})
            for (const double y : {-half_mm, half_mm})
                if (!isClear({p + Vec2(x, y), half_mm}, within)) return false;
        return true;
    }

    /// Distance to the nearest of some edges; those whose discs may meet the square are put behind the
    /// others. It ends with the first edge whose discs cover the square.
    double toNearest(const Vec2& p, const Range& edges, double reach_mm, Range& near) {
        near.begin = edges_.size();
        double least_mm = std::numeric_limits<double>::infinity();
        for (std::size_t i = edges.begin; i < edges.end && least_mm + reach_mm > radius_mm_; ++i) {
            const double distance_mm = distanceTo(p, *edges_[i]);
            least_mm = std::min(least_mm, distance_mm);
            if (distance_mm - reach_mm < radius_mm_) edges_.push_back(edges_[i]);
        }
        near.end = edges_.size();
        return least_mm;
    }

    DiscWay disc_;
    double radius_mm_;  ///< of the discs that have been there
    const IndexedRegion& target_;
    const IndexedRegion& cleared_;
    /// Those of the square that is looked at and of the larger ones around it, one after another: a square's
    /// own go when it is done.
    std::vector<const Edge*> edges_;
};

}  // namespace

SweptGround::SweptGround(const ClearingTask& task, double radius_mm)
    : boundaries_(std::make_shared<const Boundaries>(
          Boundaries{IndexedRegion(task.target), IndexedRegion(task.cleared_centres)})),
      radius_mm_(radius_mm) {}

bool SweptGround::isClear(const Edge& way, double cusp_mm) const {
    return isClear(way, radius_mm_, cusp_mm);
}

bool SweptGround::isClearFor(double disc_mm, const Vec2& a, const Vec2& b) const {
    return isClear(makeLine(a, b), disc_mm, kCuspShare * radius_mm_);
}

bool SweptGround::isClear(const Edge& way, double disc_mm, double cusp_mm) const {
    const IndexedRegion& target = boundaries_->target;
    const bool beside_target = !target.boundary().anyNearer(way, disc_mm);
    if (beside_target && !target.contains(way.from)) return true;
    return Cover({way, disc_mm, cusp_mm}, radius_mm_, target, boundaries_->cleared).isWhole(swept_);
}

}  // namespace stepmill::toolpath
