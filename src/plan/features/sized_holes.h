#pragma once

#include <functional>
#include <optional>
#include <string>

#include "plan/features/planning_shop.h"

namespace stepmill {

/// Plans a feature with the tools of a library; nothing for want of time.
using PlanHoles = std::function<std::optional<ToolSequence>(const Feature&, const ToolLibrary&)>;

/// Holes as they are made before they are brought to their fit.
struct SizedSequence {
    /// With its sizing step; nothing where no tool of the library fits.
    std::optional<ToolSequence> sequence;
    std::string trouble;  ///< why there is none
};

/// The cheapest way to bring the holes to their fit: of every tool that can, with each drill that leaves it
/// what it takes, or milled so wide.
/// \param holes    as their stock may be
/// \param library  that they may be made with
SizedSequence sizedSequence(const Feature& holes, const HoleEntry& entry, const PlanningShop& shop,
                            const ToolLibrary& library, double retract_z_mm, const PlanHoles& plan_holes);

}  // namespace stepmill
