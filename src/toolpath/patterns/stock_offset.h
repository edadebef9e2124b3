#pragma once

#include <optional>

#include "toolpath/patterns/ring_family.h"

namespace stepmill::toolpath {

/// Rings that follow the outer boundary inwards and take islands in when they meet them [Li2001, 4.2]:
/// their walls are then cut on their own, and the next ring follows both.
///
/// Nothing for a component without islands, where that is contour-parallel from outside in.
std::optional<RingFamily::Variant> stockOffset(const RingFamily::Component& component, double step_over_mm,
                                               const Tolerances& tol);

}  // namespace stepmill::toolpath
