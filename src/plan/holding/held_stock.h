#pragma once

#include "stepmill/feature/feature.h"
#include "stepmill/plan/stages.h"

namespace stepmill {

/// The stock below a height that a clamping holds, in setup coordinates.
struct HeldStock {
    double top_z_mm = 0;
    double bottom_z_mm = 0;  ///< of the stock
    bool all = false;        ///< through holes alone go into it; else all does that touches no outside

    bool any() const { return top_z_mm > bottom_z_mm; }
};
HeldStock heldStock(const Stage& stage);

/// A setup's features without what would be cut of held stock, which is unplanned with the reason Holding:
/// the volumes of both add up to what they did. Stock that is all held lets through holes alone pass; of
/// other stock only features stop above it that are open to the outside, or lie below such a one.
FeatureSet withHeldStock(FeatureSet found, const HeldStock& held, const Tolerances& tol);

/// The held stock as cutters, shanks and holders keep clear of it: without the features that go into it;
/// empty where none is held.
/// \param found  withHeldStock()
Region heldSection(const LayerStack& layers, const FeatureSet& found, const HeldStock& held,
                   const Tolerances& tol);

}  // namespace stepmill
