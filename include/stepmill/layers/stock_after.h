#pragma once

#include <string>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/setup/setup.h"

namespace stepmill {

/// A stock after a setup.
struct StockAfter {
    Stock stock;
    /// Volume the prisms took from the stock: `prisms_mm3`, less the air in it that earlier setups cut from
    /// other sides [mm3].
    double removed_mm3 = 0;
    double prisms_mm3 = 0;  ///< volume of the prisms within the layers' stock
};

/// What is left of a setup's stock once the prisms are gone.
///
/// The stock is kept as its raw solid and the prisms of every setup (ADR 0005): nothing is cut before the
/// next setup asks for sections. What earlier setups took from the prisms' ground is integrated from the
/// lines and arcs of both. The stock's box shrinks to what still stands.
/// \param setup    its stock is what the prisms are taken from
/// \param layers   slice() of the setup
/// \param removed  prisms whose interiors meet nowhere within the layers' stock; they may reach out of it
/// \see docs/algorithms/setups.md
StockAfter stockAfter(const Setup& setup, const LayerStack& layers, const std::vector<Prism>& removed,
                      const Tolerances& tol);

}  // namespace stepmill
