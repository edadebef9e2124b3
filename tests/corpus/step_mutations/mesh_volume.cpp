#include "mesh_volume.h"

#include <cmath>
#include <sstream>

#include <BRep_Tool.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

namespace stepmill::test {

namespace {

constexpr double kChord_mm = 0.05;
constexpr double kAngle_rad = 0.03;

void addTriangle(MeshVolume& volume, const gp_XYZ& a, const gp_XYZ& b, const gp_XYZ& c) {
    const gp_XYZ area = (b - a).Crossed(c - a) * 0.5;
    const gp_XYZ middle = (a + b + c) / 3;
    volume.x_mm3 += middle.X() * area.X();
    volume.y_mm3 += middle.Y() * area.Y();
    volume.z_mm3 += middle.Z() * area.Z();
}

bool addFace(MeshVolume& volume, const TopoDS_Face& face) {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, place);
    if (mesh.IsNull()) return false;
    const bool turned = (face.Orientation() == TopAbs_REVERSED) != place.Transformation().IsNegative();
    for (int i = 1; i <= mesh->NbTriangles(); ++i) {
        int a = 0;
        int b = 0;
        int c = 0;
        mesh->Triangle(i).Get(a, b, c);
        if (turned) std::swap(b, c);
        const auto corner = [&](int node) {
            return mesh->Node(node).Transformed(place.Transformation()).XYZ();
        };
        addTriangle(volume, corner(a), corner(b), corner(c));
    }
    return true;
}

bool addShape(MeshVolume& volume, const TopoDS_Shape& shape) {
    const BRepMesh_IncrementalMesh mesher(shape, kChord_mm, Standard_False, kAngle_rad);
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
        if (!addFace(volume, TopoDS::Face(it.Current()))) return false;
    return true;
}

}  // namespace

bool MeshVolume::agrees(double volume_mm3, double share) const {
    const double allowed_mm3 = share * std::abs(volume_mm3);
    return std::abs(x_mm3 - volume_mm3) <= allowed_mm3 && std::abs(y_mm3 - volume_mm3) <= allowed_mm3 &&
           std::abs(z_mm3 - volume_mm3) <= allowed_mm3;
}

std::optional<MeshVolume> meshVolume(const std::string& step_text) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    try {
        STEPControl_Controller::Init();
        Interface_Static::SetCVal("xstep.cascade.unit", "MM");
        STEPControl_Reader reader;
        std::istringstream stream{step_text};
        if (reader.ReadStream("part.step", stream) != IFSelect_RetDone) return std::nullopt;
        reader.TransferRoots();
        MeshVolume volume;
        for (int i = 1; i <= reader.NbShapes(); ++i)
            if (!addShape(volume, reader.Shape(i))) return std::nullopt;
        return volume;
    } catch (const Standard_Failure&) {
        return std::nullopt;
    }
}

}  // namespace stepmill::test
