#pragma once

#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/feature/feature.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// A spot is so wide as a share of the hole, or of the spot drill where that is narrower: it guides the drill
/// and leaves the hole's edge alone.
inline constexpr double kSpotShare = 0.8;

/// Can the spot drill start these holes? Its cone stays over the floor, its whole width clear of what stands
/// over the holes' top.
/// \pre spot.isSpot()
bool spotFits(const Feature& feature, const ToolAssembly& spot);

/// How deep its tip goes.
/// \pre isHole(feature.feature_class)
double spotTipZ(const Feature& feature, const ToolAssembly& spot);

/// How wide the spot drill is where it goes into the hole, its tip at that height [mm].
double spotRadiusMm(const Feature& feature, const ToolAssembly& spot, double tip_z_mm);

/// All holes of the feature spotted.
/// \pre spotFits(feature, spot)
SequenceStep spotStep(const Feature& feature, const ToolAssembly& spot, const CuttingData& cutting,
                      double retract_z_mm, const Machine& machine);

}  // namespace stepmill
