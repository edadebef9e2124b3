#pragma once

#include <TopoDS_Shape.hxx>

#include "stepmill/setup/in_process.h"

namespace stepmill::setup {

/// The prism as solids with true arcs, one for each component of its region, in part coordinates.
/// \throws Standard_Failure if a loop makes no wire
TopoDS_Shape prismSolid(const Prism& prism, const Eigen::Isometry3d& part_to_setup);

}  // namespace stepmill::setup
