// Setups in turn, each on the stock the ones before it left.

#include "stepmill/plan/stages.h"

#include <fmt/format.h>

#include "stepmill/layers/stock_after.h"

namespace stepmill {
namespace {

bool isUndercut(const Unplanned& unplanned) {
    return unplanned.reason == Reason::Undercut;
}

/// Takes air off the unplanned volumes that span a slab; returns what of it is left.
double takeAir(std::vector<Unplanned>& unplanned, const Layer& layer, double air_mm3, bool undercuts) {
    const double middle = (layer.top_z_mm + layer.bottom_z_mm) / 2;
    for (Unplanned& entry : unplanned) {
        if (isUndercut(entry) != undercuts) continue;
        if (entry.bottom_z_mm > middle || entry.top_z_mm < middle) continue;
        const double taken = std::min(air_mm3, entry.volume_mm3);
        entry.volume_mm3 -= taken;
        air_mm3 -= taken;
    }
    return air_mm3;
}

/// What the slabs of the stock cover beyond the stock is no material: first where walls lean, which is where
/// it comes from, then under overhangs; the rest lies in features.
double netOfAir(FeatureSet& found, const LayerStack& layers) {
    double hull_mm3 = 0;
    double air_mm3 = 0;
    for (const Layer& layer : layers.layers) {
        hull_mm3 += area(layer.stock) * layer.height_mm();
        air_mm3 += layer.stock_air_mm3;
    }
    if (air_mm3 <= 0) return 0;
    // Slabs' volumes come from a quadrature; the solid's own volume is surer.
    const double scale = std::max(0.0, hull_mm3 - layers.stock_volume_mm3) / air_mm3;
    double left_mm3 = 0;
    for (const Layer& layer : layers.layers) {
        double air = scale * layer.stock_air_mm3;
        for (const bool undercuts : {false, true})
            air = takeAir(found.unplanned, layer, air, undercuts);
        left_mm3 += air;
    }
    std::erase_if(found.unplanned, [](const Unplanned& entry) { return entry.volume_mm3 <= 0; });
    return left_mm3;
}

Stage makeStage(Setup setup, const SliceOptions& slicing, const Tolerances& tol) {
    Stage stage;
    stage.setup = std::move(setup);
    stage.layers = slice(stage.setup, tol, slicing);
    stage.found = recogniseFeatures(stage.layers, tol);
    stage.air_mm3 = netOfAir(stage.found, stage.layers);
    return stage;
}

}  // namespace

StageAir airOf(const Stage& stage) {
    StageAir air{0, stage.air_mm3};
    for (const Layer& layer : stage.layers.layers)
        air.hull_mm3 += layer.stock_air_mm3;
    return air;
}

SettledAir settleAir(const StageAir& air, double prisms_mm3, double removed_mm3) {
    SettledAir settled;
    settled.in_prisms_mm3 = std::clamp(prisms_mm3 - removed_mm3, 0.0, air.hull_mm3);
    settled.back_mm3 = std::max(0.0, settled.in_prisms_mm3 - air.unsettled_mm3);
    settled.left_mm3 = std::max(0.0, air.unsettled_mm3 - settled.in_prisms_mm3);
    return settled;
}

std::vector<Prism> featurePrisms(const FeatureSet& found) {
    std::vector<Prism> prisms;
    for (const Feature& feature : found.features)
        prisms.push_back({feature.target, feature.top_z_mm, feature.floor_z_mm});
    return prisms;
}

SetupWalk::SetupWalk(std::vector<Setup> setups, const SliceOptions& slicing, const Tolerances& tol)
    : setups_(std::move(setups)), slicing_(slicing), tol_(tol) {
    if (!setups_.empty()) left_ = setups_.front().stock;
}

std::optional<Stage> SetupWalk::next() {
    while (next_ < setups_.size()) {
        const Setup& planned = setups_[next_++];
        const bool first = cut_ == 0;
        Setup setup = first ? planned : onStock(planned, left_);
        setup.id = fmt::format("S{}", cut_ + 1);
        Stage stage = makeStage(std::move(setup), slicing_, tol_);
        if (first || !planned.chosen || !stage.found.features.empty()) return stage;
    }
    return std::nullopt;
}

StockStep SetupWalk::cut(const Stage& stage, const std::vector<Prism>& removed) {
    StockAfter after = stockAfter(stage.setup, stage.layers, removed, tol_);
    ++cut_;
    left_ = std::move(after.stock);
    return {stage.setup.id, stage.setup.stock.volume_mm3, after.removed_mm3, after.prisms_mm3,
            left_.volume_mm3};
}

}  // namespace stepmill
