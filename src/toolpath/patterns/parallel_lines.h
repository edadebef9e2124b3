#pragma once

#include <vector>

#include "toolpath/patterns/ring_family.h"

namespace stepmill::toolpath {

/// Parallel lines across the component at the best of several angles, and the rings along its walls that are
/// cut after them [Li2001, 4.1]. `wall_rings` are the component's rings of level 0.
///
/// The angles tried are those of the component's straight edges, the longest first, and kNamedAnglesDeg. The
/// best is the one whose lines and the links between neighbouring ones are shortest together.
/// No lines where the component is no wider than a step-over.
RingFamily::Variant zigzag(const RingFamily::Component& component,
                           const std::vector<RingFamily::Ring>& wall_rings, double step_over_mm);

/// The same lines, all run through in climb direction.
RingFamily::Variant oneWay(const RingFamily::Variant& zigzag);

/// The pieces of the lines of one depth, joined end to end where a line has one neighbour in the next row
/// and that neighbour no other [Li2001: a group between two contours]. Links run straight where `component`
/// lets them, else along the boundary of its line ground.
std::vector<Path> joinedLines(const RingFamily::Component& component, const RingFamily::Variant& variant,
                              const std::vector<RingFamily::Ring>& pieces, const Tolerances& tol);

}  // namespace stepmill::toolpath
