#pragma once

#include <vector>

#include "part/step/heal.h"

namespace stepmill {

/// The solid with planes, cylinders, cones, spheres and tori where its file draws these as splines or as
/// something swept or turned, and with lines and circles at their edges likewise: some exporters know nothing
/// else. So a hole is a hole however it is drawn, and slices of it are arcs. The solid itself where there is
/// nothing of the kind, or where the kernel finds fault with what came out.
///
/// Adds to `remarks` how many faces were drawn anew, and carries the face names over.
TopoDS_Shape withElementarySurfaces(const HealedSolid& solid, ShapeNames& names,
                                    std::vector<Remark>& remarks);

}  // namespace stepmill
