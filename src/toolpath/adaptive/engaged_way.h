#pragma once

#include <optional>

#include "stepmill/planar/indexed_region.h"
#include "stepmill/planar/region.h"
#include "toolpath/adaptive/front_meter.h"

namespace stepmill::toolpath {

/// Where a cutter goes that engages as much as it may.
struct EngagedWayTask {
    const FrontMeter& meter;    ///< of the cleared ground
    const IndexedRegion& room;  ///< centres that the cutter may go to
    Box2 within;                ///< it goes nowhere else
    double radius_mm = 0;
    double aim = 1;             ///< share of the limit
    double longest_mm = 0;      ///< a longer way is none
    Vec2 start = Vec2::Zero();  ///< on the boundary of the cleared centres
    Vec2 along = Vec2::Zero();  ///< direction to begin in
};

/// The way of a cutter that keeps as far to the right, into material, as its limit of engagement and the room
/// let it, from the start until it is back in cleared ground. Along the room's walls it runs a little
/// outside: clip it to the room. Of tangent arcs but for where it meets a wall.
/// \return  nothing where it does not come back within a length that its front cannot have
std::optional<Path> engagedWay(const EngagedWayTask& task);

}  // namespace stepmill::toolpath
