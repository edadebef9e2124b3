#pragma once

#include "stepmill/catalog/tool.h"
#include "stepmill/feature/feature.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// A setup's features as roughing sees them: as if the part were thicker by the allowance, sideways by
/// `walls_mm` and upwards by `floors_mm` [roughing.md].
///
/// Targets shrink, obstructions and obstacles grow; all heights but the stock's top rise, so that a feature
/// nested in another takes what that leaves over its mouth. Passages have no floor to leave anything on, and
/// a hole that a drill makes is made to size. What stays is unplanned, with the reason Allowance; the volumes
/// of both add up to what they did. Features that are all allowance are gone, and their children are their
/// parents'.
/// \param drills  a library whose drills make holes
FeatureSet withAllowance(FeatureSet found, const FinishAllowance& leaves, const ToolLibrary& drills,
                         const std::string& material, const Tolerances& tol);

}  // namespace stepmill
