#include "report/page/faceted_part.h"

#include <BRepMesh_IncrementalMesh.hxx>

#include "report/page/hidden_lines.h"
#include "stepmill/part/part_shape.h"

namespace stepmill::report {
namespace {

/// How far facets may be off the part as a share of its diagonal, and how far they turn [rad].
constexpr double kChordShare = 4e-4;
constexpr double kFacetAngle = 0.2;

}  // namespace

FacetedPart facetedPart(const Part& part, double coarser) {
    FacetedPart faceted{part, {}};
    guardOcct(ErrorCode::GeometryKernel, "facets of " + part.name, [&] {
        faceted.solid = solidIn(part, Eigen::Isometry3d::Identity());
        const BRepMesh_IncrementalMesh mesh(faceted.solid,
                                            coarser * kChordShare * part.bbox_mm.diagonal().norm(), false,
                                            coarser * kFacetAngle);
    });
    return faceted;
}

}  // namespace stepmill::report
