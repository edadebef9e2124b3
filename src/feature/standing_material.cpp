#include "feature/standing_material.h"

#include <algorithm>

#include "stepmill/feature/region_compare.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::feature {

StandingMaterial::StandingMaterial(const LayerStack& layers, const RemovalForest& forest,
                                   const Tolerances& tol)
    : layers_(layers), forest_(forest), tol_(tol) {}

namespace {

/// Less of a component than this share is rounding: it holds nothing but air.
constexpr double kAirShare = 0.01;

bool standsForGood(const RemovalComponent& component) {
    return component.left && component.stock_share >= kAirShare;
}

}  // namespace

bool StandingMaterial::walledIn(int layer, const std::vector<int>& removed) const {
    bool any = false;
    for (const int index : forest_.of_layer[layer]) {
        if (!std::binary_search(removed.begin(), removed.end(), index)) continue;
        if (forest_.components[index].open) return false;
        any = true;
    }
    return any;
}

std::vector<int> StandingMaterial::inTheWay(int layer, const std::vector<int>& removed) const {
    std::vector<int> found;
    std::vector<bool> covered(forest_.components.size(), false);
    for (int above = 0; above <= layer; ++above) {
        if (walledIn(above, removed)) continue;
        for (const int index : forest_.of_layer[above]) {
            const RemovalComponent& component = forest_.components[index];
            if (!component.open || component.left ||
                std::binary_search(removed.begin(), removed.end(), index))
                continue;
            covered[index] = true;
            // Seen from above, what lies under a component already found adds nothing.
            if (component.inside_parent && covered[component.parents.front()]) continue;
            found.push_back(index);
        }
    }
    return found;
}

const SharedRegion& StandingMaterial::ground(int layer) {
    // From the top down, each layer on the one above: what was left there stands over this one too.
    while (static_cast<int>(grounds_.size()) <= layer) {
        const int next = static_cast<int>(grounds_.size());
        const Region& shadow = layers_.layers[next].shadow;
        std::vector<Region> regions{shadow};
        for (const int index : forest_.of_layer[next])
            if (standsForGood(forest_.components[index])) regions.push_back(forest_.components[index].region);
        leaves_.push_back(regions.size() > 1 || (next > 0 && leaves_.back()));
        if (next > 0 && leaves_[next - 1]) regions.push_back(grounds_.back());
        grounds_.emplace_back(regions.size() > 1 ? unite(regions, tol_) : shadow);
    }
    return grounds_[layer];
}

const SharedRegion& StandingMaterial::above(int layer, const std::vector<int>& removed) {
    return united(layer, inTheWay(layer, removed));
}

const SharedRegion& StandingMaterial::united(int layer, std::vector<int> standing) {
    if (standing.empty()) return ground(layer);
    const auto [entry, is_new] = known_.try_emplace({layer, standing});
    if (!is_new) return entry->second;
    std::vector<Region> regions{ground(layer)};
    while (!standing.empty() && forest_.components[standing.back()].layer == layer) {
        regions.push_back(forest_.components[standing.back()].region);
        standing.pop_back();
    }
    // What stands in the layers above is known already, mostly from a feature before.
    if (layer > 0) regions.push_back(united(layer - 1, std::move(standing)));
    entry->second = unite(regions, tol_);
    return entry->second;
}

std::vector<Obstacle> StandingMaterial::obstacles(int layer, const std::vector<int>& removed) {
    std::vector<Obstacle> found;
    for (int i = layer; i >= 0; --i) {
        const SharedRegion& section = above(i, removed);
        if (section.empty()) continue;
        const Layer& slab = layers_.layers[i];
        if (!found.empty() && identical(found.back().section, section))
            found.back().top_z_mm = slab.top_z_mm;
        else
            found.push_back({slab.bottom_z_mm, slab.top_z_mm, section});
    }
    return found;
}

}  // namespace stepmill::feature
