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

/// Links the component to those of a layer above that it overlaps. \returns the area of that
double linkTo(RemovalForest& forest, int child, const std::vector<int>& above, const Tolerances& tol) {
    const RemovalComponent& component = forest.components[child];
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
    return overlap_mm2;
}

/// Lies the component in the hole?
bool isIn(const RemovalComponent& hole, const RemovalComponent& component, const Tolerances& tol) {
    return grown(boundingBox(hole.region), tol.sliver_mm).contains(boundingBox(component.region)) &&
           isSliver(subtract(component.region, hole.region, tol), tol);
}

/// The hole that a component goes on with, or begins.
int holeOf(const RemovalForest& forest, int index, const Tolerances& tol) {
    const RemovalComponent& component = forest.components[index];
    const auto parentsHole = [&](int parent) { return forest.components[parent].hole; };
    if (!component.parents.empty()) {
        const int hole = parentsHole(component.parents.front());
        const bool one = std::all_of(component.parents.begin(), component.parents.end(),
                                     [&](int parent) { return parentsHole(parent) == hole; });
        const bool in = hole >= 0 && one && isIn(forest.components[hole], component, tol);
        const bool narrower = in && isFullCircles(component.region) &&
                              !sameRegion(forest.components[hole].region, component.region, tol);
        if (in && !narrower) return hole;
    }
    return isFullCircles(component.region) ? index : -1;
}

/// Under air that earlier setups left, what goes on with a hole and what lies wholly under other components
/// has the next of these as its parents: no cutter gets to it before.
/// \pre the layer above has none
void linkThroughAir(RemovalForest& forest, int child, const Tolerances& tol) {
    RemovalComponent& component = forest.components[child];
    for (int layer = component.layer - 1; layer-- > 0;) {
        const double overlap_mm2 = linkTo(forest, child, forest.of_layer[layer], tol);
        if (component.parents.empty()) continue;
        const int hole = holeOf(forest, child, tol);
        const bool goes_on = hole >= 0 && hole != child;
        if (goes_on || component.area_mm2 - overlap_mm2 <= areaSlack(component.region, tol)) return;
        for (const int parent : component.parents)
            forest.components[parent].children.pop_back();
        component.parents.clear();
        return;
    }
}

void linkToParents(RemovalForest& forest, int child, const Tolerances& tol) {
    RemovalComponent& component = forest.components[child];
    const std::vector<int>& above = forest.of_layer[component.layer - 1];
    const auto twin = std::find_if(above.begin(), above.end(), [&](int parent) {
        return identical(forest.components[parent].region, component.region);
    });
    if (twin != above.end()) {
        component.inside_parent = true;
        return link(forest, *twin, child);
    }
    const double overlap_mm2 = linkTo(forest, child, above, tol);
    component.inside_parent =
        component.parents.size() == 1 && component.area_mm2 - overlap_mm2 <= areaSlack(component.region, tol);
    if (component.parents.empty()) linkThroughAir(forest, child, tol);
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
        for (const int index : forest.of_layer[i]) {
            if (i > 0) linkToParents(forest, index, tol);
            forest.components[index].hole = holeOf(forest, index, tol);
        }
    }
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
