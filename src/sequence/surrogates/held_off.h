#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sequence/dag/job.h"

namespace stepmill {

/// What one tool covers, free of collisions.
struct CoveredGround {
    std::string tool_id;
    Region coverable;
};

/// What the tools that their holder keeps off part of a feature may do, whatever is given up.
struct HeldOffTools {
    std::vector<std::optional<CutterArea>> own;  ///< of each tool; nothing where no holder is in the way
    std::vector<Region> held_off;                ///< of each tool: what its cutter alone reaches
    std::vector<CoveredGround> covered;          ///< by all mills, by falling diameter
    Region out_of_reach;                         ///< held off and reached by no tool
};

/// \param reaches  as the cutters and holders have them, before anything was admitted
HeldOffTools heldOffTools(const SequenceJob& job, const std::vector<ToolReach>& reaches);

/// Lets tools whose shank or holder is in the way somewhere take part with all that their cutter reaches, as
/// far as some tool reaches it: what they may do themselves, and the lumps that surrogates must do. A tool
/// for which no other tool can stand in is limited to what it reaches itself.
/// \param held_off  heldOffTools() of these reaches
/// \param given_up  ground that nobody is asked for, though some tool reaches it
std::vector<ToolReach> withSurrogates(const SequenceJob& job, const HeldOffTools& held_off,
                                      const Region& given_up, std::vector<ToolReach> reaches);

}  // namespace stepmill
