#pragma once

#include <vector>

#include "stepmill/feature/feature.h"

namespace stepmill::feature {

/// The class of a feature from its target, the pieces of its boundary and whether anything lies below.
FeatureClass classify(const Region& target, const std::vector<BoundaryPiece>& boundary, bool through,
                      const Tolerances& tol);

}  // namespace stepmill::feature
