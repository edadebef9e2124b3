#include "stepmill/feature/measure.h"

#include <algorithm>
#include <cmath>

#include "feature/boundary.h"
#include "feature/wall_thickness.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill {
namespace {

/// Radii closer than this are one [mm].
constexpr double kSameRadiusMm = 1e-3;

std::vector<double> cornerRadii(const Feature& feature) {
    std::vector<double> radii;
    for (const BoundaryPiece& piece : feature.boundary) {
        if (piece.open) continue;
        for (const Segment& segment : piece.path.segments)
            if (segment.arc && segment.arc->ccw) radii.push_back(segment.arc->radius_mm);
    }
    std::sort(radii.begin(), radii.end());
    radii.erase(
        std::unique(radii.begin(), radii.end(), [](double a, double b) { return b - a <= kSameRadiusMm; }),
        radii.end());
    return radii;
}

/// Lean of the feature's walls and rounds at its floor, from its faces.
void measureFaces(FeatureMeasures& measures, const Feature& feature, const FaceGraph& graph,
                  const Vec3& axis) {
    for (const int index : feature.faces) {
        const FaceShape& face = graph.faces[index];
        const bool along = face.axis.cross(axis).norm() < 1e-4;
        if ((face.surface == "cylinder" && !along) || face.surface == "torus" || face.surface == "sphere") {
            if (face.hollow) measures.floor_fillet_mm = std::max(measures.floor_fillet_mm, face.radius_mm);
            continue;
        }
        if (face.surface != "plane" && face.surface != "cone") continue;
        for (const FaceSample& sample : face.samples) {
            const double lean = radToDeg(std::asin(std::clamp(sample.normal.dot(axis), -1.0, 1.0)));
            if (lean > 1e-3 && lean <= kMostDraftDeg) measures.draft_deg = std::max(measures.draft_deg, lean);
        }
    }
}

/// Necks between walls; where an open edge is one side a cutter gets by outside.
std::vector<Neck> necksOf(const Feature& feature, const ClearanceDiagram& diagram, const Tolerances& tol) {
    std::vector<Neck> necks;
    for (const ClearanceEvent& event : diagram.events()) {
        if (event.kind != ClearanceEvent::Kind::Neck) continue;
        const bool open =
            std::any_of(feature.boundary.begin(), feature.boundary.end(), [&](const BoundaryPiece& piece) {
                return piece.open && distanceTo(event.at, piece.path) <= event.radius_mm + tol.sliver_mm;
            });
        if (!open) necks.push_back({2 * event.radius_mm, event.at});
    }
    return necks;
}

}  // namespace

FeatureMeasures measureFeature(const Feature& feature, const LayerStack& layers, const FaceGraph& graph,
                               const Eigen::Isometry3d& part_to_setup, const Tolerances& tol) {
    FeatureMeasures measures;
    const ClearanceDiagram diagram(feature.target, tol);
    if (const auto disc = diagram.largestInscribedDisc()) measures.width_mm = 2 * disc->radius_mm;
    if (measures.width_mm > 0) measures.depth_to_width = feature.depth_mm() / measures.width_mm;
    measures.necks = necksOf(feature, diagram, tol);
    measures.corner_radii_mm = cornerRadii(feature);
    measures.sharp_corner = feature::hasSharpCorner(feature.boundary);
    measures.wall = feature::thinnestWall(feature, layers, tol);
    measureFaces(measures, feature, graph, part_to_setup.linear().transpose() * Vec3::UnitZ());
    return measures;
}

}  // namespace stepmill
