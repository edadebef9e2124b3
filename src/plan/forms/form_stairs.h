#pragma once

#include <vector>

#include "plan/forms/form_site.h"
#include "stepmill/layers/section_cutter.h"

namespace stepmill {

/// What stands of one layer's stairs, and where the layer ends below.
struct LayerStairs {
    double foot_mm = 0;
    std::vector<Obstacle> stairs;  ///< from below; never empty
};

/// The stairs that flat layers leave over walls that look up and lean, less what the operations of all setups
/// take, layer by layer from below. A stair stands at every height of its band: where other setups cut the
/// stock at a slant or across, bands are halved until that is nearly all that stands there, so the stairs are
/// no more than there is, and less by no more than a tenth of a millimetre of height or a fiftieth of them.
/// \throws Error(TimedOut) soon after the deadline
std::vector<LayerStairs> stairsOf(const FormSources& sources, const SectionCutter& part,
                                  const Tolerances& tol, const Deadline& deadline);

/// A setup for form cutters alone pays where they take this share of all that is to be removed.
inline constexpr double kPaysForASetupShare = 2e-3;

/// What stairs a setup that sees these layers may have at most [mm3].
double mostStairsMm3(const LayerStack& layers);

}  // namespace stepmill
