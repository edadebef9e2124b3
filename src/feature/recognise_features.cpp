#include <algorithm>

#include "feature/bands.h"
#include "feature/drill_points.h"
#include "feature/feature_groups.h"
#include "feature/group_holes.h"
#include "feature/leftovers.h"
#include "feature/removal_forest.h"
#include "feature/standing_material.h"
#include "feature/unplanned.h"
#include "stepmill/feature/describe_boundary.h"
#include "stepmill/feature/feature.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

using feature::RemovalComponent;
using feature::RemovalForest;

class Recogniser {
  public:
    Recogniser(const LayerStack& layers, const Tolerances& tol)
        : layers_(layers),
          tol_(tol),
          points_(feature::drillPoints(layers)),
          forest_(worthwhileForest(layers, points_, tol)),
          standing_(layers, forest_, tol),
          owner_(forest_.components.size(), -1) {}

    FeatureSet run() {
        FeatureSet found;
        for (const feature::FeatureGroup& group : feature::featureGroups(forest_, layers_, tol_))
            found.features.push_back(makeFeature(group));
        feature::groupEqualHoles(found.features, tol_);
        feature::joinBands(found.features, layers_, tol_);
        found.unplanned = feature::findUnplanned(layers_, forest_, tol_);
        return found;
    }

  private:
    static RemovalForest worthwhileForest(const LayerStack& layers,
                                          const std::vector<feature::DrillPoint>& points,
                                          const Tolerances& tol) {
        RemovalForest forest = feature::buildRemovalForest(layers, tol);
        feature::markLeftovers(forest, layers, tol);
        feature::markDrillPoints(forest, layers, points);
        return forest;
    }

    Feature makeFeature(const feature::FeatureGroup& group) {
        const int number = static_cast<int>(removed_.size());
        const RemovalComponent& first = forest_.components[group.components.front()];
        const RemovalComponent& last = forest_.components[group.components.back()];
        for (const int index : group.components)
            owner_[index] = number;
        const std::vector<int> parents = parentFeatures(group.components, number);
        removed_.push_back(removedOnceDone(group.components, parents));

        Feature made;
        made.id = idOf(number);
        made.setup_id = layers_.setup_id;
        for (const int parent : parents)
            made.parents.push_back(idOf(parent));
        made.top_z_mm = layers_.layers[first.layer].top_z_mm;
        made.floor_z_mm = layers_.layers[last.layer].bottom_z_mm;
        made.target = group.target;
        made.obstruction = standing_.above(last.layer, removed_.back());
        made.obstacles = standing_.obstacles(last.layer, removed_.back());
        lookBelow(made, last.layer);
        made.area_mm2 = area(made.target);
        for (const int index : group.components)
            made.volume_mm3 += feature::volumeMm3(forest_.components[index], layers_);
        describeBoundary(made, tol_);
        made.point_mm = feature::pointUnder(made, points_, tol_);
        return made;
    }

    std::string idOf(int number) const { return layers_.setup_id + ".F" + std::to_string(number + 1); }

    /// Features other than `own` that own a parent of the components.
    std::vector<int> parentFeatures(const std::vector<int>& group, int own) const {
        std::vector<int> parents;
        for (const int index : group)
            for (const int parent : forest_.components[index].parents)
                if (owner_[parent] != own) parents.push_back(owner_[parent]);
        std::sort(parents.begin(), parents.end());
        parents.erase(std::unique(parents.begin(), parents.end()), parents.end());
        return parents;
    }

    /// The components of the group and of all its ancestors, ascending.
    std::vector<int> removedOnceDone(const std::vector<int>& group, const std::vector<int>& parents) const {
        std::vector<int> all = group;
        for (const int parent : parents)
            all.insert(all.end(), removed_[parent].begin(), removed_[parent].end());
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }

    /// Sets whether it is through.
    void lookBelow(Feature& made, int above) const {
        if (!isFullCircles(made.target)) {
            made.through = nothingBelow(made.target, above);
            return;
        }
        const std::optional<double> room_mm = partBelowMm(made.target, above);
        made.through = !room_mm || *room_mm >= outOfHoleMm(radiusOfCircles(made.target));
        if (made.through) made.room_below_mm = room_mm;
    }

    bool meets(const Region& floor, const Region& region) const {
        return area(intersect(floor, region, tol_)) > tol_.area_mm2;
    }

    bool nothingBelow(const Region& floor, int above) const {
        return std::none_of(
            layers_.layers.begin() + above + 1, layers_.layers.end(),
            [&](const Layer& layer) { return meets(floor, layer.stock) || meets(floor, layer.part); });
    }

    /// How far below the floor part begins, or what is to stay as if it were; nothing where none does.
    std::optional<double> partBelowMm(const Region& floor, int above) const {
        const auto below = std::find_if(layers_.layers.begin() + above + 1, layers_.layers.end(),
                                        [&](const Layer& layer) { return meets(floor, layer.shadow); });
        if (below == layers_.layers.end()) return std::nullopt;
        return layers_.layers[above].bottom_z_mm - below->top_z_mm;
    }

    const LayerStack& layers_;
    const Tolerances& tol_;
    std::vector<feature::DrillPoint> points_;
    RemovalForest forest_;
    feature::StandingMaterial standing_;
    std::vector<int> owner_;                 ///< feature number of each component
    std::vector<std::vector<int>> removed_;  ///< by feature number: components gone once it is done
};

}  // namespace

FeatureSet recogniseFeatures(const LayerStack& layers, const Tolerances& tol) {
    return Recogniser(layers, tol).run();
}

}  // namespace stepmill
