#pragma once

#include <TopoDS_Shape.hxx>

#include "stepmill/part/part.h"

namespace stepmill::report {

/// A part with facets for all pictures of a page. They stand in a copy, since meshing writes into a shape and
/// the part's is shared, and are made when they are first asked for: of a page's pictures they cost most. For
/// one thread.
class FacetedPart {
  public:
    /// \param coarser  how many times farther than usual the facets may be off the part and turn
    explicit FacetedPart(const Part& part, double coarser = 1) : part_(part), coarser_(coarser) {}
    explicit FacetedPart(Part&&, double coarser = 1) = delete;

    const Part& part() const { return part_; }
    /// With facets, in part coordinates.
    /// \throws Error(GeometryKernel)
    const TopoDS_Shape& solid() const;

  private:
    const Part& part_;
    double coarser_;
    mutable TopoDS_Shape solid_;  ///< null: not asked for yet
};

}  // namespace stepmill::report
