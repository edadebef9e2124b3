#pragma once

#include "planar/clearance/profile.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill::clearance {

/// The graph of the discs that touch the boundary twice. Each of its edges comes from two pieces of the
/// profile.
MedialAxis medialAxisOf(const Profile& profile);

/// Necks and rooms of the graph, and the concave arcs whose centre lies on it.
std::vector<ClearanceEvent> eventsOf(const Profile& profile, const MedialAxis& axis);

}  // namespace stepmill::clearance
