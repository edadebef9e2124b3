#pragma once

#include <vector>

#include "sequence/dag/candidate.h"
#include "sequence/holder/holder_limits.h"

namespace stepmill {

/// What stays of a feature after the tools of a sequence, by reason.
/// \pre at least one tool
std::vector<Residual> residualsOf(const FeatureGround& ground, const std::vector<const Candidate*>& used,
                                  const std::optional<Withheld>& withheld);

/// The part of a feature between its floor and the depth its tools reach.
Residual belowReach(const Feature& feature, const Shallower& reached);

/// The whole feature, because no tool can do anything in it: the reason most of the tools that are narrow
/// enough were turned down for, or that none is.
Residual wholeFeature(const FeatureGround& ground, const std::vector<ToolReach>& reaches,
                      const ToolLibrary& library);

}  // namespace stepmill
