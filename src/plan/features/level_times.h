#pragma once

#include <vector>

#include "stepmill/access/access.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// Depths of cut that a tool takes for a height.
double depthsOf(double height_mm, const CuttingData& cutting);

/// What a depth of cut takes a mill on a planned level, estimated: as where the tool has a path on it, else
/// all over its centres at the step-over and along their boundary [s/mm2].
/// \param area  what the tool can do there
double secondsPerMm2(const PlannedFeature& level, const ToolAssembly& tool, const CuttingData& cutting,
                     const CutterArea& area);

/// How a planned level's time lies over its target: each step's evenly over what of the target it is sent to.
/// What steps sweep beyond, in air, counts for nothing.
class LevelTimes {
  public:
    LevelTimes(const PlannedFeature& level, const Tolerances& tol);

    /// What the steps take for their shares of some ground [s].
    double secondsOver(const Region& ground) const;

  private:
    struct Share {
        Region cut;
        double s_per_mm2 = 0;
    };
    std::vector<Share> shares_;
    const Tolerances& tol_;
};

}  // namespace stepmill
