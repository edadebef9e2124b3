#include "stepmill/feature/describe_boundary.h"

#include "feature/boundary.h"
#include "feature/classify.h"

namespace stepmill {

void describeBoundary(Feature& feature, const Tolerances& tol) {
    feature.boundary = feature::boundaryPieces(feature.target, feature.obstruction, tol);
    feature.open_length_mm = feature.closed_length_mm = 0;
    for (const BoundaryPiece& piece : feature.boundary)
        (piece.open ? feature.open_length_mm : feature.closed_length_mm) += length(piece.path);
    feature.min_corner_radius_mm = feature::minCornerRadiusMm(feature.boundary);
    feature.feature_class = feature::classify(feature.target, feature.boundary, feature.through, tol);
}

}  // namespace stepmill
