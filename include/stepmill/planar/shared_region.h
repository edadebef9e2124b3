#pragma once

#include <memory>
#include <utility>

#include "stepmill/planar/region.h"

namespace stepmill {

/// A region that is kept in many places and changed in none: copies share its loops. Reads as the region it
/// holds; another one is put in its place.
class SharedRegion {
  public:
    SharedRegion() = default;  ///< the empty region
    // As a plain region, so that either is written alike.
    SharedRegion(Region region) : region_(std::make_shared<const Region>(std::move(region))) {}

    operator const Region&() const { return **this; }
    const Region& operator*() const;
    const Region* operator->() const { return &**this; }
    bool empty() const { return (**this).empty(); }

  private:
    std::shared_ptr<const Region> region_;
};

}  // namespace stepmill
