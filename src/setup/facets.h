#pragma once

#include <array>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "stepmill/setup/setup.h"

namespace stepmill::setup {

using Facet = std::array<Vec3, 3>;

/// Facets of a solid, good enough to measure reach and containment on, face after face.
using Facets = std::vector<Facet>;

/// Facets with a sagitta of a fiftieth of each edge's length, corners counter-clockwise seen from outside.
/// The solid itself is not touched.
Facets coarseFacets(const TopoDS_Shape& solid);

/// The same, with the face (order of TopExp_Explorer) each facet belongs to.
struct FaceFacets {
    Facets facets;
    std::vector<int> face;
};
FaceFacets coarseFaceFacets(const TopoDS_Shape& solid);

}  // namespace stepmill::setup
