// Setups in turn, each on the stock the ones before it left.

#include "stepmill/plan/stages.h"

#include <fmt/format.h>

#include "plan/forms/form_stairs.h"
#include "stepmill/feature/heights.h"
#include "stepmill/layers/reserve.h"
#include "stepmill/layers/stock_after.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// Volumes below this are rounding [mm3].
constexpr double kNoVolumeMm3 = 1e-9;

bool isHidden(const Unplanned& unplanned) {
    return unplanned.reason == Reason::Undercut || unplanned.reason == Reason::LeftForLater;
}

/// Takes off the unplanned volumes what lies in the slabs that they span and is none.
class AirTaker {
  public:
    /// Keeps `unplanned`.
    explicit AirTaker(std::vector<Unplanned>& unplanned) : unplanned_(unplanned) {
        for (const Unplanned& entry : unplanned)
            per_mm_.push_back(entry.volume_mm3 / (entry.top_z_mm - entry.bottom_z_mm));
    }

    /// Where walls lean, which is where air comes from, then under overhangs.
    /// \returns what of it is left
    double take(double air_mm3, const Layer& layer) {
        for (const bool hidden : {false, true})
            for (std::size_t i = 0; i < unplanned_.size(); ++i)
                if (isHidden(unplanned_[i]) == hidden) air_mm3 -= takeOff(i, air_mm3, layer);
        return air_mm3;
    }

  private:
    double takeOff(std::size_t i, double air_mm3, const Layer& layer) {
        Unplanned& entry = unplanned_[i];
        if (!layer.isWithin(entry.top_z_mm, entry.bottom_z_mm)) return 0;
        const double taken = std::min({air_mm3, entry.volume_mm3, inSlabMm3(i, layer)});
        entry.volume_mm3 -= taken;
        return taken;
    }

    /// What walls of the cause hide there; else of the whole volume its share by height.
    double inSlabMm3(std::size_t i, const Layer& layer) const {
        double hidden_mm3 = 0;
        for (const HiddenVolume& hidden : layer.hidden)
            if (unplanned_[i].reason == reasonOf(hidden.cause)) hidden_mm3 += hidden.volume_mm3;
        return hidden_mm3 > 0 ? hidden_mm3 : per_mm_[i] * layer.height_mm();
    }

    std::vector<Unplanned>& unplanned_;
    std::vector<double> per_mm_;  ///< of each of them at first
};

/// What a slab of the part covers beyond that of the stock: hulls of the same wall, cut in an earlier setup,
/// that end differently [mm3].
double beyondStockMm3(const Layer& layer, const Tolerances& tol) {
    if (layer.stock_air_mm3 <= 0 || layer.vertical_walls) return 0;
    return area(subtract(layer.part, layer.stock, tol)) * layer.height_mm();
}

/// What the slabs of the stock cover beyond the stock is no material; what of it is not among the unplanned
/// volumes of its slab lies in features. Nor is what the part's slabs cover beyond the stock's hidden by
/// walls.
double netOfAir(FeatureSet& found, const LayerStack& layers, const Tolerances& tol) {
    double hull_mm3 = 0;
    double all_air_mm3 = 0;
    for (const Layer& layer : layers.layers) {
        hull_mm3 += area(layer.stock) * layer.height_mm();
        all_air_mm3 += layer.stock_air_mm3;
    }
    if (all_air_mm3 <= 0) return 0;
    // Slabs' volumes come from a quadrature; the solid's own volume is surer.
    const double scale = std::max(0.0, hull_mm3 - layers.stock_volume_mm3) / all_air_mm3;
    AirTaker taker(found.unplanned);
    double left_mm3 = 0;
    for (const Layer& layer : layers.layers) {
        const double air_mm3 = scale * layer.stock_air_mm3;
        left_mm3 += std::min(air_mm3, taker.take(air_mm3 + beyondStockMm3(layer, tol), layer));
    }
    std::erase_if(found.unplanned, [](const Unplanned& entry) { return entry.volume_mm3 <= 0; });
    return left_mm3;
}

