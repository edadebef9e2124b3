#pragma once

#include <vector>

#include "stepmill/access/access.h"

namespace stepmill::access {

/// Where the axis may go in a slot as wide as the cutter, or in several that cross or meet.
struct SlotCentres {
    /// On into the air where a slot is open at an end, and straight on where another crosses it.
    std::vector<Path> middles;
    Region along;  ///< around the middles, as narrow as the fit tolerance leaves it
    Region strip;  ///< around the middles, wide enough to count: no pass runs at its edge
};

/// The slots that are as wide as the cutter, within the fit tolerance, and that its `usual` centres, those
/// wider than slivers, do not lead into.
/// \param narrow  the centres of a disc whose radius is as much less
std::vector<SlotCentres> slotCentres(const FeatureGround& ground, double radius_mm, const Region& usual,
                                     const Region& narrow);

/// The usual centres beside the slots' strips, without components from which a disc clears no more than from
/// the strips.
Region besideSlots(const FeatureGround& ground, double radius_mm, const Region& usual,
                   const std::vector<SlotCentres>& slots);

}  // namespace stepmill::access
