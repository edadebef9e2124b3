// What of a setup's stock is held and therefore stays.

#include "plan/holding/held_stock.h"

#include <algorithm>
#include <map>
#include <set>

#include "stepmill/feature/describe_boundary.h"
#include "stepmill/feature/heights.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// Features that stop above held stock, and what of them it keeps.
class Withholder {
  public:
    Withholder(const HeldStock& held, const Tolerances& tol) : held_(held), tol_(tol) {}

    FeatureSet run(FeatureSet found) {
        FeatureSet free;
        free.unplanned = std::move(found.unplanned);
        for (Feature& feature : found.features)
            add(std::move(feature), free);
        countBands(free.features);
        return free;
    }

  private:
    void add(Feature feature, FeatureSet& free) {
        if (!stops(feature)) return free.features.push_back(std::move(feature));
        stopped_.insert(feature.id);
        const double top_mm = std::min(feature.top_z_mm, held_.top_z_mm);
        const double held_mm3 = feature.volume_mm3 * (top_mm - feature.floor_z_mm) / feature.depth_mm();
        free.unplanned.push_back(
            {{Reason::Holding, {}}, held_mm3, top_mm, feature.floor_z_mm, feature.target});
        if (feature.top_z_mm <= held_.top_z_mm + kSameHeightMm) return;
        feature.volume_mm3 -= held_mm3;
        free.features.push_back(raised(std::move(feature)));
    }

    bool stops(const Feature& feature) const {
        if (feature.floor_z_mm >= held_.top_z_mm - kSameHeightMm) return false;
        if (held_.all)
            return feature.top_z_mm <= held_.top_z_mm + kSameHeightMm ||
                   !(feature.through && isHole(feature.feature_class));
        return feature.open_length_mm > 0 ||
               std::any_of(feature.parents.begin(), feature.parents.end(),
                           [&](const std::string& parent) { return stopped_.count(parent) > 0; });
    }

    Feature raised(Feature feature) const {
        feature.floor_z_mm = held_.top_z_mm;
        std::erase_if(feature.obstacles, [&](const Obstacle& obstacle) {
            return obstacle.top_z_mm <= held_.top_z_mm + kSameHeightMm;
        });
        if (!feature.obstacles.empty())
            feature.obstacles.front().bottom_z_mm =
                std::max(feature.obstacles.front().bottom_z_mm, held_.top_z_mm);
        feature.through = false;
        feature.point_mm = 0;
        describeBoundary(feature, tol_);
        return feature;
    }

    /// Lower bands may be gone; what is left is numbered anew.
    static void countBands(std::vector<Feature>& features) {
        std::map<std::string, int> count;
        for (const Feature& feature : features)
            if (feature.band) ++count[feature.band->of];
        std::map<std::string, std::string> names;
        for (Feature& feature : features) {
            if (!feature.band) continue;
            feature.band->count = count.at(feature.band->of);
            std::string id = bandId(feature.band->of, feature.band->number, feature.band->count);
            names[feature.id] = id;
            feature.id = std::move(id);
            if (feature.band->count == 1) feature.band.reset();
        }
        for (Feature& feature : features)
            for (std::string& parent : feature.parents)
                if (const auto found = names.find(parent); found != names.end()) parent = found->second;
    }

    const HeldStock& held_;
    const Tolerances& tol_;
    std::set<std::string> stopped_;
};

}  // namespace

HeldStock heldStock(const Stage& stage) {
    HeldStock held;
    held.bottom_z_mm = stage.layers.stock_bottom_z_mm;
    held.top_z_mm = held.bottom_z_mm + stage.clamping.held_mm;
    held.all = stage.clamping.holds_all;
    return held;
}

FeatureSet withHeldStock(FeatureSet found, const HeldStock& held, const Tolerances& tol) {
    if (!held.any()) return found;
    return Withholder(held, tol).run(std::move(found));
}

Region heldSection(const LayerStack& layers, const FeatureSet& found, const HeldStock& held,
                   const Tolerances& tol) {
    std::vector<Region> sections;
    if (held.any())
        for (const Layer& layer : layers.layers)
            if (layer.bottom_z_mm < held.top_z_mm - kSameHeightMm && !layer.stock.empty())
                sections.push_back(layer.stock);
    if (sections.empty()) return {};
    Region stock = unite(sections, tol);
    std::vector<Region> cut;
    for (const Feature& feature : found.features)
        if (feature.floor_z_mm < held.top_z_mm - kSameHeightMm) cut.push_back(feature.target);
    return cut.empty() ? stock : subtract(stock, unite(cut, tol), tol);
}

}  // namespace stepmill
