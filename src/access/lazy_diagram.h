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
        return from([&]() -> const Region& { return region; }, tol);
    }

    /// Of the region that `make` returns; asked for it once.
    template <typename Make>
    const ClearanceDiagram& from(const Make& make, const Tolerances& tol) {
        std::call_once(once_, [&] { diagram_ = std::make_unique<ClearanceDiagram>(make(), tol); });
        return *diagram_;
    }

  private:
    std::once_flag once_;
    std::unique_ptr<ClearanceDiagram> diagram_;
};

}  // namespace stepmill
