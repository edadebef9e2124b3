#pragma once

#include <memory>
#include <mutex>

#include "stepmill/planar/clearance_diagram.h"

namespace stepmill {

/// A diagram built when first asked for, once, whichever thread comes first. Always asked with the same
/// region.
class LazyDiagram {
  public:
    const ClearanceDiagram& of(const Region& region, const Tolerances& tol) {
        std::call_once(once_, [&] { diagram_ = std::make_unique<ClearanceDiagram>(region, tol); });
        return *diagram_;
    }

  private:
    std::once_flag once_;
    std::unique_ptr<ClearanceDiagram> diagram_;
};

}  // namespace stepmill
