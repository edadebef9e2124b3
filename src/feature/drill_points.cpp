#include "feature/drill_points.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/units.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/layers/hole_cone.h"

namespace stepmill::feature {
namespace {

/// Point angles of drills [deg].
constexpr double kLeastPointDeg = 80;
constexpr double kMostPointDeg = 160;
/// Axes and heights that belong together differ by no more than merged levels do [mm].
constexpr double kSameMm = 5e-3;

bool isDrillPoint(const FaceTrace& trace) {
    if (trace.cause != SlopeCause::DrillPoint || !trace.axis_point) return false;
    const double depth_mm = trace.top_z_mm - trace.bottom_z_mm;
    if (depth_mm <= 0 || 2 * trace.radius_mm > kWidestHoleConeMm) return false;
    const double angle_deg = radToDeg(2 * std::atan2(trace.radius_mm, depth_mm));
    return angle_deg >= kLeastPointDeg && angle_deg <= kMostPointDeg;
}

bool holds(const DrillPoint& point, const RemovalComponent& component, const Layer& layer) {
    if (layer.top_z_mm > point.top_z_mm + kSameMm || layer.bottom_z_mm < point.apex_z_mm - kSameMm)
        return false;
    const Box2 box = boundingBox(component.region);
    const Vec2 reach = Vec2::Constant(point.radius_mm + kSameMm);
    return ((box.min() - point.axis).array() >= -reach.array()).all() &&
           ((box.max() - point.axis).array() <= reach.array()).all();
}

}  // namespace

std::vector<DrillPoint> drillPoints(const LayerStack& layers) {
    std::vector<DrillPoint> points;
    for (const FaceTrace& trace : layers.traces) {
        if (!isDrillPoint(trace)) continue;
        const bool known = std::any_of(points.begin(), points.end(), [&](const DrillPoint& point) {
            return (point.axis - *trace.axis_point).norm() <= kSameMm &&
                   std::abs(point.apex_z_mm - trace.bottom_z_mm) <= kSameMm;
        });
        if (!known) points.push_back({*trace.axis_point, trace.radius_mm, trace.top_z_mm, trace.bottom_z_mm});
    }
    return points;
}

void markDrillPoints(RemovalForest& forest, const LayerStack& layers, const std::vector<DrillPoint>& points) {
    if (points.empty()) return;
    for (RemovalComponent& component : forest.components) {
        const Layer& layer = layers.layers[component.layer];
        component.in_drill_point = std::any_of(points.begin(), points.end(), [&](const DrillPoint& point) {
            return holds(point, component, layer);
        });
        component.left = component.left || component.in_drill_point;
    }
    dropLeft(forest);
}

double pointUnder(const Feature& hole, const std::vector<DrillPoint>& points, const Tolerances& tol) {
    if (hole.feature_class != FeatureClass::HoleBlind) return 0;
    const Vec2 axis = holeCentres(hole).front();
    for (const DrillPoint& point : points) {
        if ((point.axis - axis).norm() > kSameMm) continue;
        if (std::abs(point.radius_mm - holeRadiusMm(hole)) > kSameMm) continue;
        // Where the floor lies a little over the cone, the true wall goes on: a cone from the floor is safe.
        const double over_mm = hole.floor_z_mm - point.top_z_mm;
        if (over_mm < -tol.gouge_mm / 2 || over_mm > kSameMm) continue;
        return hole.floor_z_mm - point.apex_z_mm;
    }
    return 0;
}

}  // namespace stepmill::feature
