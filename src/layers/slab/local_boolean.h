#pragma once

#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// A place where two regions differ: what each of them has there.
struct DifferentPlace {
    Region a;
    Region b;
    bool framed = false;  ///< both hold a frame around the place, since it lies inside both
};

/// Two regions that share most of their loops, as sections of neighbouring slabs do.
///
/// Loops equal to the last bit bound both regions and their union alike. Only where other loops lie is
/// there anything to compute, and each such place is independent of all others.
/// O(n log n + m n) for n loops of which m differ.
struct SharedLoops {
    std::vector<Loop> shared;  ///< equal in both and clear of every place
    std::vector<DifferentPlace> places;
};
SharedLoops compareLoops(const Region& a, const Region& b);

/// The union; in every place where one of the two covers the other, that one's loops stay as they are.
Region uniteLocally(const Region& a, const Region& b, const Tolerances& tol);

}  // namespace stepmill::layers
