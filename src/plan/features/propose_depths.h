#pragma once

#include <string>
#include <vector>

#include "stepmill/plan/common_ground.h"
#include "stepmill/plan/grown_feature.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// What the features are planned with.
struct DepthPlanning {
    const ToolLibrary& library;
    const std::string& material;
    const StockGrowth& growth;
    double change_s = 0;  ///< of a tool: each part may ask for two more
};

/// One deep feature of a nest in parts that might be cut with gain one after another, as grounds in the order
/// in which they are taken out of it: what wide mills reach all the way down, if any, then the rest down to
/// where a stiff mill's holder gets; what is below stays for the longer and slower mills that took all of it
/// before. Of all features and mills that are too short the most gain, by what the features' own steps take
/// and the mill would: an estimate like that of proposeGround().
/// \param nest  planned with its paths, parents before children; ground that it has already is left alone
/// \param ids   as for proposeGround()
/// \return  empty where none is worth a trial
std::vector<CommonGround> proposeDepths(const std::vector<PlannedFeature>& nest, const DepthPlanning& from,
                                        const std::string& ids, const Tolerances& tol);

}  // namespace stepmill
