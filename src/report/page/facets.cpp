#include "report/page/facets.h"

#include <BRep_Tool.hxx>
#include <gp_Pnt.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace stepmill::report {

std::vector<SolidFacet> facetsOf(const TopoDS_Shape& solid) {
    std::vector<SolidFacet> facets;
    std::size_t face = 0;
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next(), ++face) {
        TopLoc_Location location;
        const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(it.Current()), location);
        if (mesh.IsNull()) continue;
        for (int i = 1; i <= mesh->NbTriangles(); ++i) {
            std::array<int, 3> node{};
            mesh->Triangle(i).Get(node[0], node[1], node[2]);
            SolidFacet& facet = facets.emplace_back();
            facet.face = face;
            facet.reversed = it.Current().Orientation() == TopAbs_REVERSED;
            for (int k = 0; k < 3; ++k) {
                const gp_Pnt at = mesh->Node(node[k]).Transformed(location.Transformation());
                facet.corners[k] = {at.X(), at.Y(), at.Z()};
            }
        }
    }
    return facets;
}

}  // namespace stepmill::report
