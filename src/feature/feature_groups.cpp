// Components of removal sorted into features.

#include "feature/feature_groups.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "stepmill/feature/hole_group.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::feature {
namespace {

/// A feature whose components change with the stock holds at most this share of air: feeding through it costs
/// less than a feature, and its tools, for every slab.
constexpr double kMostAirShare = 0.6;
/// ... and it does not go on where next to nothing stands: over a layer of more air than this ...
constexpr double kNextToAllShare = 0.9;
/// ... that holds more of it than this share of all that stands in the feature.
constexpr double kMuchForTheFeature = 0.5;
/// A hole goes on behind air that is no longer than so many of its diameters: else a drill runs off.
constexpr double kLongestGapDiameters = 2;
/// Layers with less between them lie on each other [mm].
constexpr double kNoGapMm = 1e-6;

class Grouper {
  public:
    Grouper(const RemovalForest& forest, const LayerStack& layers, const Tolerances& tol)
        : forest_(forest), layers_(layers), tol_(tol), group_of_(forest.components.size(), -1) {}

    std::vector<FeatureGroup> run() {
        for (const std::vector<int>& layer : forest_.of_layer)
            for (const Cluster& cluster : clusters(layer))
                if (!isAdded(cluster) && !addTogether(cluster))
                    for (const int index : cluster.components)
                        if (group_of_[index] < 0) add(index);
        std::vector<FeatureGroup> sorted;
        for (FeatureGroup& group : groups_)
            if (!group.components.empty()) sorted.push_back(std::move(group));
        std::sort(sorted.begin(), sorted.end(), [](const FeatureGroup& a, const FeatureGroup& b) {
            return a.components.front() < b.components.front();
        });
        return sorted;
    }

  private:
    /// Components of one layer that share groups above them.
    struct Cluster {
        std::vector<int> components;
        std::vector<int> above;  ///< groups, ascending
    };

    /// Some cluster before may have taken all of it.
    bool isAdded(const Cluster& cluster) const {
        return std::any_of(cluster.components.begin(), cluster.components.end(),
                           [&](int index) { return group_of_[index] >= 0; });
    }

    std::vector<int> groupsAbove(int index) const {
        std::vector<int> above;
        for (const int parent : forest_.components[index].parents)
            above.push_back(group_of_[parent]);
        std::sort(above.begin(), above.end());
        above.erase(std::unique(above.begin(), above.end()), above.end());
        return above;
    }

    std::vector<Cluster> clusters(const std::vector<int>& layer) const {
        std::vector<Cluster> found;
        for (const int index : layer) {
            if (forest_.components[index].left) continue;
            Cluster cluster{{index}, groupsAbove(index)};
            for (std::size_t i = found.size(); i-- > 0;) {
                Cluster& other = found[i];
                if (std::none_of(other.above.begin(), other.above.end(), [&](int group) {
                        return std::binary_search(cluster.above.begin(), cluster.above.end(), group);
                    }))
                    continue;
                std::vector<int> above;
                std::set_union(other.above.begin(), other.above.end(), cluster.above.begin(),
                               cluster.above.end(), std::back_inserter(above));
                other.components.insert(other.components.end(), cluster.components.begin(),
                                        cluster.components.end());
                cluster = {std::move(other.components), std::move(above)};
                found.erase(found.begin() + static_cast<std::ptrdiff_t>(i));
            }
            std::sort(cluster.components.begin(), cluster.components.end());
            found.push_back(std::move(cluster));
        }
        return found;
    }

    bool addTogether(const Cluster& cluster) { return cluster.components.size() > 1 && addJoined(cluster); }

    /// Adds the components, and what else stands over their common ground, to the groups above them, if one
    /// feature may clear them all.
    bool addJoined(Cluster cluster) {
        while (!cluster.above.empty()) {
            const std::optional<FeatureGroup> joined = join(cluster);
            if (!joined) return false;
            const std::optional<int> other = otherOver(*joined);
            if (!other) {
                replace(cluster.above, *joined);
                return true;
            }
            if (forest_.components[*other].left) return false;
            absorb(*other, cluster);
        }
        return false;
    }

    void absorb(int other, Cluster& cluster) const {
        std::vector<int> more{group_of_[other]};
        if (more.front() < 0) {
            cluster.components.insert(
                std::lower_bound(cluster.components.begin(), cluster.components.end(), other), other);
            more = groupsAbove(other);
        }
        std::vector<int> above;
        std::set_union(cluster.above.begin(), cluster.above.end(), more.begin(), more.end(),
                       std::back_inserter(above));
        cluster.above = std::move(above);
    }

    void add(int index) {
        const RemovalComponent& component = forest_.components[index];
        const Cluster alone{{index}, groupsAbove(index)};
        if (deepens(component)) {
            FeatureGroup& group = groups_[alone.above.front()];
            group.components.push_back(index);
            group.target = component.region;
            group_of_[index] = alone.above.front();
        } else if (!addJoined(alone)) {
            replace({}, {{index}, component.region});
        }
    }

    void replace(const std::vector<int>& old, FeatureGroup group) {
        for (const int gone : old)
            groups_[gone] = {};
        for (const int member : group.components)
            group_of_[member] = static_cast<int>(groups_.size());
        groups_.push_back(std::move(group));
    }

    /// Is it its parent once more, a layer deeper?
    bool deepens(const RemovalComponent& component) const {
        if (component.parents.size() != 1) return false;
        const int parent = component.parents.front();
        const RemovalComponent& over = forest_.components[parent];
        return over.layer + 1 == component.layer && over.children.size() == 1 &&
               identical(groups_[group_of_[parent]].target, over.region) &&
               sameRegion(over.region, component.region, tol_);
    }

