#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stepmill/feature/feature.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/setup/clamping.h"
#include "stepmill/setup/prism.h"
#include "stepmill/setup/setup.h"

namespace stepmill {

/// A setup with the stock as it arrives, its layers and features.
struct Stage {
    Setup setup;
    std::size_t place = 0;  ///< of the setup among those that are walked
    LayerStack layers;
    FeatureSet found;
    std::vector<Prism> reserve;  ///< stock that stands for later setups, which cut it; no feature holds any
    Clamping clamping;           ///< none before holdStage() (plan/hold_stage.h)
    /// Volume of `found.features` that earlier setups cut already from other sides, where the stock's walls
    /// lean and slabs stand for their hull [mm3]. Unplanned volumes are free of it: stock as it arrives -
    /// part = features + unplanned - air_mm3.
    double air_mm3 = 0;
};

/// Air among a stage's volumes: what slabs of stock whose walls lean cover beyond the stock [mm3].
struct StageAir {
    double hull_mm3 = 0;       ///< all of it
    double unsettled_mm3 = 0;  ///< what the unplanned volumes had no room for: Stage::air_mm3
};
StageAir airOf(const Stage& stage);

/// Where that air was, once it is known what the prisms really took from the stock. It was taken off the
/// unplanned volumes first; what of it the prisms held goes back there.
struct SettledAir {
    double in_prisms_mm3 = 0;
    double back_mm3 = 0;  ///< to the unplanned volumes, where walls lean
    double left_mm3 = 0;  ///< still to be taken off
};
SettledAir settleAir(const StageAir& air, double prisms_mm3, double removed_mm3);

/// A setup's stock account: what came, what went, what is left, measured on the solids [mm3].
struct StockStep {
    std::string setup_id;
    double arrives_mm3 = 0;
    double removed_mm3 = 0;
    double prisms_mm3 = 0;  ///< volume of the prisms removed, from the planar books; air in them included
    double leaves_mm3 = 0;
};

/// The setups in turn, each on the stock that those before it leave: slices it, recognises features.
///
///     while (std::optional<Stage> stage = walk.next())
///         walk.cut(*stage, featurePrisms(stage->found));
///
/// A setup that was chosen, not asked for, and has no feature left to cut is left out; so is one that is not
/// cut before the next is asked for. Those after it are numbered without it. The first setup is always
/// there. Features found from two sides are the first setup's: they are gone from the stock when the second
/// arrives, unless the first one leaves them to it as its reserve. What is not cut stays in the stock.
class SetupWalk {
  public:
    /// \param setups    from chooseSetups
    /// \param reserves  what each of them leaves for later ones, whatever frame it is told in; empty: nothing
    SetupWalk(std::vector<Setup> setups, const SliceOptions& slicing, const Tolerances& tol,
              std::vector<CutPrisms> reserves = {});

    /// The next setup; nothing after the last. Passes over those that were chosen and have nothing to cut.
    /// \param leaning_too  not over those that see enough walls which lean to pay for a setup
    /// \throws what slice and recogniseFeatures do
    std::optional<Stage> next(bool leaning_too = false);
    /// How many setups it has not looked at yet.
    std::size_t setupsLeft() const { return setups_.size() - next_; }

    /// Cuts from the stock what the stage really takes away. A stock that cannot be made stays as it arrived,
    /// with a remark.
    /// \param removed  in setup coordinates
    StockStep cut(const Stage& stage, const std::vector<Prism>& removed);

    /// What is left of the stock so far, in part coordinates.
    const Stock& left() const { return left_; }

  private:
    std::vector<Setup> setups_;
    std::vector<CutPrisms> reserves_;
    SliceOptions slicing_;
    Tolerances tol_;
    std::size_t next_ = 0;
    int cut_ = 0;  ///< stages
    Stock left_;
};

/// The prisms of all features, whole: what a stage removes before tools are known.
std::vector<Prism> featurePrisms(const FeatureSet& found);

}  // namespace stepmill
