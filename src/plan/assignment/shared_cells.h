#pragma once

#include <cstddef>
#include <vector>

#include "stepmill/core/deadline.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/feature/feature.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/setup/setup.h"

namespace stepmill {

/// A band of the setup that comes first, with what its paths take.
struct EarlyBand {
    const Feature* feature = nullptr;
    double weight = 0;     ///< seconds, without tool changes
    bool drilled = false;  ///< a drill makes it, from one side
};

/// A band of a later setup as it would be if the earlier one cut nothing.
struct LateBand {
    std::size_t setup = 0;  ///< its place among all setups
    Eigen::Isometry3d part_to_setup = Eigen::Isometry3d::Identity();
    Feature feature;
    double weight = 0;  ///< seconds of its paths, without tool changes
};

/// A piece of removal that two setups reach: of one layer of the earlier one, in one band of each.
struct SharedCell {
    Prism prism;            ///< in the earlier setup's coordinates
    std::size_t early = 0;  ///< place of the earlier setup's band
    std::size_t late = 0;   ///< place of the later one's
    double early_weight = 0;
    double late_weight = 0;
    /// Cells under it that stay where it stays; without those that are under one of them.
    std::vector<std::size_t> below;
};

/// The cells of a setup, from above to below. Each has its share of its bands' weights, by volume; where
/// several later bands reach a place it is the one's that takes least for its volume.
///
/// No cell lies over what the setup alone must cut, drilled holes among it: a cutter from above would not get
/// there. Cells nowhere wider than kThinnestReserveMm are none: what stands must stand firmly.
/// \param layers  of the earlier setup, without a reserve
/// \throws Error(TimedOut) after the deadline
/// \note O(layers x bands of both + pairs of cells over one another) Booleans.
std::vector<SharedCell> sharedCells(const Setup& setup, const LayerStack& layers,
                                    const std::vector<EarlyBand>& early, const std::vector<LateBand>& late,
                                    const Deadline& deadline, const Tolerances& tol);

/// What stands for later setups must be this wide somewhere [mm].
inline constexpr double kThinnestReserveMm = 2;

/// The prisms of some of the cells, each as high as it stays the same.
std::vector<Prism> prismsOf(const std::vector<SharedCell>& cells, const std::vector<bool>& chosen,
                            const Tolerances& tol);

}  // namespace stepmill
