#include "toolpath/engagement/trail.h"

namespace stepmill::toolpath {
namespace {

/// Ways whose ends are nearer than this share of their length turn back: their chord tells nothing.
constexpr double kTurnsBackShare = 0.25;

}  // namespace

void Trail::add(const Edge& edge) {
    if (!isShort(edge)) {
        points_ = {pointAt(edge, 1 - kShortMoveMm / length(edge)), edge.to()};
        return;
    }
    if (points_.empty()) points_.push_back(edge.from);
    points_.push_back(edge.to());
    double behind_mm = 0;
    std::size_t first = points_.size() - 1;
    for (; first > 0 && behind_mm < kShortMoveMm; --first)
        behind_mm += (points_[first] - points_[first - 1]).norm();
    points_.erase(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(first));
}

std::optional<Vec2> Trail::directionTo(const Vec2& place) const {
    Vec2 next = place;
    double left_mm = kShortMoveMm;
    for (auto point = points_.rbegin(); point != points_.rend(); ++point) {
        const double step_mm = (next - *point).norm();
        if (step_mm >= left_mm) {
            const Vec2 chord = place - (next + (*point - next) * (left_mm / step_mm));
            const bool turns_back = chord.norm() < kTurnsBackShare * kShortMoveMm;
            return turns_back ? std::nullopt : std::optional<Vec2>(chord.normalized());
        }
        left_mm -= step_mm;
        next = *point;
    }
    return std::nullopt;
}

}  // namespace stepmill::toolpath
