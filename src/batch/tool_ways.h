#pragma once

#include <vector>

#include "stepmill/batch/magazine.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill::batch {

/// The ways through a feature's tool DAG, as far as its edges were evaluated: the cheapest first, none that
/// takes all tools of a cheaper one, a few dozen at most. Empty where no tool can machine anything.
std::vector<ToolWay> waysThrough(const std::vector<DagEdge>& edges, Objective objective);

}  // namespace stepmill::batch
