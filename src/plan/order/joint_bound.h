#pragma once

#include <vector>

#include "stepmill/sequence/least_times.h"

namespace stepmill {

/// The least that cutting a setup's features and calling its tools take together [s], however tools are
/// shared: never above the cheapest choice of a path through each feature's DAG with one change for every
/// tool that any of them uses, and mostly near it. Features without tools count nothing.
///
/// The price of each tool's change is parted among the features; with whatever parts, each feature's cheapest
/// path with its parts is a bound, and the parts are sought for which it is highest (Lagrangian relaxation,
/// subgradients by Polyak). Cost: kMostBoundRounds times a cheapest path a feature.
double leastTogetherS(const std::vector<LeastTimes>& features, double tool_change_s);

}  // namespace stepmill
