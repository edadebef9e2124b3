#pragma once

#include <optional>
#include <vector>

#include "stepmill/planar/edge.h"

namespace stepmill::toolpath {

/// Moves shorter than this have another direction once their ends are rounded for a program, and are over
/// before a tooth has come round: of them the way just before tells where the cutter goes [mm].
inline constexpr double kShortMoveMm = 0.02;

inline bool isShort(const Edge& edge) {
    return length(edge) < kShortMoveMm;
}

/// The last piece of a way, as far back as kShortMoveMm.
class Trail {
  public:
    void add(const Edge& edge);
    void clear() { points_.clear(); }

    /// Unit direction to a place that the way goes on to, from where it was kShortMoveMm before. Nothing
    /// where it has only begun, or turns back.
    std::optional<Vec2> directionTo(const Vec2& place) const;

  private:
    std::vector<Vec2> points_;
};

}  // namespace stepmill::toolpath
