#pragma once

#include <vector>

#include "sequence/candidate.h"

namespace stepmill {

/// What stays of a feature after its last tool, by reason.
std::vector<Residual> leftOver(const FeatureGround& ground, const Candidate& last);

/// The whole feature, because no tool can do anything in it: the reason most of the tools that are narrow
/// enough were turned down for, or that none is.
Residual wholeFeature(const FeatureGround& ground, const std::vector<AccessibleArea>& areas,
                      const ToolLibrary& library);

}  // namespace stepmill
