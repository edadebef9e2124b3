#pragma once

#include "setup/reach_samples.h"

namespace stepmill::setup {

/// What the order of setups depends on.
struct SetupTraits {
    Vec3 axis = Vec3::UnitZ();
    bool indexed = false;
    double seat_mm2 = 0;         ///< flat faces of the part that look away from the spindle at its lowest
    bool seat_is_stock = false;  ///< they lie on the stock's own skin
};

/// Traits of an axis: where the part rests when the spindle comes along it.
SetupTraits traitsOf(const Facets& part_facets, const Stock& stock, const Vec3& axis);

/// What comes first of setups whose seats are ready.
enum class OrderBy {
    Volume,     ///< the one with most of what is left to it
    LeastSteps  ///< those that leave no steps on what a later one finishes; of these as by volume
};

/// The chosen axes in machining order: axes along the part's box before indexed ones; after the first, those
/// first whose seat is the stock's skin or machined by then; of these the one with most of what is left to
/// it, but of several within a tenth of that the one with the largest seat. A place is left to the chosen
/// axis that finishes it from the least depth.
///
/// \param chosen  indices of axes, in the order that decides where nothing else does
/// \param traits  by axis
std::vector<int> machiningOrder(const std::vector<SampleGroup>& groups, std::vector<int> chosen,
                                const std::vector<SetupTraits>& traits, OrderBy by = OrderBy::Volume);

/// Orders beside this one: opposite axes the other way round, and the second axis first; none in which an
/// indexed axis comes before one along the box, or more axes than now come before their seat is machined.
std::vector<std::vector<int>> otherOrders(const std::vector<int>& order,
                                          const std::vector<SetupTraits>& traits);

}  // namespace stepmill::setup
