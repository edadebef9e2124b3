#pragma once

#include <vector>

#include "stepmill/plan/common_ground.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// Ground that nested features might share with gain, by what their own sequences take for it: of every tool
/// and every run of levels, what the tool covers of the lowest one, at so many depths of cut as the whole
/// height takes. The largest gain first, then what more would gain beside it; none goes down past the top of
/// another. An estimate: whether it pays is seen when the features are planned so.
/// \param nest  planned with its paths, parents before children; ground that it has already is left alone
/// \param ids   what the grounds are called: this and a number after those that the nest has
std::vector<CommonGround> proposeGround(const std::vector<PlannedFeature>& nest, const ToolLibrary& library,
                                        const std::string& material, const std::string& ids,
                                        const Tolerances& tol);

}  // namespace stepmill
