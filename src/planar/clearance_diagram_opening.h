#pragma once

#include <vector>

#include "planar/clearance_diagram_trace.h"
#include "stepmill/core/tolerances.h"

namespace stepmill::clearance {

/// The area a disc sweeps whose centre runs along and within the traced loops, built from the contacts of
/// the disc with the boundary: the pieces of wall it touches, as they are, joined by arcs about the joints.
///
/// On both sides of a narrow neck such arcs can cross. Then the loops overlap themselves, and what they wind
/// around at least once is the area.
Region sweptByContacts(const SiteSet& set, const std::vector<TracedLoop>& loops, double radius_mm,
                       const Tolerances& tol);

}  // namespace stepmill::clearance
