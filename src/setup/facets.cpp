#include "setup/facets.h"

#include <BRep_Tool.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "stepmill/part/part_shape.h"

namespace stepmill::setup {

namespace {

/// Sagitta as a share of each edge's length, and the greatest turn between neighbouring facets.
constexpr double kSagittaShare = 0.02;
constexpr double kTurnRad = 0.4;

void addFacets(const TopoDS_Face& face, int index, FaceFacets& out) {
    TopLoc_Location location;
    const auto mesh = BRep_Tool::Triangulation(face, location);
    if (mesh.IsNull()) return;
    const bool reversed = face.Orientation() == TopAbs_REVERSED;
    for (int i = 1; i <= mesh->NbTriangles(); ++i) {
        std::array<int, 3> node{};
        mesh->Triangle(i).Get(node[0], node[1], node[2]);
        if (reversed) std::swap(node[1], node[2]);
        Facet facet;
        for (int k = 0; k < 3; ++k) {
            const gp_Pnt p = mesh->Node(node[k]).Transformed(location.Transformation());
            facet[k] = Vec3(p.X(), p.Y(), p.Z());
        }
        out.facets.push_back(facet);
        out.face.push_back(index);
    }
}

}  // namespace

FaceFacets coarseFaceFacets(const TopoDS_Shape& solid) {
    FaceFacets out;
    guardOcct(ErrorCode::GeometryKernel, "facets of the solid", [&] {
        const TopoDS_Shape shape = BRepBuilderAPI_Copy(solid).Shape();
        makeFacets(shape, kSagittaShare, kTurnRad, FacetChord::ShareOfEdge);
        int index = 0;
        for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
            addFacets(TopoDS::Face(it.Current()), index++, out);
    });
    return out;
}

Facets coarseFacets(const TopoDS_Shape& solid) {
    return coarseFaceFacets(solid).facets;
}

}  // namespace stepmill::setup
