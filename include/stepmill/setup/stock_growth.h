#pragma once

#include <optional>

#include "stepmill/planar/region.h"
#include "stepmill/setup/setup.h"

namespace stepmill {

/// How much larger than it is said to be the stock of a setup may be, in setup coordinates. Rapids, entries,
/// shank and holder count on the stock so grown; what the plan must clear is the stock as said.
struct StockGrowth {
    double side_mm = 0;  ///< raw sides may stand out so far
    double top_mm = 0;   ///< the top may stand so far above z = 0; 0 where an earlier setup has cut it
    /// The raw sides where they are upright: what is extra lies outside this box. Nothing where sides lean or
    /// the stock is no box: then beside all that stands.
    std::optional<Box2> raw_sides_mm;

    bool any() const { return side_mm > 0 || top_mm > 0; }
};

/// The growth of a stock in a setup by its tolerance.
/// \param stock  kind, raw box and tolerance alone
StockGrowth growthOf(const Stock& stock, const Eigen::Isometry3d& part_to_setup);

}  // namespace stepmill