/// The prisms in the setup's coordinates: both frames belong to its axis, so they differ by a shift.
std::vector<Prism> seenFrom(const Setup& setup, CutPrisms reserve) {
    const Vec3 shift = (setup.part_to_setup * reserve.part_to_setup.inverse()).translation();
    for (Prism& prism : reserve.prisms) {
        prism.region = translated(prism.region, snapToGrid(Vec2(shift.head<2>())));
        prism.top_z_mm += shift.z();
        prism.bottom_z_mm += shift.z();
    }
    return std::move(reserve.prisms);
}

/// What of an entry stands in the reserve or under it.
Region inReserve(const Unplanned& entry, const std::vector<Prism>& reserve, const Tolerances& tol) {
    std::vector<Region> over;
    for (const Prism& prism : reserve)
        if (prism.top_z_mm > entry.bottom_z_mm + kSameWrittenHeightMm) over.push_back(prism.region);
    return over.empty() ? Region{} : intersect(entry.region, unite(over, tol), tol);
}

/// To a tool from above the reserve hides ground as the part does: here it gets a reason of its own.
void nameReserve(std::vector<Unplanned>& unplanned, const std::vector<Prism>& reserve,
                 const Tolerances& tol) {
    if (reserve.empty()) return;
    std::vector<Unplanned> left;
    for (Unplanned& entry : unplanned) {
        if (entry.reason != Reason::Undercut) continue;
        Region in_reserve = inReserve(entry, reserve, tol);
        if (area(in_reserve) <= tol.area_mm2) continue;
        const double height_mm = entry.top_z_mm - entry.bottom_z_mm;
        const double volume_mm3 = std::min(entry.volume_mm3, area(in_reserve) * height_mm);
        entry.region = subtract(entry.region, in_reserve, tol);
        entry.volume_mm3 -= volume_mm3;
        left.push_back({{Reason::LeftForLater, {}},
                        volume_mm3,
                        entry.top_z_mm,
                        entry.bottom_z_mm,
                        std::move(in_reserve)});
    }
    std::erase_if(unplanned, [](const Unplanned& entry) { return entry.volume_mm3 <= kNoVolumeMm3; });
    std::move(left.begin(), left.end(), std::back_inserter(unplanned));
}

Stage makeStage(Setup setup, std::vector<Prism> reserve, const SliceOptions& slicing, const Tolerances& tol) {
    Stage stage;
    stage.setup = std::move(setup);
    stage.reserve = std::move(reserve);
    stage.layers = withReserve(slice(stage.setup, tol, slicing), stage.reserve, tol);
    stage.found = recogniseFeatures(stage.layers, tol);
    nameReserve(stage.found.unplanned, stage.reserve, tol);
    stage.air_mm3 = netOfAir(stage.found, stage.layers, tol);
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

SetupWalk::SetupWalk(std::vector<Setup> setups, const SliceOptions& slicing, const Tolerances& tol,
                     std::vector<CutPrisms> reserves)
    : setups_(std::move(setups)), reserves_(std::move(reserves)), slicing_(slicing), tol_(tol) {
    if (!setups_.empty()) left_ = setups_.front().stock;
}

std::optional<Stage> SetupWalk::next(bool leaning_too) {
    while (next_ < setups_.size()) {
        const Setup& planned = setups_[next_++];
        const bool first = cut_ == 0;
        Setup setup = first ? planned : onStock(planned, left_);
        setup.id = fmt::format("S{}", cut_ + 1);
        const std::size_t place = next_ - 1;
        std::vector<Prism> reserve;
        if (place < reserves_.size()) reserve = seenFrom(setup, reserves_[place]);
        Stage stage = makeStage(std::move(setup), std::move(reserve), slicing_, tol_);
        stage.place = place;
        const bool pays =
            leaning_too && mostStairsMm3(stage.layers) >= kPaysForASetupShare * planned.removable_mm3;
        const bool cuts = !stage.found.features.empty() || pays;
        if (first || !planned.chosen || cuts) return stage;
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
