#include "stepmill/planar/disc_sweep.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"

namespace stepmill {
namespace {

/// Corners that turn less than this are none: the gap beside them is some nanometres wide [rad].
constexpr double kStraightRad = 1e-6;
/// On the inside of lines that turn no more than this the sides end where they meet [rad].
constexpr double kMeetingRad = 0.5;
/// ... where that takes no more than this share of either line: its other end may ask for as much.
constexpr double kMeetingShare = 0.5;
/// Arcs are cut into pieces no longer than this, so that none meets itself.
constexpr double kLongestSweepRad = kPi / 2;
/// Ends of neighbours are the same but for rounding.
constexpr double kSamePlaceMm = 2 * kGridMm;

/// A way may turn by so much more than once round its disc's rim over the same length; where it turns on, it
/// is parted. A curve that winds round the same ground again and again crosses itself far more often than
/// what it winds round has corners.
constexpr double kMostTurnRad = 2 * kPi;

/// Counter-clockwise; back where it came from is to the left both ways, so that it winds round once more.
double turn(const Vec2& before, const Vec2& after) {
    const double rad = turnRad(before, after);
    return std::abs(rad) > kPi - kStraightRad ? kPi : rad;
}

/// Draws the closed curve along some edges of a way.
class Ribbon {
  public:
    /// \pre none of the edges is without length
    Ribbon(std::vector<Edge> edges, double radius_mm) : edges_(std::move(edges)), radius_mm_(radius_mm) {}

    Loop draw() {
        loop_.start = beside(edges_.front().from, rightAt(edges_.front(), 0));
        at_ = loop_.start;
        drawSide();
        reverse();
        drawSide();
        loop_.segments.back().to = loop_.start;  // but for rounding it is there
        return std::move(loop_);
    }

  private:
    /// The side on the right, and round the end.
    void drawSide() {
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const bool last = i + 1 == edges_.size();
            if (!last && meet(edges_[i], edges_[i + 1])) continue;
            drawAlong(edges_[i]);
            const Vec2 before = tangentAt(edges_[i], 1);
            drawAround(edges_[i].to(), before, last ? kPi : turn(before, tangentAt(edges_[i + 1], 0)));
        }
    }

    void reverse() {
        std::reverse(edges_.begin(), edges_.end());
        for (Edge& edge : edges_)
            edge = edgesOf(reversed({edge.from, {edge.segment}})).front();
    }

    /// Ends a line's side where the next one's begins, on the inside of a corner. False elsewhere.
    bool meet(const Edge& a, const Edge& b) {
        if (a.segment.arc || b.segment.arc) return false;
        const Vec2 before = tangentAt(a, 1);
        const double rad = turn(before, tangentAt(b, 0));
        if (rad > -kStraightRad || rad < -kMeetingRad) return false;
        const double taken_mm = radius_mm_ * std::tan(-rad / 2);
        if (taken_mm > kMeetingShare * std::min(length(a), length(b))) return false;
        goTo(beside(a.to(), -leftOf(before) - taken_mm / radius_mm_ * before));
        return true;
    }

    void drawAlong(const Edge& edge) {
        if (!edge.segment.arc) return goTo(beside(edge.to(), rightAt(edge, 1)));
        const Arc& arc = *edge.segment.arc;
        const double distance_mm = arc.radius_mm + (arc.ccw ? radius_mm_ : -radius_mm_);
        goAround(arc.centre, distance_mm, edge.from - arc.centre, sweepAngle(edge.from, edge.to(), arc));
    }

    void drawAround(const Vec2& corner, const Vec2& before, double rad) {
        if (std::abs(rad) > kStraightRad) goAround(corner, radius_mm_, -leftOf(before), rad);
    }

    /// \param distance_mm  from the centre in the direction of `out`; below 0 against it
    void goAround(const Vec2& centre, double distance_mm, const Vec2& out, double sweep_rad) {
        const double first_rad = std::atan2(out.y(), out.x());
        const Arc arc{centre, std::abs(distance_mm), sweep_rad > 0};
        const auto at = [&](double rad) {
            return snapToGrid(Vec2(arc.centre + distance_mm * Vec2(std::cos(rad), std::sin(rad))));
        };
        if ((at(first_rad) - at_).norm() > kSamePlaceMm) goTo(at(first_rad));
        if (arc.radius_mm <= kGridMm) return;
        const double parts = std::ceil(std::abs(sweep_rad) / kLongestSweepRad - kStraightRad);
        for (double part = 1; part <= parts; ++part) {
            const Vec2 to = at(first_rad + sweep_rad * part / parts);
            if (to != at_) loop_.segments.push_back({to, arc});
            at_ = to;
        }
    }

    static Vec2 rightAt(const Edge& edge, double share) { return -leftOf(tangentAt(edge, share)); }

    Vec2 beside(const Vec2& p, const Vec2& away) const { return snapToGrid(Vec2(p + radius_mm_ * away)); }

    void goTo(const Vec2& to) {
        if (to != at_) loop_.segments.push_back({to, std::nullopt});
        at_ = to;
    }

    std::vector<Edge> edges_;
    double radius_mm_;
    Loop loop_;
    Vec2 at_ = Vec2::Zero();
};

/// The edges in stretches that do not wind round the same ground again and again.
std::vector<std::vector<Edge>> stretchesOf(const Path& way, double radius_mm) {
    std::vector<std::vector<Edge>> stretches;
    double turned_rad = 0;  // more than round a rim as long
    for (const Edge& edge : edgesOf(way)) {
        if (length(edge) <= kSamePlaceMm) continue;
        if (!stretches.empty())
            turned_rad += std::abs(turn(tangentAt(stretches.back().back(), 1), tangentAt(edge, 0)));
        if (stretches.empty() || turned_rad > kMostTurnRad) {
            stretches.emplace_back();
            turned_rad = 0;
        }
        if (edge.segment.arc) turned_rad += std::abs(sweepAngle(edge.from, edge.to(), *edge.segment.arc));
        turned_rad = std::max(0.0, turned_rad - length(edge) / radius_mm);
        stretches.back().push_back(edge);
    }
    return stretches;
}

}  // namespace

Region discSweep(const Path& way, double radius_mm, const Tolerances& tol) {
    std::vector<Region> swept;
    for (std::vector<Edge>& stretch : stretchesOf(way, radius_mm))
        swept.push_back(encircled(Ribbon(std::move(stretch), radius_mm).draw(), tol));
    if (swept.empty()) return makeCircle(snapToGrid(way.start), snapToGrid(radius_mm));
    return swept.size() == 1 ? std::move(swept.front()) : unite(swept, tol);
}

}  // namespace stepmill
