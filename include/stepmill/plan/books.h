#pragma once

#include <map>
#include <string>
#include <vector>

#include "stepmill/plan/plan.h"
#include "stepmill/plan/stages.h"

namespace stepmill {

/// A setup with its layers and its stock account, for the books.
struct SetupAccount {
    const PlannedSetup* planned = nullptr;
    const LayerStack* layers = nullptr;
    StockStep stock;
    StageAir air;
    std::vector<Prism> removed;  ///< in setup coordinates
};

/// What of a residual is still there on the finished part.
struct StayingResidual {
    double stays_mm3 = 0;
    std::string taken_by;  ///< id of the later setup that takes most of the rest, or names it as its own
};
/// Of the residuals of the accounts' features; those it does not have are gone. Never iterated for output.
using StayingResiduals = std::map<const Residual*, StayingResidual>;

/// The books of a plan.
struct PlanBooks {
    std::vector<VolumeBalance> setups;
    VolumeBalance part;
    /// Together they are the part's residuals, but for the allowance of roughing.
    StayingResiduals staying;
    /// Where the part's books do not close: the setup and slab with the largest difference, with its sign, in
    /// words; empty when they close.
    std::string largest_gap;
};

/// The books of every setup, and of the part from those. Whether a residual of an early setup is still there
/// at the end is asked at points in it, so the part's split by reason is an estimate; the sums are not.
PlanBooks booksOf(const std::vector<SetupAccount>& accounts, double stock_minus_part_mm3,
                  const Tolerances& tol);

/// Does nothing stay at the end but what rounding or the tolerances of volumes may make of nothing, and,
/// after roughing, what was to stay?
bool leavesNothing(const VolumeBalance& part, bool roughing, const Tolerances& tol);

}  // namespace stepmill
