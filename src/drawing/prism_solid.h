#pragma once

#include <vector>

#include <TopoDS_Shape.hxx>

#include "drawing/chain.h"

namespace stepmill::drawing {

/// An area of profiles: an outer one and those that are left out of it.
struct ProfileArea {
    Profile outer;
    std::vector<Profile> holes;
};

/// What is taken from the part: areas from its top down to a depth [mm].
struct Pocketing {
    std::vector<ProfileArea> areas;
    double depth_mm = 0;
};

/// The part: the outline's areas from z 0 down by the thickness, less all pocketings. What goes through goes
/// on below, and all goes on above, so that no two faces lie on each other.
/// \throws Error(GeometryKernel, InvalidSolid)
/// \pre depths above 0
TopoDS_Shape prismSolid(const std::vector<ProfileArea>& outline, double thickness_mm,
                        const std::vector<Pocketing>& pocketings, const std::string& file);

}  // namespace stepmill::drawing
