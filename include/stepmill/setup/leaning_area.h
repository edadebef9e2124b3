#pragma once

#include <vector>

#include "stepmill/setup/setup.h"

namespace stepmill {

/// How much of a part leans to its setups.
struct LeaningArea {
    double leaning_mm2 = 0;
    double surface_mm2 = 0;  ///< of all faces
};

/// The part's faces that stand up and lie flat along none of these setups' axes but lean under one of them:
/// what form cutters finish in ridges. Measured on coarse facets, so within some percent; without setups
/// nothing leans. Takes milliseconds.
LeaningArea leaningArea(const Part& part, const std::vector<Setup>& setups);

}  // namespace stepmill
