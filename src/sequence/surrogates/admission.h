#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sequence/holder/holder_limits.h"
#include "sequence/surrogates/surrogates.h"

namespace stepmill {

/// How each tool of the library takes part in a feature, and who stands in for those that their holder keeps
/// off some of it.
struct Admission {
    std::vector<ToolReach> reaches;  ///< by falling diameter
    std::shared_ptr<const SurrogateFinder> finder;

    /// Most that a tool covers that takes part, surrogates included.
    double mostCoveredMm2() const;
};

/// Reaches of all tools as cutter and holder have them, by falling diameter. A drill of the hole's own size
/// takes part although the area calculus turns it away.
std::vector<ToolReach> reachesOfAllTools(const SequenceJob& job);

/// Most of the feature's area that one of the tools that can machine something covers.
double mostUsableMm2(const SequenceJob& job, const std::vector<ToolReach>& reaches);

/// Lets tools with surrogates take part, and of those that nobody stands in for what their holder allows.
/// Where some ground of the tools with surrogates is too much for the few tools that may work in a lump, it
/// is given up if the rest is then more than without the tools that have it.
/// \param alone  reachesOfAllTools()
Admission admitTools(const std::shared_ptr<const SequenceJob>& job, const std::vector<ToolReach>& alone);

}  // namespace stepmill
