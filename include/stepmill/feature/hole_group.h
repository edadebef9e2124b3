#pragma once

#include <vector>

#include "stepmill/feature/feature.h"

namespace stepmill {

/// Is the region one full circle, or several equal ones?
bool isFullCircles(const Region& target);

/// The axes of a feature that is one hole or a group of equal ones, in the order of its loops.
/// \pre isHole(feature.feature_class)
std::vector<Vec2> holeCentres(const Feature& feature);

/// Radius of each of them [mm]; 0 without a target.
/// \pre isHole(feature.feature_class)
double holeRadiusMm(const Feature& feature);

}  // namespace stepmill
