#pragma once

#include <vector>

#include "stepmill/access/access.h"

namespace stepmill {

// What a holder keeps from a cutter, in lumps, and each lump as a small feature of its own
// [tool-dag.md, 'Surrogates']. Each function throws Error(GeometryKernel) where a Boolean or an offset fails,
// and costs a few Booleans of the regions it is given.

/// The pieces of `blocked` without strips narrower than `sliver_mm` and crumbs below `area_mm2`; pieces
/// nearer to each other than `apart_mm` are one lump, since a tool of that size clears none of them without
/// the others. Ordered as components() orders their first pieces.
std::vector<Region> lumpsOf(const Region& blocked, double apart_mm, const Tolerances& tol);

/// `region` in the same way, as one. Empty when it holds no more than that.
Region withoutCrumbs(const Region& region, const Tolerances& tol);

/// What of the region lies within the box.
Region within(const Region& region, const Box2& box, const Tolerances& tol);

/// The obstruction as the tool's cutter alone must see it to keep shank and holder off everything too: a
/// cylinder of radius R stays off an obstacle exactly when a disc of radius r stays off the obstacle grown
/// by R - r.
Region obstructionWithHolder(const FeatureGround& ground, const ToolAssembly& tool);

/// Widest diameter to which shank and holder would have to be turned down so that the cutter loses none of
/// its free centres, in tenths and up to 0.2 mm too small [mm]; the cutter's own at least.
double widestClearHolderMm(const FeatureGround& ground, const ToolAssembly& tool, const CutterArea& area);

/// `lump` as a feature: same heights, everything around it but `obstruction` is cleared ground. What stands
/// farther than `reach_mm` from the lump is left out, as no tool is there below the feature's top, and so are
/// obstacles: `obstruction` is obstructionWithHolder() and what is not yet cleared.
/// \pre reach_mm > diameter of the widest tool that is asked for + 1 mm of its way in over an open edge
Feature lumpFeature(const Feature& feature, const Region& lump, const std::vector<Region>& obstruction,
                    double reach_mm, const Tolerances& tol);

/// toolReach() without its words: what keeps a tool off a lump is told nowhere, and the widest cutter that
/// would fit, which toolReach() names, costs as much as all the rest.
ToolReach reachInLump(const FeatureGround& ground, const ToolAssembly& tool, const std::string& material);

}  // namespace stepmill