    /// The components together with the groups above them, if the part leaves their common ground free.
    /// \pre there is a group above
    std::optional<FeatureGroup> join(const Cluster& cluster) const {
        const int layer = forest_.components[cluster.components.front()].layer;
        const Layer& floor = layers_.layers[layer];
        // In stock that does not change a smaller component has a floor beside it.
        const bool inside = std::all_of(cluster.components.begin(), cluster.components.end(),
                                        [&](int index) { return forest_.components[index].inside_parent; });
        if (inside && identical(floor.stock, layers_.layers[layer - 1].stock)) return std::nullopt;
        FeatureGroup group;
        std::vector<Region> grounds;
        for (const int old : cluster.above) {
            const FeatureGroup& member = groups_[old];
            group.components.insert(group.components.end(), member.components.begin(),
                                    member.components.end());
            grounds.push_back(member.target);
        }
        for (const int index : cluster.components) {
            group.components.push_back(index);
            grounds.push_back(forest_.components[index].region);
        }
        std::sort(group.components.begin(), group.components.end());
        group.target = unite(grounds, tol_);
        if (gapOver(floor, cluster.above) > longestGapMm(cluster)) return std::nullopt;
        if (holdsMuchAir(group) || endsInAir(group, cluster, floor)) return std::nullopt;
        if (!comesAfterWhatItWaitsFor(group)) return std::nullopt;
        const Region kept = intersect(group.target, floor.shadow, tol_);
        if (!isSliver(kept, tol_)) return std::nullopt;
        if (!kept.empty()) group.target = subtract(group.target, floor.shadow, tol_);
        return group;
    }

    /// Air between the layer and the lowest of the groups above it [mm].
    double gapOver(const Layer& layer, const std::vector<int>& above) const {
        double lowest_mm = std::numeric_limits<double>::infinity();
        for (const int group : above)
            lowest_mm = std::min(lowest_mm, bottomLayer(groups_[group]).bottom_z_mm);
        return lowest_mm - layer.top_z_mm;
    }

    /// Behind air a hole alone goes on.
    double longestGapMm(const Cluster& cluster) const {
        double narrowest_mm = std::numeric_limits<double>::infinity();
        for (const int index : cluster.components) {
            const int hole = forest_.components[index].hole;
            if (hole < 0) return kNoGapMm;
            narrowest_mm = std::min(narrowest_mm, 2 * radiusOfCircles(forest_.components[hole].region));
        }
        return kLongestGapDiameters * narrowest_mm;
    }

    double volumeOf(const std::vector<int>& components) const {
        double volume_mm3 = 0;
        for (const int index : components)
            volume_mm3 += volumeMm3(forest_.components[index], layers_);
        return volume_mm3;
    }

    bool holdsMuchAir(const FeatureGroup& group) const {
        const double height_mm = topLayer(group).top_z_mm - bottomLayer(group).bottom_z_mm;
        return volumeOf(group.components) < (1 - kMostAirShare) * area(group.target) * height_mm;
    }

    /// Do crumbs that an earlier setup left lead the group down through what it has cut?
    bool endsInAir(const FeatureGroup& group, const Cluster& cluster, const Layer& floor) const {
        const double ground_mm3 = area(group.target) * floor.height_mm();
        const double air_mm3 = ground_mm3 - volumeOf(cluster.components);
        return air_mm3 > kNextToAllShare * ground_mm3 &&
               air_mm3 > kMuchForTheFeature * volumeOf(group.components);
    }

    /// Groups have the order of their first components.
    bool comesAfterWhatItWaitsFor(const FeatureGroup& group) const {
        for (const int member : group.components)
            for (const int parent : forest_.components[member].parents)
                if (!isMember(group, parent) &&
                    groups_[group_of_[parent]].components.front() > group.components.front())
                    return false;
        return true;
    }

    /// What else of the stock stands over the group's ground, from its floor to its top.
    std::optional<int> otherOver(const FeatureGroup& group) const {
        const Box2 box = boundingBox(group.target);
        const int top = forest_.components[group.components.front()].layer;
        const int bottom = forest_.components[group.components.back()].layer;
        for (int layer = top; layer <= bottom; ++layer)
            for (const int other : forest_.of_layer[layer]) {
                if (isMember(group, other)) continue;
                const Region& region = forest_.components[other].region;
                if (box.intersects(boundingBox(region)) &&
                    !isSliver(intersect(group.target, region, tol_), tol_))
                    return other;
            }
        return std::nullopt;
    }

    static bool isMember(const FeatureGroup& group, int index) {
        return std::binary_search(group.components.begin(), group.components.end(), index);
    }

    const Layer& topLayer(const FeatureGroup& group) const {
        return layers_.layers[forest_.components[group.components.front()].layer];
    }
    const Layer& bottomLayer(const FeatureGroup& group) const {
        return layers_.layers[forest_.components[group.components.back()].layer];
    }

    const RemovalForest& forest_;
    const LayerStack& layers_;
    const Tolerances& tol_;
    std::vector<FeatureGroup> groups_;  ///< empty once joined to another
    std::vector<int> group_of_;         ///< by component, -1: none
};

}  // namespace

std::vector<FeatureGroup> featureGroups(const RemovalForest& forest, const LayerStack& layers,
                                        const Tolerances& tol) {
    return Grouper(forest, layers, tol).run();
}

}  // namespace stepmill::feature
