#pragma once

#include <memory>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"
#include "stepmill/setup/setup.h"

namespace stepmill {

/// A setup's part, cut at whatever heights are asked for: finer than the layers of its stack. Heights and
/// regions are in setup coordinates [mm]. Facets are made once; safe to read from several threads.
class SectionCutter {
  public:
    /// \throws Error(GeometryKernel) if a face cannot be turned into facets
    SectionCutter(const Setup& setup, const Tolerances& tol);
    ~SectionCutter();
    SectionCutter(SectionCutter&&) noexcept;

    /// Heights strictly between the two at which the part's section may change its shape, from below to
    /// above.
    std::vector<double> levelsBetween(double bottom_mm, double top_mm) const;
    /// All that the part covers at some height between the two, as Layer::part: the safe side.
    /// \pre no level lies strictly between them
    Region partBetween(double bottom_mm, double top_mm) const;
    /// How flat the part's faces get that look up between the heights: the greatest sine of their lean, 0 for
    /// walls that stand upright, towards 1 for level ground. Level faces do not count.
    double greatestLean(double bottom_mm, double top_mm) const;
    /// The leans of all such faces to a fiftieth, ascending; 0 is none of them.
    std::vector<double> leansBetween(double bottom_mm, double top_mm) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// A stock as setups left it, seen from one of them, at any height.
class StockSections {
  public:
    /// \param setup  whose coordinates all is in; its own stock is not looked at
    StockSections(const Setup& setup, const Stock& stock, const Tolerances& tol);
    ~StockSections();
    StockSections(StockSections&&) noexcept;

    /// All that stands at some height between the two.
    Region between(double bottom_mm, double top_mm) const;
    /// All of the ground that stands at some height between the two.
    Region between(const Region& ground, double bottom_mm, double top_mm) const;
    /// What of the ground stands at every height between the two, or less; on walls that were cut along axes
    /// askew to the setup's it may be more by the chord of their arcs [layers/stock/askew_cut.h]. A raw solid
    /// whose walls bend between the heights is looked at in three of them.
    Region throughout(const Region& ground, double bottom_mm, double top_mm) const;
    /// What stands at that height.
    Region at(double z_mm) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace stepmill
