#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sequence/surrogates.h"

namespace stepmill {

/// A tool that can work in lumps.
struct Helper {
    const ToolAssembly* tool = nullptr;
    const AccessibleArea* reach = nullptr;  ///< A'_x in the whole feature
};

/// What is the same for all lumps of a feature.
struct LumpSettings {
    const FeatureGround& ground;
    const ToolLibrary& library;
    const SequenceOptions& options;
    const Machine& machine;
    double retract_z_mm = 0;
    std::vector<Helper> helpers;  ///< by falling diameter
    /// obstructionWithHolder() of a helper.
    std::function<const Region&(int helper)> obstruction;
};

/// Finds the ways to clear a lump: every tool that reaches all of it and, as the options allow, the cheapest
/// sequence of tools; where no tool reaches all, two or three that do together.
/// \param standing  what around the lump is not cleared when its turn comes
std::shared_ptr<const SolvedLump> solveLump(const LumpSettings& settings, const Region& lump,
                                            const std::vector<Region>& standing,
                                            const std::string& held_off_id);

}  // namespace stepmill
