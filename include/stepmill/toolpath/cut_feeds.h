#pragma once

#include <array>
#include <vector>

#include "stepmill/toolpath/cut_ground.h"
#include "stepmill/toolpath/cutting_model.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill {

/// What the cuts of an operation ask of spindle and tool.
struct CutSummary {
    double peak_kw = 0;                     ///< of the spindle's motor
    double mean_kw = 0;                     ///< over the feed moves' time
    FeedLimit limit = FeedLimit::ToolFeed;  ///< that rules for most of the time in material
    double deflection_mm = 0;               ///< the greatest
    /// Of the length of the feed moves: in air, then as wide as up to 1/4, 1/2, 3/4 and all of the diameter.
    std::array<double, 5> length_shares{};
};

/// What one move asks of cutter and spindle where it asks most.
struct MoveLoad {
    float width_share = 0;  ///< of the diameter that stands in material; 0: all in air
    float power_kw = 0;     ///< of the spindle's motor
};

/// A path whose moves have feeds by what they cut.
struct FedPath {
    Toolpath path;                ///< its totals are still those of before
    std::vector<MoveLoad> loads;  ///< of its moves
    CutSummary cuts;
};

/// The path with the feed of every level move and slope by the model. A move that cuts wide in one place and
/// narrow in another is parted there, where that saves more than a fifth of a second; all else stays as it
/// is. Widths count in steps of a twentieth of the diameter, rounded up, the step-over as a step of its own.
/// \see docs/algorithms/cutting-model.md
FedPath withCutFeeds(Toolpath path, const CutGround& ground, const CuttingModel& model);

}  // namespace stepmill
