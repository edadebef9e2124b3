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

/// Where a hole ends in a point, a drill whose own point ends this share of its radius higher at the rim
/// still makes it: points of 118 and 120 degrees are one.
inline constexpr double kPointFitShare = 0.03;

/// Is the drill as wide as the hole: as much as the gouge budget wider, kDrillUndersizeMm narrower at most?
/// \pre isHole(feature.feature_class)
bool isOfSize(const Feature& feature, const ToolAssembly& drill, const Tolerances& tol);

/// Can this drill make this hole, and if not, why not?
struct DrillCheck {
    bool fits = false;
    std::optional<Exclusion> excluded;  ///< set when the diameter matches and something else does not
};

/// A drill fits a hole of its own diameter (as much as the gouge budget wider, a little narrower) whose
/// depth its flutes and stick-out reach, with shank and holder clear of the obstacles; of a group all holes.
DrillCheck drillCheck(const Feature& feature, const ToolAssembly& drill, const Tolerances& tol);

/// How deep it goes into a hole at most: its flutes, where the library has their length, its stick-out [mm].
double drillReachMm(const ToolAssembly& drill);

/// Height of the drill's conical point [mm].
double pointLengthMm(const ToolAssembly& drill);

/// How deep the tip goes: to the floor; into the point that the part has below it, as far as the drill's own
/// fits in there; or through the floor by the point and a little where nothing is below, kBreakThroughMm if
/// the flutes are long enough.
double drillTipZ(const Feature& feature, const ToolAssembly& drill);

/// The same for the largest drill with the longest point that could make the hole.
/// \pre isHole(feature.feature_class)
double deepestDrillTipZ(const Feature& feature);

/// Down to here the drill takes the whole hole; below it, what its cone takes. The rim that fits of a pointed
/// hole is not counted.
double drilledToZ(const Feature& feature, const ToolAssembly& drill);

/// What the drill's point leaves over the floor of the hole, or of all holes of a group [mm3]; 0 where it
/// goes through or fits the part's own point.
double leftByPointMm3(const Feature& feature, const ToolAssembly& drill);

/// The drilled hole, or group of holes, as the feature's only step.
SequenceStep drillStep(const Feature& feature, const ToolAssembly& drill, const CuttingData& cutting,
                       double retract_z_mm, const Machine& machine);

/// Does the drill make room for a mill that then makes the hole? It is narrower than the hole, or as wide
/// where it does not make the hole itself: the floor is flat, or its flutes too short. Over a floor it stays.
bool preDrills(const Feature& feature, const ToolAssembly& drill, const Tolerances& tol);

/// What such a drill clears for sure, in plan view, down to preDrilledToZ().
CutterArea preDrilledArea(const Feature& feature, const ToolAssembly& drill, const Tolerances& tol);

/// Down to here it clears that: a through hole's end, as far over a floor as its point is long and a little
/// more, or what its flutes reach.
double preDrilledToZ(const Feature& feature, const ToolAssembly& drill);

/// The step that makes room; over a flat floor it leaves something to the mill.
SequenceStep preDrillStep(const Feature& feature, const ToolAssembly& drill, const CuttingData& cutting,
                          double retract_z_mm, const Machine& machine, const Tolerances& tol);

}  // namespace stepmill
