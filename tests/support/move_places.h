#pragma once

#include <algorithm>
#include <cmath>

#include "stepmill/toolpath/toolpath.h"

namespace stepmill::test {

/// Places along a move, both ends among them.
class MovePlaces {
  public:
    /// \param longest_mm  no two neighbours are farther apart
    MovePlaces(const Vec3& from, const Move& move, double longest_mm) : from_(from), move_(move) {
        const Segment flat{move.to.head<2>(), move.arc};
        length_mm_ = std::hypot(length(Vec2(from.head<2>()), flat), move.to.z() - from.z());
        steps_ = std::max(1, static_cast<int>(std::ceil(length_mm_ / longest_mm)));
        // A small circle turns much in one step: the disc must be looked at all round.
        if (!move.arc) return;
        const double turn_rad = length(Vec2(from.head<2>()), flat) / move.arc->radius_mm;
        steps_ *= std::max(1, static_cast<int>(std::ceil(turn_rad / (steps_ * kLongestTurnRad))));
    }

    double lengthMm() const { return length_mm_; }
    double stepMm() const { return length_mm_ / steps_; }
    /// From 0 to this one.
    int last() const { return steps_; }
    Vec3 at(int place) const {
        const double share = static_cast<double>(place) / steps_;
        const Vec2 at = pointAt(from_.head<2>(), Segment{move_.to.head<2>(), move_.arc}, share);
        return {at.x(), at.y(), from_.z() + share * (move_.to.z() - from_.z())};
    }

  private:
    static constexpr double kLongestTurnRad = 0.4;

    const Vec3& from_;
    const Move& move_;
    double length_mm_ = 0;
    int steps_ = 1;
};

}  // namespace stepmill::test
