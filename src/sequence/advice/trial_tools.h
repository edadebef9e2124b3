#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stepmill/access/access.h"
#include "stepmill/catalog/tool.h"

namespace stepmill {

/// A tool the library lacks, to be tried.
struct TrialTool {
    ToolAssembly tool;
    std::string why;
    bool unforeseen = false;  ///< the area model does not tell what it saves: it is tried all the same
};

/// Flat end mills of the diameters that matter to a feature and that no end mill of the library has which
/// gets down to its floor.
std::vector<TrialTool> trialMills(const FeatureGround& ground, const ToolLibrary& library,
                                  const std::string& material);

/// A drill for a hole, through or with a drill's point, that no drill of the library fits.
std::optional<TrialTool> trialDrill(const FeatureGround& ground, const ToolLibrary& library,
                                    const std::string& material);

/// The widest drill of the usual series that makes room in a hole with a flat floor or one wider than any
/// drill, and that the library lacks.
std::optional<TrialTool> trialPreDrill(const FeatureGround& ground, const ToolLibrary& library,
                                       const std::string& material);

/// Tools of the library that reach or holder keep off the feature, with the stick-out that would do.
/// \param reaches  reachFor() of the library's tools, in any order
std::vector<TrialTool> longerTools(const FeatureGround& ground, const ToolLibrary& library,
                                   const std::vector<ToolReach>& reaches);

/// A tool of this type and diameter between its nearest neighbours of the library that stick out at least
/// `reach_mm` and have data for the material: lengths, feeds, speed, price and life interpolated over the
/// diameter; holder of the wider one. Beyond the last of them step-over goes with the diameter,
/// speed against it, and feeds stay, which keeps cutting speed and load a tooth in proportion; step-down
/// shrinks with the diameter but never grows. No farther than by half the diameter again. Nothing without a
/// neighbour.
std::optional<ToolAssembly> interpolatedTool(const ToolLibrary& library, ToolType type, double diameter_mm,
                                             double reach_mm, const std::string& material);

/// The tool pulled farther out of its holder, to the next whole millimetre, with step-down and feeds lessened
/// in proportion, since it bends more: the removal rate falls with the square of the stick-out, about as in
/// libraries' long cutters. Nothing when it sticks out that far already, or when it would stand out more than
/// ten diameters.
std::optional<ToolAssembly> withStickOut(ToolAssembly tool, double stick_out_mm);

}  // namespace stepmill
