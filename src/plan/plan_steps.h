#pragma once

#include <vector>

#include "stepmill/layers/layer_stack.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// A feature as it can be planned below others that left material standing.
struct ReducedFeature {
    Feature feature;                ///< with an empty target when nothing of it is free
    std::optional<Residual> below;  ///< what of the feature lies below material that stays
};

/// Takes what the features above left out of a feature's target and adds it to what cutter and holder must
/// keep clear of, so that no tool meets material that was believed gone.
/// \param parents    the feature's own parents, planned
/// \param ancestors  all features it waits for, planned
ReducedFeature belowResiduals(const Feature& feature, const std::vector<const PlannedFeature*>& parents,
                              const std::vector<const PlannedFeature*>& ancestors, const Tolerances& tol);

/// Joins operations in their order: each begins with the rapid from where the one before it ended, so that
/// an operation's lengths and times are those of its part of the program.
void linkOperations(std::vector<Operation>& operations, const Machine& machine);

/// Does this operation need another tool than the one before it? The first one does.
bool changesTool(const std::vector<Operation>& operations, std::size_t index);

/// Times of every setup and of the plan; tool changes counted once a visit.
void addUpTotals(Plan& plan);

/// Fills the volume balance from the setups' features and unplanned volumes.
void balanceBooks(Plan& plan, double stock_minus_part_mm3);

/// Where the books of a setup do not close: the slab with the largest difference, in words; empty when
/// every slab's account closes.
std::string largestGap(const LayerStack& layers, const PlannedSetup& setup, const Tolerances& tol);

/// Doubts about the part file and the slicing.
void warnOfInput(Plan& plan, const LayerStack& layers);
/// Residuals, travel, magazine.
void warnOfSetup(Plan& plan, const PlannedSetup& setup);
/// Says so when much of what is to be removed, or of the part's surface, asks for more than 2.5 axes.
/// \pre the books are made up
void warnOfShape(Plan& plan);

}  // namespace stepmill
