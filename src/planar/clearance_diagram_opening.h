#pragma once

#include <optional>
#include <vector>

#include "planar/clearance_diagram_trace.h"

namespace stepmill::clearance {

/// The area a disc sweeps whose centre runs along and within the traced loops, built from the contacts of
/// the disc with the boundary: the pieces of wall it touches, as they are, joined by arcs about the joints.
///
/// Nothing if arcs cross each other, as they do on both sides of a narrow neck: then the pieces are right,
/// but not all of them bound the area.
std::optional<Region> sweptByContacts(const SiteSet& set, const std::vector<TracedLoop>& loops,
                                      double radius_mm);

}  // namespace stepmill::clearance
