#pragma once

#include "stepmill/planar/edge_index.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// Is some point of one region nearer than that to the other [mm]? False where one of them is empty. Where
/// few edges of the other are near it is much cheaper than an offset.
/// \param edges_of_one  its boundary
bool isNearer(const Region& one, const EdgeIndex& edges_of_one, const Region& other, double distance_mm);

}  // namespace stepmill
