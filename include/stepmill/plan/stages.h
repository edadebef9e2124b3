#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/feature/feature.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/setup/clamping.h"
#include "stepmill/setup/setup.h"

namespace stepmill {

struct SequenceOptions;
struct ToolLibrary;

/// A setup with the stock as it arrives, its layers and features.
struct Stage {
    Setup setup;
    LayerStack layers;
    FeatureSet found;
    Clamping clamping;  ///< free of all that `found` would cut
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

/// All setups done.
struct WalkedSetups {
    std::vector<StockStep> steps;  ///< one for each setup visited
    Stock left;                    ///< what the last setup leaves, in part coordinates
};

/// Called with each stage; returns what the setup really takes away, in setup coordinates, or nothing to
/// leave the setup out after all (the next one then gets its id).
using StageVisitor = std::function<std::optional<std::vector<Prism>>(const Stage& stage)>;

/// Goes through the setups in order: slice the stock as it arrives, recognise features, let `visit` say what
/// is removed, cut that from the stock for the next.
///
/// A setup that was chosen, not asked for, and has no feature left to cut is left out and those after it
/// are numbered without it; the first is always visited. Features found from two sides are the first
/// setup's: they are gone from the stock when the second arrives. What `visit` does not return stays in
/// the stock.
/// \param setups  from chooseSetups
/// A stock that cannot be made stays as it arrived, with a remark.
/// \throws what slice and recogniseFeatures do.
WalkedSetups walkSetups(const std::vector<Setup>& setups, const SliceOptions& slicing, const Tolerances& tol,
                        const StageVisitor& visit);

/// Features deeper than the widest mill reaches, parted into bands of equal depth one below the other, each a
/// feature of its own ("S1.F3.1" and so on) that waits for the one above: a tool then cuts no deeper beside
/// its own work than shank and holder stay above it, and each band takes the tools that reach it. Holes stay
/// whole, for drills. Features keep their order.
std::vector<Feature> inBands(const std::vector<Feature>& features, const ToolLibrary& library,
                             const std::string& material);

/// The options as a plan sequences features with them, whatever they say: no tool meets its own leftovers.
SequenceOptions asPlanned(SequenceOptions options);

/// The prisms of all features, whole: what a stage removes before tools are known.
std::vector<Prism> featurePrisms(const FeatureSet& found);

}  // namespace stepmill
