// The way along the limit of engagement, step by step, then through long arcs.

#include "toolpath/adaptive/engaged_way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"

namespace stepmill::toolpath {
namespace {

/// Length of a step, as a share of the radius.
constexpr double kStepShare = 0.15;
/// A step turns right by no more than this ...
constexpr double kMostRightDeg = 20;
/// ... and left, away from material and walls, by no more than that.
constexpr double kMostLeftDeg = 150;
/// The first other turn that is tried, to the right doubled each time, to the left widened by this ...
constexpr double kTurnDeg = 2;
constexpr double kWider = 1.6;
/// ... until turns are this close, or so many have been tried.
constexpr double kSameTurnRad = 5e-4;
constexpr int kMostHalvings = 14;
/// So little below the share that is aimed at is good enough.
constexpr double kGoodEnough = 0.008;
/// Along a wall, where the rim is far from its limit, the way runs outside by this share of the radius: no
/// chord of the wall leaves anything standing.
constexpr double kOutsideShare = 0.004;
constexpr double kFarFromLimit = 0.7;
/// So often the last step is halved to find where cleared ground begins.
constexpr int kEndHalvings = 16;
/// Arcs lie no farther from the steps than this share of the radius.
constexpr double kFitShare = 0.002;
/// Steps that one pair of arcs spans at most.
constexpr std::size_t kMostSpan = 24;
/// Shorter arcs are none: their ends may fall together [mm].
constexpr double kLeastArcMm = 1e-3;
/// Where the way turns by more it has met a wall: no arc goes through.
constexpr double kCornerDeg = 25;

Vec2 turned(const Vec2& direction, double left_rad) {
    return std::cos(left_rad) * direction + std::sin(left_rad) * leftOf(direction);
}

class Walker {
  public:
    explicit Walker(const EngagedWayTask& task)
        : task_(task), step_mm_(kStepShare * task.radius_mm), at_(task.start), along_(task.along) {
        points_.push_back(at_);
    }

    std::optional<std::vector<Vec2>> walk() {
        bool cut = false;
        const int most = static_cast<int>(std::ceil(task_.longest_mm / step_mm_));
        for (int i = 0; i < most; ++i) {
            if (!step() || !task_.within.contains(at_)) return std::nullopt;
            cut = cut || engaged_ > 0;
            if (cut && task_.meter.cleared().contains(at_)) return wholeWay();
        }
        return std::nullopt;
    }

  private:
    /// What a step in some direction meets.
    struct Look {
        bool wall = false;
        double engaged = 0;  ///< share of the limit
    };

    /// Up to where it comes into cleared ground, its runs along walls a little outside.
    std::vector<Vec2> wholeWay() {
        std::vector<Vec2> way = points_;
        Vec2 outside = points_[points_.size() - 2];
        Vec2 inside = points_.back();
        for (int i = 0; i < kEndHalvings; ++i) {
            const Vec2 middle = (outside + inside) / 2;
            (task_.meter.cleared().contains(middle) ? inside : outside) = middle;
        }
        way.back() = inside;
        for (std::size_t i = 1; i + 1 < way.size(); ++i) {
            if (!along_wall_[i - 1] || !along_wall_[i] || !along_wall_[i + 1]) continue;
            const Vec2 along = (points_[i + 1] - points_[i - 1]).normalized();
            way[i] -= kOutsideShare * task_.radius_mm * leftOf(along);
        }
        return way;
    }

    Look look(double left_rad) const {
        const Vec2 along = turned(along_, left_rad);
        const Vec2 to = at_ + step_mm_ * along;
        if (!task_.room.contains(to)) return {true, std::numeric_limits<double>::infinity()};
        return {false, task_.meter.engagementAt(to, along)};
    }

    bool isFree(const Look& look) const { return look.engaged <= task_.aim; }
    bool isGood(const Look& look) const { return isFree(look) && look.engaged > task_.aim - kGoodEnough; }

    /// Goes as far to the right as nothing hinders: first as it turned last, then between a turn that is
    /// hindered and one that is not.
    bool step() {
        const double most_right = -degToRad(kMostRightDeg);
        double free = std::max(turn_, most_right);
        Look at_free = look(free);
        double hindered = free;
        Look at_hindered = at_free;
        if (isFree(at_free)) {
            for (double by = degToRad(kTurnDeg); isFree(at_hindered) && free > most_right; by *= 2) {
                if (isGood(at_hindered)) return go(hindered, at_hindered, false);
                free = hindered;
                at_free = at_hindered;
                hindered = std::max(free - by, most_right);
                at_hindered = look(hindered);
            }
            if (isFree(at_hindered)) return go(hindered, at_hindered, false);
        } else {
            for (double by = degToRad(kTurnDeg); !isFree(at_free); by *= kWider) {
                hindered = free;
                at_hindered = at_free;
                free += by;
                if (free > degToRad(kMostLeftDeg)) return false;
                at_free = look(free);
            }
        }
        for (int i = 0; i < kMostHalvings && free - hindered > kSameTurnRad && !isGood(at_free); ++i) {
            // Where material hinders the engagement rises evenly, a wall is there or not.
            const double rise = at_hindered.engaged - at_free.engaged;
            const double share =
                at_hindered.wall || !(rise > 0)
                    ? 0.5
                    : std::clamp((task_.aim - kGoodEnough / 2 - at_free.engaged) / rise, 0.1, 0.9);
            const double middle = free + share * (hindered - free);
            const Look found = look(middle);
            (isFree(found) ? free : hindered) = middle;
            (isFree(found) ? at_free : at_hindered) = found;
        }
        return go(free, at_free, at_hindered.wall);
    }

