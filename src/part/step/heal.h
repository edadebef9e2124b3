#pragma once

#include <string>
#include <vector>

#include "part/step/import.h"
#include "stepmill/part/part.h"

namespace stepmill {

/// How far the pieces of a solid lie apart, measured on the geometry and not on OCCT's tolerances, which
/// the reader widens until everything "fits" [mm].
struct Misfit {
    double vertex_mm = 0;  ///< worst distance of a vertex from the end of one of its edges
    double edge_mm = 0;    ///< worst distance of an edge from one of its faces
    int vertices_off = 0;  ///< vertices beyond the limit given
    int edges_off = 0;
    Vec3 where = Vec3::Zero();  ///< at the worst vertex or edge
};

/// Largest gap between vertices, edges and faces that still counts as rounding of the exporting system:
/// 0.02 mm, and for large parts 2e-4 of the longest side.
///
/// Measured on the NIST, machined and MFCAD parts: the worst are nist_ctc_02 (an edge 0.038 mm off its
/// face, 0.172 allowed) and nist_ctc_05 (a vertex 0.018 mm off, 0.112 allowed), all others are below
/// 0.01 mm. A vertex that was moved shows up with the whole distance.
double largestGap(const Box3& box);

/// Gaps beyond this are a doubt: 0.001 mm, and for large parts 1e-4 of the longest side. The worst sound part
/// is nist_ctc_02 with 4.4e-5.
double doubtfulGap(const Box3& box);

/// \param exact_mm  gaps up to this are bounds from above, greater ones measured
/// \param limit_mm  what counts as off
Misfit measureMisfit(const TopoDS_Shape& solid, double exact_mm, double limit_mm);

struct HealedSolid {
    TopoDS_Shape shape;
    double volume_mm3 = 0;
};

/// Makes the solid valid, closed, outward-facing. Adds what it changed to `remarks`, as input-doubts, and
/// tells `names` about faces it replaced.
/// \throws Error(OpenShell, InvalidSolid)
HealedSolid healSolid(const TopoDS_Shape& solid, const std::string& subject, ShapeNames& names,
                      std::vector<Remark>& remarks);

/// Scaled about the origin; carries the face names over.
TopoDS_Shape scaleSolid(const TopoDS_Shape& solid, double factor, ShapeNames& names);

}  // namespace stepmill
