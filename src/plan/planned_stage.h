#pragma once

#include <cstddef>
#include <vector>

#include "plan/features/feature_planner.h"
#include "plan/holding/loose_pieces.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/plan/books.h"
#include "stepmill/plan/plan.h"
#include "stepmill/plan/stages.h"

namespace stepmill {

/// A setup that is planned, with what its books ask for.
struct PlannedStage {
    PlannedSetup setup;
    std::size_t place = 0;  ///< of the setup among those that were chosen
    LayerStack layers;
    StageAir air;
    std::vector<Prism> removed;
    StockStep stock;
    Stock left;                     ///< after its feature operations
    std::vector<LoosePiece> loose;  ///< of that
    std::vector<Warning> warnings;
    /// Chosen for what flat layers cut, and these cut nothing new: it stays if form cutters find work in it.
    bool for_forms = false;
};

/// Every setup on the stock that the paths of those before it leave. What setups would cut that there is no
/// time for stays out of reach.
/// \param reserves  what each setup leaves for later ones, by its place
/// \param late      warned of setups there was no time for
std::vector<PlannedStage> planStages(const std::vector<Setup>& setups, const std::vector<CutPrisms>& reserves,
                                     const PlanningShop& shop, const Progress& progress,
                                     std::vector<Warning>& late);

}  // namespace stepmill
