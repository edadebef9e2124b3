#pragma once

#include <vector>

#include "stepmill/feature/feature.h"

namespace stepmill {

/// Is the region one full circle, or several equal ones?
bool isFullCircles(const Region& target);

/// Of equal full circles [mm].
double radiusOfCircles(const Region& circles);

/// The axes of a feature that is one hole or a group of equal ones, in the order of its loops.
/// \pre isHole(feature.feature_class)
std::vector<Vec2> holeCentres(const Feature& feature);

/// Radius of each of them [mm]; 0 without a target.
/// \pre isHole(feature.feature_class)
double holeRadiusMm(const Feature& feature);

/// A drill comes out of a through hole by its point and so much more [mm].
inline constexpr double kBreakThroughMm = 0.5;

/// How far at most drills come out of a through hole of that radius [mm]: libraries have none with a point
/// sharper than 90 degrees, which is as long as the radius.
inline double outOfHoleMm(double radius_mm) {
    return radius_mm + kBreakThroughMm;
}

}  // namespace stepmill
