#pragma once

#include "stepmill/access/access.h"
#include "stepmill/planar/box.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// toolReach() of the tool by these options: with `clear_of_own_material` a tool that would meet what it
/// leaves of the feature is excluded.
ToolReach reachFor(const FeatureGround& ground, const ToolAssembly& tool, const SequenceOptions& options);

/// What rapids to a feature have to pass.
struct Surroundings {
    Region skirt;  ///< [Feature::skirt]
    Region above;  ///< what stands over the feature's top
    double stands_to_mm = 0;
};
Surroundings surroundingsOf(const Feature& feature);
/// What of them lies within the box.
Surroundings within(const Surroundings& around, const Box2& box, const Tolerances& tol);

/// What the task of clearing a feature in one go takes from the feature: target, heights and what is around
/// it. The obstruction is the reach's.
ClearingTask clearingTaskOf(const Feature& feature, const Surroundings& around, const CutterArea& reach,
                            double retract_z_mm);

/// Tells the task what shank and holder keep off, as far in as the tool may be set: set out farther, it only
/// has more room.
void addHolder(const Feature& feature, const ToolAssembly& tool, ClearingTask& clearing);

}  // namespace stepmill
