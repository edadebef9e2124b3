// Questions to a layer stack.

#include "stepmill/layers/layer_stack.h"

#include "stepmill/core/error.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"

namespace stepmill {

namespace {

/// Is one of the path's segments, at a quarter, half or three quarters of its length, within reach of the
/// other path?
bool runsAlong(const Path& path, const Path& other, double reach_mm) {
    for (const auto& [from, segment] : eachEdge(path)) {
        for (const double share : {0.25, 0.5, 0.75})
            if (distanceTo(pointAt(from, segment, share), other) <= reach_mm) return true;
    }
    return false;
}

}  // namespace

Region LayerStack::partAbove(double z_mm, const Tolerances& tol) const {
    // The shadow of a layer is the union of it and all above; the lowest layer that reaches above z has it.
    const Layer* lowest = nullptr;
    for (const Layer& layer : layers)
        if (layer.top_z_mm > z_mm + tol.linear_mm) lowest = &layer;
    return lowest ? lowest->shadow : Region{};
}

const Region& LayerStack::stockAt(double z_mm) const {
    STEPMILL_CHECK(!layers.empty(), "a layer stack has at least one layer");
    static const Region kNothing;
    if (z_mm > stock_top_z_mm || z_mm < stock_bottom_z_mm) return kNothing;
    for (const Layer& layer : layers)
        if (z_mm > layer.bottom_z_mm) return layer.stock;
    return layers.back().stock;
}

std::vector<int> LayerStack::wallsAlong(const Path& path, double top_z_mm, double bottom_z_mm,
                                        double reach_mm) const {
    std::vector<int> found;
    for (const FaceTrace& trace : traces) {
        if (trace.stand != FaceStand::Wall || trace.footprint.segments.empty()) continue;
        if (trace.bottom_z_mm >= top_z_mm || trace.top_z_mm <= bottom_z_mm) continue;
        if (!grown(boundingBox(trace.footprint), reach_mm).intersects(boundingBox(path))) continue;
        if (runsAlong(path, trace.footprint, reach_mm) || runsAlong(trace.footprint, path, reach_mm))
            found.push_back(trace.face);
    }
    return found;
}

std::vector<int> LayerStack::floorsUnder(const Region& region, double z_mm, double reach_mm,
                                         const Tolerances& tol) const {
    std::vector<int> found;
    for (const FaceTrace& trace : traces) {
        if (trace.stand != FaceStand::Floor || std::abs(trace.top_z_mm - z_mm) > reach_mm) continue;
        if (!boundingBox(trace.region).intersects(boundingBox(region))) continue;
        if (area(intersect(region, trace.region, tol)) > tol.area_mm2) found.push_back(trace.face);
    }
    return found;
}

}  // namespace stepmill
