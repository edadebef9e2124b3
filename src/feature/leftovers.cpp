// What earlier setups left and is not worth a pass in this one.

#include "feature/leftovers.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "stepmill/core/groups.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"

namespace stepmill::feature {
namespace {

/// Lumps that finish no face pay from this share of what all setups remove: half of what pays for a setup.
constexpr double kLumpShare = 2.5e-3;
/// Crumbs on faces: less is no pass for any cutter, as a share and ...
constexpr double kCrumbShare = 2e-5;
/// ... as a volume [mm3]: what is listed, but not worth a warning when it stays.
constexpr double kCrumbMm3 = 1;
/// A cut finishes a wall when this share of the wall it runs along stands upright, ...
constexpr double kUprightShare = 0.5;
/// ... and a floor when this share of its area lies on one.
constexpr double kFloorShare = 0.3;
/// A cutter that fits an inner fillet of radius r reaches about five diameters deep: what lies deeper is left
/// to the setup in which the fillet is one of a floor.
constexpr double kReachRadii = 10;
/// A component of which less than this is stock half-way up its slab is skin of the slab's hull.
constexpr double kSkinShare = 0.5;
/// A lump that finishes less than this share of every face it touches is what cutters left in passing; it
/// then pays from kLumpShare, too.
constexpr double kFaceShare = 0.6;
/// A component with this share of its outline on upright walls plugs a hole or a slot: nobody leaves that in
/// passing, however little of the face it finishes.
constexpr double kPlugShare = 0.9;
/// Probes on the boundary are as far apart as edges are long; no wall is farther from them [mm].
constexpr double kOnWallMm = 0.01;

/// What a component, or a lump of them, finishes: [mm2] by face, and whether that is what it is there for.
struct Finished {
    bool any = false;
    bool plug = false;
    std::map<int, double> area_mm2;

    void add(const Finished& more) {
        any = any || more.any;
        plug = plug || more.plug;
        for (const auto& [face, more_mm2] : more.area_mm2)
            area_mm2[face] += more_mm2;
    }
};

/// Of a wall or floor.
double areaOf(const FaceTrace& trace) {
    if (trace.stand == FaceStand::Floor) return area(trace.region);
    return length(trace.footprint) * (trace.top_z_mm - trace.bottom_z_mm);
}

struct Wall {
    const FaceTrace* trace = nullptr;
    Box2 box;
};

class Judge {
  public:
    Judge(const LayerStack& layers, const Tolerances& tol) : layers_(layers), tol_(tol) {
        for (const FaceTrace& trace : layers.traces) {
            if (trace.stand == FaceStand::Wall && !trace.footprint.segments.empty())
                walls_.push_back({&trace, grown(boundingBox(trace.footprint), kOnWallMm)});
        }
    }

    /// Share of the component that is stock half-way up its slab, whose walls may lean.
    double stockShare(const RemovalComponent& component) const {
        const Layer& layer = layers_.layers[component.layer];
        if (layer.stock_air_mm3 <= 0) return 1;
        return area(intersect(component.region, layer.stock_half_way, tol_)) / component.area_mm2;
    }

    /// What of the part's faces a component finishes; skin finishes none.
    Finished finished(const RemovalComponent& component) const {
        if (component.stock_share < kSkinShare) return {};
        Finished walls = finishedWalls(component);
        const Finished floors = finishedFloors(component);
        walls.add(floors);
        return walls;
    }

    /// Does a lump finish enough of some face to be worth a pass?
    bool isWorth(const Finished& lump) const {
        const auto is_most = [&](const auto& entry) {
            return entry.second >= kFaceShare * areaOf(layers_.traces[entry.first]);
        };
        return lump.plug || std::any_of(lump.area_mm2.begin(), lump.area_mm2.end(), is_most);
    }

  private:
    static bool isDeepFillet(const FaceTrace& wall, double bottom_mm) {
        const bool fillet = wall.hollow && wall.radius_mm > 0 && !wall.footprint.closed();
        return fillet && wall.top_z_mm - bottom_mm > kReachRadii * wall.radius_mm;
    }

    /// The upright face of the part that spans the layer's middle and stands here.
    const FaceTrace* uprightAt(const Vec2& p, const Layer& layer) const {
        const double z_mm = layer.middle_z_mm();
        const auto found = std::find_if(walls_.begin(), walls_.end(), [&](const Wall& wall) {
            if (z_mm > wall.trace->top_z_mm || z_mm < wall.trace->bottom_z_mm) return false;
            if (isDeepFillet(*wall.trace, layer.bottom_z_mm)) return false;
            if ((p.array() < wall.box.min().array()).any() || (p.array() > wall.box.max().array()).any())
                return false;
            return distanceTo(p, wall.trace->footprint) <= kOnWallMm;
        });
        return found == walls_.end() ? nullptr : found->trace;
    }

