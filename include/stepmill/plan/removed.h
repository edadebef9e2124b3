#pragma once

#include <vector>

#include "stepmill/plan/plan.h"
#include "stepmill/setup/prism.h"

namespace stepmill {

/// Height of a prism of the residual's area and volume [mm].
double meanHeightMm(const Residual& residual);

/// Does it stand over all of that depth?
bool standsOver(const Residual& residual, double depth_mm);

/// The residual under a floor that the tools do not reach; nothing when they do.
const Residual* belowReach(const PlannedFeature& planned);

/// What the steps of a feature take away: its target less residuals that stand over its whole depth, down to
/// where its tools reach. Residuals over a part of the depth (a drill's point) stand as a layer of the same
/// volume on the floor.
std::vector<Prism> removedBy(const PlannedFeature& planned, const Tolerances& tol);
/// The same of a whole setup.
std::vector<Prism> removedBy(const std::vector<PlannedFeature>& features, const Tolerances& tol);

}  // namespace stepmill
