#pragma once

#include <vector>

#include "feature/removal_forest.h"
#include "stepmill/feature/feature.h"

namespace stepmill::feature {

/// A cone that a drill's point leaves, or would leave, at the bottom of a hole.
struct DrillPoint {
    Vec2 axis = Vec2::Zero();
    double radius_mm = 0;  ///< at its top
    double top_z_mm = 0;
    double apex_z_mm = 0;
};

/// The cones of the part that are as wide and as steep as drills have them, each once.
std::vector<DrillPoint> drillPoints(const LayerStack& layers);

/// Marks the removal inside such cones: it is the drill's, nobody mills steps into it.
void markDrillPoints(RemovalForest& forest, const LayerStack& layers, const std::vector<DrillPoint>& points);

/// How deep the cone is on the hole's floor; 0 where there is none. Errs to the shallow side.
double pointUnder(const Feature& hole, const std::vector<DrillPoint>& points, const Tolerances& tol);

}  // namespace stepmill::feature
