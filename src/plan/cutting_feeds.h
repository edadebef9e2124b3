#pragma once

#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// What feeds follow from beside the paths.
struct CuttingFeedSettings {
    const PlanRequest& request;
    const ToolLibrary& library;  ///< with the stick-outs that are set
    const Machine& machine;
    const Tolerances& tol;
};

/// The setups with the feeds of their clearing operations by what each move cuts, and with what that asks of
/// spindle and tools. As they are where the request has no material to cut or the machine no spindle. Drills,
/// finishing passes and form cutters keep the library's feeds.
std::vector<PlannedSetup> withCuttingFeeds(std::vector<PlannedSetup> setups,
                                           const CuttingFeedSettings& settings);

}  // namespace stepmill