    Finished finishedWalls(const RemovalComponent& component) const {
        const Layer& layer = layers_.layers[component.layer];
        Finished finished;
        double upright_mm = 0;
        double closed_mm = 0;
        double outline_mm = 0;
        for (const auto& [from, segment] : eachEdge(component.region)) {
            const Vec2 probe = pointAt(from, segment, 0.5);
            const double long_mm = length(from, segment);
            outline_mm += long_mm;
            if (distanceToBoundary(layer.shadow, probe) > tol_.sliver_mm) continue;
            closed_mm += long_mm;
            const FaceTrace* wall = uprightAt(probe, layer);
            if (wall == nullptr) continue;
            upright_mm += long_mm;
            finished.area_mm2[wall->face] += long_mm * layer.height_mm();
        }
        finished.any = closed_mm > 0 && upright_mm >= kUprightShare * closed_mm;
        finished.plug = upright_mm >= kPlugShare * outline_mm;
        return finished;
    }

    Finished finishedFloors(const RemovalComponent& component) const {
        Finished finished;
        const double z_mm = layers_.layers[component.layer].bottom_z_mm;
        double on_mm2 = 0;
        const Box2 box = boundingBox(component.region);
        for (const FaceTrace& trace : layers_.traces) {
            if (trace.stand != FaceStand::Floor || std::abs(trace.top_z_mm - z_mm) > tol_.gouge_mm) continue;
            if (!boundingBox(trace.region).intersects(box)) continue;
            const double covered_mm2 = area(intersect(component.region, trace.region, tol_));
            on_mm2 += covered_mm2;
            finished.area_mm2[trace.face] += covered_mm2;
        }
        finished.any = on_mm2 >= kFloorShare * component.area_mm2;
        return finished;
    }

    const LayerStack& layers_;
    const Tolerances& tol_;
    std::vector<Wall> walls_;
};

/// Volumes of lumps of the components that are wanted, or of those that are not, at their first component.
/// \param lumps  each component its own; joined as they lie over each other
std::vector<double> lumpVolumes(const RemovalForest& forest, const LayerStack& layers,
                                const std::vector<bool>& is_wanted, bool which, Groups& lumps) {
    const int count = static_cast<int>(forest.components.size());
    for (int i = 0; i < count; ++i) {
        for (const int child : forest.components[i].children)
            if (is_wanted[i] == which && is_wanted[child] == which) lumps.join(i, child);
    }
    std::vector<double> volumes(forest.components.size(), 0);
    for (int i = 0; i < count; ++i) {
        const RemovalComponent& component = forest.components[i];
        if (is_wanted[i] == which && component.stock_share >= kSkinShare)
            volumes[lumps.of(i)] += volumeMm3(component, layers);
    }
    return volumes;
}

/// A drill goes on through what is left right below its hole where that ends in another one, if the part
/// leaves all of it free there.
void keepUnderHoles(RemovalForest& forest, const LayerStack& layers, const Tolerances& tol) {
    for (RemovalComponent& component : forest.components) {
        if (!component.left || component.hole < 0) continue;
        const bool goes_on = std::any_of(component.parents.begin(), component.parents.end(), [&](int parent) {
            const RemovalComponent& over = forest.components[parent];
            return !over.left && over.layer + 1 == component.layer;
        });
        if (!goes_on) continue;
        const Region& hole = forest.components[component.hole].region;
        const Region& shadow = layers.layers[component.layer].shadow;
        component.left = !isSliver(intersect(hole, shadow, tol), tol);
    }
}

}  // namespace

void markLeftovers(RemovalForest& forest, const LayerStack& layers, const Tolerances& tol) {
    if (!layers.stock_cut_before) return;
    const int count = static_cast<int>(forest.components.size());
    const Judge judge(layers, tol);
    // From below: what lies over a component that is wanted has to go as well.
    std::vector<bool> wanted(forest.components.size(), false);
    std::vector<Finished> finished(forest.components.size());
    for (RemovalComponent& component : forest.components)
        component.stock_share = judge.stockShare(component);
    for (int i = count; i-- > 0;) {
        const RemovalComponent& component = forest.components[i];
        finished[i] = judge.finished(component);
        wanted[i] = finished[i].any || std::any_of(component.children.begin(), component.children.end(),
                                                   [&](int child) { return wanted[child]; });
    }
    for (const bool which : {true, false}) {
        Groups lumps(forest.components.size());
        const std::vector<double> volumes = lumpVolumes(forest, layers, wanted, which, lumps);
        std::map<std::size_t, Finished> finished_by_lump;
        for (int i = 0; which && i < count; ++i)
            if (wanted[i]) finished_by_lump[lumps.of(i)].add(finished[i]);
        for (int i = 0; i < count; ++i) {
            if (wanted[i] != which) continue;
            const std::size_t lump = lumps.of(i);
            const bool finishes = which && judge.isWorth(finished_by_lump[lump]);
            const double least_mm3 = finishes ? std::max(kCrumbMm3, kCrumbShare * layers.removable_mm3)
                                              : kLumpShare * layers.removable_mm3;
            if (volumes[lump] < least_mm3) forest.components[i].left = true;
        }
    }
    keepUnderHoles(forest, layers, tol);
    // A crumb over a lump that stays in would be cut with it.
    for (int i = count; i-- > 0;) {
        RemovalComponent& component = forest.components[i];
        if (std::any_of(component.children.begin(), component.children.end(),
                        [&](int child) { return !forest.components[child].left; }))
            component.left = false;
    }
    dropLeft(forest);
}

}  // namespace stepmill::feature