    bool go(double left_rad, const Look& look, bool by_wall) {
        turn_ = left_rad;
        engaged_ = look.engaged;
        along_ = turned(along_, left_rad);
        at_ += step_mm_ * along_;
        points_.push_back(at_);
        along_wall_.push_back(by_wall && engaged_ < kFarFromLimit);
        return true;
    }

    const EngagedWayTask& task_;
    double step_mm_;
    Vec2 at_;
    Vec2 along_;
    double turn_ = 0;     ///< of the last step, to the left [rad]
    double engaged_ = 0;  ///< after it
    std::vector<Vec2> points_;
    std::vector<bool> along_wall_{false};  ///< of each point
};

/// An arc that leaves `from` in a direction and ends at `to`; straight where it hardly bends.
Segment arcTo(const Vec2& from, const Vec2& along, const Vec2& to) {
    const Vec2 chord = to - from;
    const double side = cross(along, chord);
    if (std::abs(side) <= 1e-6 * chord.norm()) return {to, std::nullopt};
    const double radius_mm = chord.squaredNorm() / (2 * side);
    const Vec2 centre = from + radius_mm * leftOf(along);
    return {to, Arc{centre, std::abs(radius_mm), radius_mm > 0}};
}

/// Two arcs with one tangent where they meet, from one point and direction to another: equal lengths of the
/// control polygon. Nothing where the directions do not allow it.
std::optional<std::array<Segment, 2>> biarc(const Vec2& from, const Vec2& along, const Vec2& to,
                                            const Vec2& along_end) {
    const Vec2 v = to - from;
    const Vec2 t = along + along_end;
    const double a = 2 * (1 - along.dot(along_end));
    const double b = 2 * v.dot(t);
    const double c = -v.squaredNorm();
    double d = 0;
    if (a > 1e-9) {
        d = (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
    } else {
        if (b <= 0) return std::nullopt;
        d = -c / b;
    }
    if (!(d > 0)) return std::nullopt;
    const Vec2 middle = snapToGrid(Vec2((from + d * along + to - d * along_end) / 2));
    if (std::min((middle - from).norm(), (to - middle).norm()) < kLeastArcMm) return std::nullopt;
    const Segment first = arcTo(from, along, middle);
    // The second arc, run backwards from its end.
    const Segment back = arcTo(to, Vec2(-along_end), middle);
    Segment second{to, back.arc};
    if (second.arc) second.arc->ccw = !second.arc->ccw;
    return std::array<Segment, 2>{first, second};
}

/// Fits as long arcs as go through the points between two corners.
class Fitter {
  public:
    Fitter(const std::vector<Vec2>& points, double most_off_mm) : points_(points), most_off_mm_(most_off_mm) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2 from = points[i > 0 ? i - 1 : 0];
            const Vec2 to = points[std::min(i + 1, points.size() - 1)];
            tangents_.push_back((to - from).normalized());
        }
    }

    void add(Path& path) const {
        for (std::size_t i = 0; i + 1 < points_.size();) {
            std::size_t span = std::min(kMostSpan, points_.size() - 1 - i);
            while (span > 1 && !fits(i, i + span))
                span = span / 2;
            const auto arcs = between(i, i + span);
            if (arcs)
                path.segments.insert(path.segments.end(), arcs->begin(), arcs->end());
            else
                path.segments.push_back({points_[i + span], std::nullopt});
            i += span;
        }
    }

  private:
    std::optional<std::array<Segment, 2>> between(std::size_t i, std::size_t j) const {
        return biarc(points_[i], tangents_[i], points_[j], tangents_[j]);
    }

    bool fits(std::size_t i, std::size_t j) const {
        const auto arcs = between(i, j);
        if (!arcs) return false;
        const Edge first = makeEdge(points_[i], (*arcs)[0]);
        const Edge second = makeEdge((*arcs)[0].to, (*arcs)[1]);
        for (std::size_t k = i + 1; k < j; ++k)
            if (std::min(distanceTo(points_[k], first), distanceTo(points_[k], second)) > most_off_mm_)
                return false;
        return true;
    }

    const std::vector<Vec2>& points_;
    double most_off_mm_;
    std::vector<Vec2> tangents_;
};

Path fitted(const std::vector<Vec2>& points, double most_off_mm) {
    Path path{points.front(), {}};
    const double corner = std::cos(degToRad(kCornerDeg));
    std::vector<Vec2> run{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
        run.push_back(points[i]);
        const bool last = i + 1 == points.size();
        const bool turns =
            !last &&
            (points[i] - points[i - 1]).normalized().dot((points[i + 1] - points[i]).normalized()) < corner;
        if (!last && !turns) continue;
        Fitter(run, most_off_mm).add(path);
        run = {points[i]};
    }
    return path;
}

}  // namespace

std::optional<Path> engagedWay(const EngagedWayTask& task) {
    std::optional<std::vector<Vec2>> points = Walker(task).walk();
    if (!points) return std::nullopt;
    for (Vec2& point : *points)
        point = snapToGrid(point);
    points->erase(std::unique(points->begin(), points->end()), points->end());
    if (points->size() < 3) return std::nullopt;
    return fitted(*points, kFitShare * task.radius_mm);
}

}  // namespace stepmill::toolpath
