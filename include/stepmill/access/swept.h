#pragma once

#include <memory>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// What the passes of a tool sweep for sure. Where a neck runs out to the tool's own width, the strip of its
/// centres is too thin for a pass long before it ends; what only such a strip would sweep does not count.
///
/// The region and the diagram that shrinks it are made when they are first asked for, once. Copies share
/// them; safe to share between threads.
class SureSweep {
  public:
    /// Sweeps nothing.
    SureSweep();
    /// The sweep of a disc: of its centres only what a disc of access::halfSliverMm() opens, and nothing
    /// of `given_up`. Both are regions in the setup plane [mm].
    SureSweep(Region centres, double radius_mm, Region given_up, const Tolerances& tol);
    /// Swept by whatever means.
    SureSweep(Region swept, const Tolerances& tol);

    const Region& region() const;
    /// Where a disc of radius `by_mm` lies in the region with all of itself.
    Region shrunk(double by_mm) const;

  private:
    struct Made;
    std::shared_ptr<Made> made_;
};

namespace access {

/// What a disc sweeps while its centre goes everywhere in `centres`: offset(centres, radius). Each component
/// is grown by itself and the results united, so that discs of different components that meet across a neck
/// are a matter of the Boolean alone.
Region swept(const Region& centres, double radius_mm, const Tolerances& tol);

/// Centres within this of their region's both walls get no pass, so what only they sweep stays.
inline double halfSliverMm(const Tolerances& tol) {
    return tol.sliver_mm / 2;
}

}  // namespace access
}  // namespace stepmill
