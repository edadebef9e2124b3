#include "report/page/faceted_part.h"

#include "report/page/hidden_lines.h"
#include "stepmill/part/part_shape.h"

namespace stepmill::report {
namespace {

/// How far facets may be off the part as a share of its diagonal, and how far they turn [rad].
constexpr double kChordShare = 4e-4;
constexpr double kFacetAngle = 0.2;

}  // namespace

const TopoDS_Shape& FacetedPart::solid() const {
    if (!solid_.IsNull()) return solid_;
    guardOcct(ErrorCode::GeometryKernel, "facets of " + part_.name, [&] {
        TopoDS_Shape copy = solidIn(part_, Eigen::Isometry3d::Identity());
        const double size_mm = part_.bbox_mm.diagonal().norm();
        makeFacets(copy, coarser_ * kChordShare * size_mm, coarser_ * kFacetAngle);
        solid_ = copy;
    });
    return solid_;
}

}  // namespace stepmill::report
