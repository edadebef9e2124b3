#pragma once

#include <TopoDS_Shape.hxx>

#include "stepmill/part/part.h"

namespace stepmill::report {

/// A part with facets for all pictures of a page. They stand in a copy, since meshing writes into a shape and
/// the part's is shared.
struct FacetedPart {
    const Part& part;
    TopoDS_Shape solid;  ///< with facets, in part coordinates
};

/// Cost: of a page's pictures the most, so it is made once a page.
/// \param coarser  how many times farther the facets may be off the part and turn
/// \throws Error(GeometryKernel)
FacetedPart facetedPart(const Part& part, double coarser = 1);

}  // namespace stepmill::report
