#pragma once

#include <vector>

#include "stepmill/plan/common_ground.h"
#include "stepmill/plan/grown_feature.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// One deep feature of a nest in parts that might be cut with gain one after another: what wide mills reach
/// all the way down, then the rest down to where a stiff mill's holder gets, then what is below for the
/// longer and slower mills that took all of it before.
struct DepthProposal {
    /// In the order in which they are taken out; the first is missing where no wider mill has a part.
    std::vector<CommonGround> grounds;
    double gain_s = 0;  ///< by what the feature's own steps take and the mill would; an estimate
};

/// What the features are planned with.
struct DepthPlanning {
    const ToolLibrary& library;
    const std::string& material;
    const StockGrowth& growth;
    double change_s = 0;  ///< of a tool: each part may ask for two more
};

/// What every mill that is too short for one of the features might take over from its steps, or from those
/// beside what wider mills clear; the most gain first. An estimate like proposeGround().
/// \param nest  planned with its paths, parents before children; ground that it has already is left alone
/// \param ids   as for proposeGround()
std::vector<DepthProposal> proposeDepths(const std::vector<PlannedFeature>& nest, const DepthPlanning& from,
                                         const std::string& ids, const Tolerances& tol);

}  // namespace stepmill
