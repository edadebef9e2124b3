#pragma once

#include <vector>

#include "stepmill/setup/setup.h"

namespace stepmill {

/// Area of the part's faces that stand up and lie flat along none of these setups' axes but lean under one of
/// them [mm2]: what form cutters finish in ridges. Measured on coarse facets, so within some percent; 0 without
/// setups. Takes milliseconds.
double leaningAreaMm2(const Part& part, const std::vector<Setup>& setups);

}  // namespace stepmill
