// The way along the limit of engagement, step by step, then through long arcs.

#include "toolpath/adaptive/engaged_way.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"
#include "toolpath/adaptive/tangent_arcs.h"

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

}  // namespace

std::optional<Path> engagedWay(const EngagedWayTask& task) {
    std::optional<std::vector<Vec2>> points = Walker(task).walk();
    if (!points) return std::nullopt;
    for (Vec2& point : *points)
        point = snapToGrid(point);
    points->erase(std::unique(points->begin(), points->end()), points->end());
    if (points->size() < 3) return std::nullopt;
    return tangentArcs(*points, kFitShare * task.radius_mm);
}

}  // namespace stepmill::toolpath
