#pragma once

#include "stepmill/access/access.h"
#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/feature/feature.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// A drill this much narrower than its hole still makes it: the ring it leaves is within any drilled
/// hole's tolerance [mm].
inline constexpr double kDrillUndersizeMm = 0.02;

/// Can this drill make this hole, and if not, why not?
struct DrillCheck {
    bool fits = false;
    std::optional<Exclusion> excluded;  ///< set when the diameter matches and something else does not
};

/// A drill fits a hole of its own diameter (as much as the gouge budget wider, a little narrower) whose
/// depth its flutes and stick-out reach, with shank and holder clear of the obstacles.
DrillCheck drillCheck(const Feature& feature, const ToolAssembly& drill, const Tolerances& tol);

/// Height of the conical point of a 118 degree drill [mm].
double pointLengthMm(const ToolAssembly& drill);

/// How deep the tip goes: to the floor, or through it by the point and a little where nothing is below.
double drillTipZ(const Feature& feature, const ToolAssembly& drill);

/// The same for the largest drill that could make the hole. \pre isHole(feature.feature_class)
double deepestDrillTipZ(const Feature& feature);

/// The drilled hole as the feature's only step.
SequenceStep drillStep(const Feature& feature, const ToolAssembly& drill, const CuttingData& cutting,
                       double retract_z_mm, const Machine& machine);

}  // namespace stepmill
