#pragma once

#include "stepmill/access/access.h"

namespace stepmill::access {

/// What a disc sweeps while its centre goes everywhere in `centres`: offset(centres, radius). Each component
/// is grown by itself and the results united, so that discs of different components that meet across a neck
/// are a matter of the Boolean alone.
Region swept(const Region& centres, double radius_mm, const Tolerances& tol);

/// Centres within this of their region's both walls get no pass, so what only they sweep stays.
inline double halfSliverMm(const Tolerances& tol) {
    return tol.sliver_mm / 2;
}

/// What a tool's passes sweep for sure: of its centres only what a disc of half a sliver opens, and nothing
/// that was given up. Where a neck runs out to the tool's own width the rest is several hundredths of a
/// millimetre long.
Region sweptForSure(const AccessibleArea& area, const Tolerances& tol);

}  // namespace stepmill::access
