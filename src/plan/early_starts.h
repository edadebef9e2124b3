#pragma once

#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// An operation with what tells whether others may run before it.
struct BandOperation {
    const Operation* operation = nullptr;
    ToolAssembly tool;  ///< set out as far as the operation needs
    Region cleared;     ///< of its band's target, down to its floor
};

/// The operations of one band, in their order.
struct BandOperations {
    const PlannedFeature* planned = nullptr;
    std::vector<BandOperation> operations;
    bool plain_ways = false;         ///< FeatureCaution::plain_ways
    std::optional<Feature> grown{};  ///< the band on the grown stock; nothing: as it is planned

    const Feature& feature() const { return grown ? *grown : planned->feature; }
};

/// What each operation of a band waits for; an empty entry waits for all that stands above it.
using BandStarts = std::vector<std::vector<Wait>>;

/// How far the bands above must be cut before each operation of a lower band may run: a wide cutter goes down
/// all bands before a narrow one comes for their corners.
///
/// An operation waits for those of a band above until what then still stands there is out of the way of its
/// cutter, shank and holder on every move, with a tool that is set out no farther than it needs.
///
/// \param bands  of one feature, from above
/// \return  of every band; entries are empty on the first, and on and below a band that has no operation or
///          takes plain ways
/// \note  O(operations x bands x moves x log edges)
std::vector<BandStarts> earlyStarts(const std::vector<BandOperations>& bands, const Tolerances& tol);

}  // namespace stepmill
