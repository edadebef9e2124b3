#pragma once

#include <string>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"
#include "stepmill/setup/setup.h"

namespace stepmill {

/// An upright prism in setup coordinates.
struct Prism {
    Region region;
    double top_z_mm = 0;
    double bottom_z_mm = 0;

    double volume_mm3() const { return area(region) * (top_z_mm - bottom_z_mm); }
};

/// Sum of the prisms' volumes [mm3].
double volumeOf(const std::vector<Prism>& prisms);

/// A stock after a setup, and how sure it is.
struct StockAfter {
    Stock stock;
    /// Volume the prisms took from the stock: stock before less stock after, as OCCT measures both [mm3].
    double removed_mm3 = 0;
    /// How it was made, where that is not the plain way: retries, rebuilt from slabs. For the reader.
    std::vector<std::string> remarks;
};

/// What is left of a setup's stock once the prisms are gone.
///
/// Prisms with true arcs are cut from the solid by OCCT. Each try is checked: a closed solid whose volume is
/// the stock's less the prisms' (walls of the stock that lean make prisms hold air: then at most that).
/// Tries: all prisms at once, with a wider fuzzy value, one prism after another from the top, at last a stack
/// of prisms of what stays in each slab.
///
/// \param setup     its stock is what the prisms are taken from
/// \param removed   prisms whose interiors do not meet
/// \param arriving  the setup's stock as planar slabs from the top down; slabs whose walls lean as their hull
/// \throws Error(GeometryKernel) when no try gives a solid.
/// \see docs/algorithms/setups.md
StockAfter stockAfter(const Setup& setup, const std::vector<Prism>& removed,
                      const std::vector<Prism>& arriving, const Tolerances& tol);

}  // namespace stepmill
