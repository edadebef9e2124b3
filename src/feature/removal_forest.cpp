#include "feature/removal_forest.h"

#include <algorithm>

#include "stepmill/feature/hole_group.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"

namespace stepmill::feature {
namespace {

/// Does an edge of the component run along the stock's boundary? Where it does the setup's stock ends, so
/// nothing stands on the other side.
bool touchesStockBoundary(const Region& component, const Region& stock, const Tolerances& tol) {
    for (const auto& [from, segment] : eachEdge(component))
        if (distanceToBoundary(stock, pointAt(from, segment, 0.5)) <= tol.sliver_mm) return true;
    return false;
}

void addLayer(RemovalForest& forest, const Layer& layer, int index, const Tolerances& tol) {
    forest.of_layer.emplace_back();
    forest.sliver_area_mm2.push_back(0);
    for (Region& region : components(subtract(layer.stock, layer.shadow, tol))) {
        const double area_mm2 = area(region);
        if (area_mm2 <= tol.area_mm2 || isSliver(region, tol)) {
            forest.sliver_area_mm2.back() += area_mm2;
            continue;
        }
        const bool open = touchesStockBoundary(region, layer.stock, tol);
        forest.of_layer.back().push_back(static_cast<int>(forest.components.size()));
        forest.components.push_back({index, std::move(region), area_mm2, open, false, false, -1, {}, {}, 1});
    }
}

/// A layer with the same stock and shadow as the one above removes the same components.
void repeatLayer(RemovalForest& forest, int index) {
    const std::vector<int> above = forest.of_layer.back();
    forest.of_layer.emplace_back();
    forest.sliver_area_mm2.push_back(forest.sliver_area_mm2.back());
    for (const int parent : above) {
        RemovalComponent component = forest.components[parent];
        component.layer = index;
        component.parents.clear();
        component.children.clear();
        forest.of_layer.back().push_back(static_cast<int>(forest.components.size()));
        forest.components.push_back(std::move(component));
    }
}

void link(RemovalForest& forest, int parent, int child) {
    forest.components[parent].children.push_back(child);
    forest.components[child].parents.push_back(parent);
}

void linkToParents(RemovalForest& forest, int child, const std::vector<int>& above, const Tolerances& tol) {
    RemovalComponent& component = forest.components[child];
    const auto twin = std::find_if(above.begin(), above.end(), [&](int parent) {
        return identical(forest.components[parent].region, component.region);
    });
    if (twin != above.end()) {
        component.inside_parent = true;
        return link(forest, *twin, child);
    }
    const Box2 box = boundingBox(component.region);
    double overlap_mm2 = 0;
    for (const int parent : above) {
        const Region& region = forest.components[parent].region;
        if (!box.intersects(boundingBox(region))) continue;
        const Region common = intersect(component.region, region, tol);
        if (area(common) <= tol.area_mm2 || isSliver(common, tol)) continue;
        overlap_mm2 += area(common);
        link(forest, parent, child);
    }
    component.inside_parent =
        component.parents.size() == 1 && component.area_mm2 - overlap_mm2 <= areaSlack(component.region, tol);
}

/// Lies the component in the hole?
bool isIn(const RemovalComponent& hole, const RemovalComponent& component, const Tolerances& tol) {
    return grown(boundingBox(hole.region), tol.sliver_mm).contains(boundingBox(component.region)) &&
           isSliver(subtract(component.region, hole.region, tol), tol);
}

/// Components that go on with a hole, by that; empty for those that are none.
using InHoles = std::vector<std::vector<int>>;

/// Links a component under air to the lowest ones of the hole over it.
void linkToHole(RemovalForest& forest, int index, const std::vector<int>& in_hole) {
    const int layer = forest.components[index].layer;
    int over = -1;
    for (auto member = in_hole.rbegin(); member != in_hole.rend(); ++member) {
        const int at = forest.components[*member].layer;
        if (at == layer) continue;
        if (over >= 0 && at != over) return;
        over = at;
        link(forest, *member, index);
    }
}

/// Finds the hole that a component goes on with. Where earlier setups left air over it, it goes on behind
/// that.
void findHole(RemovalForest& forest, int index, InHoles& holes, const Tolerances& tol) {
    RemovalComponent& component = forest.components[index];
    const std::vector<int>& parents = component.parents;
    if (parents.empty()) {
        for (int hole = 0; hole < index && component.hole < 0; ++hole)
            if (!holes[hole].empty() && isIn(forest.components[hole], component, tol)) component.hole = hole;
        if (component.hole >= 0) linkToHole(forest, index, holes[component.hole]);
    } else if (const int hole = forest.components[parents.front()].hole; hole >= 0) {
        const bool one = std::all_of(parents.begin(), parents.end(),
                                     [&](int parent) { return forest.components[parent].hole == hole; });
        if (one && isIn(forest.components[hole], component, tol)) component.hole = hole;
    }
    if (component.hole < 0 && isFullCircles(component.region)) component.hole = index;
    if (component.hole >= 0) holes[component.hole].push_back(index);
}

}  // namespace

double volumeMm3(const RemovalComponent& component, const LayerStack& layers) {
    return component.area_mm2 * layers.layers[component.layer].height_mm();
}

RemovalForest buildRemovalForest(const LayerStack& layers, const Tolerances& tol) {
    RemovalForest forest;
    for (std::size_t i = 0; i < layers.layers.size(); ++i) {
        const Layer& layer = layers.layers[i];
        const bool repeats = i > 0 && identical(layer.stock, layers.layers[i - 1].stock) &&
                             identical(layer.shadow, layers.layers[i - 1].shadow);
        if (repeats)
            repeatLayer(forest, static_cast<int>(i));
        else
            addLayer(forest, layer, static_cast<int>(i), tol);
        if (i == 0) continue;
        for (const int child : forest.of_layer[i])
            linkToParents(forest, child, forest.of_layer[i - 1], tol);
    }
    InHoles holes(forest.components.size());
    for (std::size_t i = 0; i < forest.components.size(); ++i)
        findHole(forest, static_cast<int>(i), holes, tol);
    return forest;
}

void dropLeft(RemovalForest& forest) {
    for (RemovalComponent& component : forest.components) {
        const auto other = [&](int index) { return forest.components[index].left != component.left; };
        std::erase_if(component.parents, other);
        std::erase_if(component.children, other);
    }
}

}  // namespace stepmill::feature
