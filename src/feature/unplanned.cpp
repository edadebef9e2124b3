#include "feature/unplanned.h"

#include <map>

#include "stepmill/feature/region_compare.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::feature {
namespace {

/// Volumes below this are rounding [mm3].
constexpr double kNoVolumeMm3 = 1e-9;

/// Stock of the layer that the part above hides from the tool.
Region undercut(const Layer& layer, const Tolerances& tol) {
    if (identical(layer.shadow, layer.part)) return {};
    return intersect(subtract(layer.shadow, layer.part, tol), layer.stock, tol);
}

/// Entries of one reason, from above to below.
class Tally {
  public:
    Tally(Reason reason, const Tolerances& tol) : reason_(reason), tol_(tol) {}

    void add(const Layer& layer, double volume_mm3, Region region) {
        if (volume_mm3 <= kNoVolumeMm3) return;
        if (!entries_.empty() && entries_.back().bottom_z_mm == layer.top_z_mm &&
            sameRegion(entries_.back().region, region, tol_)) {
            entries_.back().bottom_z_mm = layer.bottom_z_mm;
            entries_.back().volume_mm3 += volume_mm3;
            return;
        }
        entries_.push_back({{reason_, {}}, volume_mm3, layer.top_z_mm, layer.bottom_z_mm, std::move(region)});
    }
    const std::vector<Unplanned>& entries() const { return entries_; }

  private:
    Reason reason_;
    const Tolerances& tol_;
    std::vector<Unplanned> entries_;
};

/// What leaning walls hide, by cause.
class SlopeTallies {
  public:
    explicit SlopeTallies(const Tolerances& tol) : tol_(tol) {}

    void add(const Layer& layer) {
        double named_mm3 = 0;
        for (const HiddenVolume& hidden : layer.hidden) {
            tally(hidden.cause).add(layer, hidden.volume_mm3, {});
            named_mm3 += hidden.volume_mm3;
        }
        tally(SlopeCause::Draft).add(layer, layer.sloped_volume_mm3 - named_mm3, {});
    }
    /// What of a layer's removal lies in drill points.
    void addDrillPoints(const Layer& layer, double volume_mm3) {
        tally(SlopeCause::DrillPoint).add(layer, volume_mm3, {});
    }
    /// In the order of their words.
    const std::map<StayReason, Tally, InOrderOfWords>& tallies() const { return tallies_; }

  private:
    Tally& tally(SlopeCause cause) {
        const Reason reason = reasonOf(cause);
        return tallies_.try_emplace({reason, {}}, reason, tol_).first->second;
    }

    const Tolerances& tol_;
    std::map<StayReason, Tally, InOrderOfWords> tallies_;
};

}  // namespace

std::vector<Unplanned> findUnplanned(const LayerStack& layers, const RemovalForest& forest,
                                     const Tolerances& tol) {
    Tally undercuts(Reason::Undercut, tol);
    SlopeTallies slopes(tol);
    Tally slivers(Reason::Sliver, tol);
    Tally leftovers(Reason::LeftByEarlierSetups, tol);
    for (std::size_t i = 0; i < layers.layers.size(); ++i) {
        const Layer& layer = layers.layers[i];
        Region hidden = undercut(layer, tol);
        double sliver_mm2 = forest.sliver_area_mm2[i];
        if (isSliver(hidden, tol)) {
            sliver_mm2 += area(hidden);
        } else {
            const double volume_mm3 = area(hidden) * layer.height_mm();
            undercuts.add(layer, volume_mm3, std::move(hidden));
        }
        slopes.add(layer);
        slivers.add(layer, sliver_mm2 * layer.height_mm(), {});
        double left_mm2 = 0;
        double in_points_mm2 = 0;
        for (const int index : forest.of_layer[i]) {
            const RemovalComponent& component = forest.components[index];
            if (component.left) (component.in_drill_point ? in_points_mm2 : left_mm2) += component.area_mm2;
        }
        slopes.addDrillPoints(layer, in_points_mm2 * layer.height_mm());
        leftovers.add(layer, left_mm2 * layer.height_mm(), {});
    }
    std::vector<Unplanned> all = undercuts.entries();
    const auto append = [&](const Tally& tally) {
        all.insert(all.end(), tally.entries().begin(), tally.entries().end());
    };
    for (const auto& [reason, tally] : slopes.tallies())
        append(tally);
    append(slivers);
    append(leftovers);
    return all;
}

}  // namespace stepmill::feature
