#pragma once

#include <vector>

#include <gp_Trsf.hxx>
#include <HLRAlgo_Projector.hxx>
#include <TopoDS_Shape.hxx>

#include "stepmill/part/part.h"
#include "stepmill/planar/vector.h"

namespace stepmill::report {

using Polyline = std::vector<Vec2>;

/// Sharp edges and outlines of a solid in the plane of a view; smooth edges are left out.
struct Lines {
    std::vector<Polyline> visible;
    std::vector<Polyline> hidden;
};

/// Of the solid's facets: exact surfaces take seconds where two cylinders cross.
/// \pre the solid has facets
Lines hiddenLines(const TopoDS_Shape& solid, const HLRAlgo_Projector& projector, double deflection_mm);

/// A rigid motion as the kernel takes it.
gp_Trsf toTrsf(const Eigen::Isometry3d& transform);

/// The solid as it stands in the setup: a copy, since meshing writes into the shape and the part is shared.
TopoDS_Shape solidIn(const PartShape& shape, const Eigen::Isometry3d& part_to_setup);
TopoDS_Shape solidIn(const Part& part, const Eigen::Isometry3d& part_to_setup);

}  // namespace stepmill::report
