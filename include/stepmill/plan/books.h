#pragma once

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

/// The books of a plan.
struct PlanBooks {
    std::vector<VolumeBalance> setups;
    VolumeBalance part;
    /// Where the part's books do not close: the setup and slab with the largest difference, with its sign, in
    /// words; empty when they close.
    std::string largest_gap;
};

/// The books of every setup, and of the part from those. Whether a residual of an early setup is still there
/// at the end is asked at points in it, so the part's split by reason is an estimate; the sums are not.
PlanBooks booksOf(const std::vector<SetupAccount>& accounts, double stock_minus_part_mm3,
                  const Tolerances& tol);

}  // namespace stepmill
