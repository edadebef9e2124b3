#pragma once

#include <vector>

#include "stepmill/layers/face_trace.h"

namespace stepmill {

/// A cone about an upright axis that opens upwards: a hole's countersink, or its broken edge.
struct HoleCone {
    Vec2 centre = Vec2::Zero();
    double bottom_z_mm = 0;
    double top_z_mm = 0;
    double foot_radius_mm = 0;  ///< at its bottom
    double radius_mm = 0;       ///< at its top
    double lean = 0;            ///< sine of its flank's lean from upright
    std::vector<int> faces;     ///< it may lie in halves; ascending

    double slope() const { return (radius_mm - foot_radius_mm) / (top_z_mm - bottom_z_mm); }
};

/// Wider cones, points of drills too, are walls that lean: mills cut them in layers [mm].
inline constexpr double kWidestHoleConeMm = 26;

/// All cones that go all round, no wider than kWidestHoleConeMm, by least face.
std::vector<HoleCone> holeCones(const std::vector<FaceTrace>& traces);

}  // namespace stepmill
