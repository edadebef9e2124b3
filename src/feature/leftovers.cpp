// What earlier setups left and is not worth a pass in this one.

#include "feature/leftovers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "stepmill/planar/boolean.h"

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
/// Probes on the boundary are as far apart as edges are long; no wall is farther from them [mm].
constexpr double kOnWallMm = 0.01;

struct Wall {
    const FaceTrace* trace = nullptr;
    Box2 box;
};

class Judge {
  public:
    Judge(const LayerStack& layers, const Tolerances& tol) : layers_(layers), tol_(tol) {
        for (const FaceTrace& trace : layers.traces) {
            if (trace.stand == FaceStand::Wall && !trace.footprint.segments.empty())
                walls_.push_back({&trace, boundingBox(trace.footprint).grown(kOnWallMm)});
        }
    }

    bool finishes(const RemovalComponent& component) const {
        return finishesWall(component) || finishesFloor(component);
    }

  private:
    /// Does an upright face of the part that spans the layer's middle stand here?
    bool onUpright(const Vec2& p, double z_mm) const {
        return std::any_of(walls_.begin(), walls_.end(), [&](const Wall& wall) {
            if (z_mm > wall.trace->top_z_mm || z_mm < wall.trace->bottom_z_mm) return false;
            if ((p.array() < wall.box.min.array()).any() || (p.array() > wall.box.max.array()).any())
                return false;
            Vec2 from = wall.trace->footprint.start;
            for (const Segment& segment : wall.trace->footprint.segments) {
                if (distanceTo(p, from, segment) <= kOnWallMm) return true;
                from = segment.to;
            }
            return false;
        });
    }

    bool finishesWall(const RemovalComponent& component) const {
        const Layer& layer = layers_.layers[component.layer];
        const double middle = (layer.top_z_mm + layer.bottom_z_mm) / 2;
        double upright_mm = 0;
        double closed_mm = 0;
        for (const Loop& loop : component.region.loops) {
            Vec2 from = loop.start;
            for (const Segment& segment : loop.segments) {
                const Vec2 probe = pointAt(from, segment, 0.5);
                const double long_mm = length(from, segment);
                from = segment.to;
                if (distanceToBoundary(layer.shadow, probe) > tol_.sliver_mm) continue;
                closed_mm += long_mm;
                if (onUpright(probe, middle)) upright_mm += long_mm;
            }
        }
        return closed_mm > 0 && upright_mm >= kUprightShare * closed_mm;
    }

    bool finishesFloor(const RemovalComponent& component) const {
        const double z_mm = layers_.layers[component.layer].bottom_z_mm;
        double on_mm2 = 0;
        const Box2 box = boundingBox(component.region);
        for (const FaceTrace& trace : layers_.traces) {
            if (trace.stand != FaceStand::Floor || std::abs(trace.top_z_mm - z_mm) > tol_.gouge_mm) continue;
            if (boundingBox(trace.region).overlaps(box))
                on_mm2 += area(intersect(component.region, trace.region, tol_));
        }
        return on_mm2 >= kFloorShare * component.area_mm2;
    }

    const LayerStack& layers_;
    const Tolerances& tol_;
    std::vector<Wall> walls_;
};

/// Which lump each component belongs to, by its first component.
class Lumps {
  public:
    explicit Lumps(std::size_t count) : first_(count) { std::iota(first_.begin(), first_.end(), 0); }

    int of(int index) const {
        while (first_[index] != index)
            index = first_[index];
        return index;
    }
    void join(int a, int b) {
        a = of(a);
        b = of(b);
        first_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<int> first_;
};

/// Volumes of lumps of components of one kind, at their first component.
std::vector<double> lumpVolumes(const RemovalForest& forest, const LayerStack& layers,
                                const std::vector<bool>& kind, bool wanted, Lumps& lumps) {
    const int count = static_cast<int>(forest.components.size());
    for (int i = 0; i < count; ++i) {
        for (const int child : forest.components[i].children)
            if (kind[i] == wanted && kind[child] == wanted) lumps.join(i, child);
    }
    std::vector<double> volumes(forest.components.size(), 0);
    for (int i = 0; i < count; ++i) {
        const RemovalComponent& component = forest.components[i];
        if (kind[i] == wanted)
            volumes[lumps.of(i)] += component.area_mm2 * layers.layers[component.layer].height_mm();
    }
    return volumes;
}

}  // namespace

void markLeftovers(RemovalForest& forest, const LayerStack& layers, const Tolerances& tol) {
    if (!layers.stock_cut_before) return;
    const int count = static_cast<int>(forest.components.size());
    const Judge judge(layers, tol);
    // From below: what lies over a component that is wanted has to go as well.
    std::vector<bool> wanted(forest.components.size(), false);
    for (int i = count; i-- > 0;) {
        const RemovalComponent& component = forest.components[i];
        wanted[i] = std::any_of(component.children.begin(), component.children.end(),
                                [&](int child) { return wanted[child]; }) ||
                    judge.finishes(component);
    }
    for (const bool kind : {true, false}) {
        Lumps lumps(forest.components.size());
        const std::vector<double> volumes = lumpVolumes(forest, layers, wanted, kind, lumps);
        const double least_mm3 = kind ? std::max(kCrumbMm3, kCrumbShare * layers.removable_mm3)
                                      : kLumpShare * layers.removable_mm3;
        for (int i = 0; i < count; ++i)
            if (wanted[i] == kind && volumes[lumps.of(i)] < least_mm3) forest.components[i].left = true;
    }
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
