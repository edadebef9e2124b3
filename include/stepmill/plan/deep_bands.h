#pragma once

#include <string>
#include <vector>

#include "stepmill/catalog/tool.h"
#include "stepmill/feature/feature.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// Features deeper than the widest mill reaches, parted into bands of equal depth one below the other, each a
/// feature of its own ("S1.F3.1" and so on) that waits for the one above: a tool then cuts no deeper beside
/// its own work than shank and holder stay above it, and each band takes the tools that reach it. Holes stay
/// whole, for drills. Features keep their order.
std::vector<Feature> inBands(const std::vector<Feature>& features, const ToolLibrary& library,
                             const std::string& material);

/// The options as a plan sequences features with them, whatever they say: no tool meets its own leftovers.
SequenceOptions asPlanned(SequenceOptions options);

}  // namespace stepmill
