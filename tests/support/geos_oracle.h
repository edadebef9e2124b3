#pragma once

#include "stepmill/planar/region.h"

namespace stepmill::test {

/// Area of the region grown (distance > 0) or shrunk by GEOS' overlay [mm2]: the region with, or without, a
/// union of discs about its corners and strips along its edges, their arcs as chords of that sagitta which
/// enclose the same area as the arcs.
///
/// GEOS' own buffer is no oracle: it leaves out input vertices by up to a hundredth of the distance, which
/// moves areas by a percent where arcs meet.
double geosOffsetArea(const Region& region, double distance_mm, double chord_mm);

}  // namespace stepmill::test
