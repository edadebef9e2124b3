#pragma once

#include "stepmill/feature/feature.h"
#include "stepmill/plan/stages.h"

namespace stepmill {

/// The stock below a height that a clamping holds, in setup coordinates.
struct HeldStock {
    double top_z_mm = 0;
    double bottom_z_mm = 0;      ///< of the stock
    bool all = false;            ///< holes alone go into it; else all does that touches no outside
    bool holes_through = false;  ///< through holes go on to the stock's bottom: a plate lies under it

    bool any() const { return top_z_mm > bottom_z_mm; }
};
HeldStock heldStock(const Stage& stage);

/// A setup's features without what would be cut of held stock, which is unplanned with the reason Holding:
/// the volumes of both add up to what they did. Of stock that is all held holes alone are drilled into it,
/// where a plate lies below or the longest drill point ends inside; of other stock only features stop above
/// it that are open to the outside, or lie below such a one.
FeatureSet withHeldStock(FeatureSet found, const HeldStock& held, const Tolerances& tol);

/// The held stock as cutters, shanks and holders keep clear of it: without the features that go into it;
/// empty where none is held. \param found  withHeldStock()
Region heldSection(const LayerStack& layers, const FeatureSet& found, const HeldStock& held,
                   const Tolerances& tol);

}  // namespace stepmill
