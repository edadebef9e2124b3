#include "stepmill/part/part_shape.h"

#include <algorithm>
#include <new>

#include <BRepAdaptor_Surface.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Standard_OutOfMemory.hxx>
#include <TopoDS.hxx>

#include "part/measure.h"

namespace stepmill {
namespace {

/// The kernel's usual triangulation looks, for each node, at all circles of the face that reach across it:
/// on a plate with 400 holes that takes eleven times as long as its other one. On faces of few loops both are
/// quick; they put the nodes inside curved ones elsewhere.
constexpr int kManyLoops = 64;

bool hasFaceOfManyLoops(const TopoDS_Shape& shape) {
    const std::vector<TopoDS_Face> faces = facesOf(shape);
    return std::any_of(faces.begin(), faces.end(),
                       [](const TopoDS_Face& face) { return countShapes(face, TopAbs_WIRE) > kManyLoops; });
}

}  // namespace

void guardOcct(ErrorCode code, const std::string& subject, const std::function<void()>& work) {
    try {
        work();
    } catch (const Standard_OutOfMemory&) {
        throw std::bad_alloc();  // says nothing about the shape
    } catch (const Standard_Failure& failure) {
        const char* text = failure.GetMessageString();
        const std::string kind = failure.DynamicType()->Name();
        throw Error(code, subject,
                    "the geometry kernel failed: " + kind + (text && *text ? std::string(": ") + text : ""));
    }
}

void makeFacets(const TopoDS_Shape& shape, double chord, double turn_rad, FacetChord unit) {
    IMeshTools_Parameters how;
    how.Deflection = chord;
    how.Relative = unit == FacetChord::ShareOfEdge;
    how.Angle = turn_rad;
    // Edges are divided before faces, and every face on its own.
    how.InParallel = true;
    how.MeshAlgo =
        hasFaceOfManyLoops(shape) ? IMeshTools_MeshAlgoType_Delabella : IMeshTools_MeshAlgoType_Watson;
    const BRepMesh_IncrementalMesh mesher(shape, how);
}

std::optional<Vec3> axisOf(const TopoDS_Face& face) {
    const BRepAdaptor_Surface surface(face, Standard_False);
    const auto vec = [](const gp_Dir& d) { return Vec3(d.X(), d.Y(), d.Z()); };
    switch (surface.GetType()) {
        case GeomAbs_Plane:
            return vec(surface.Plane().Axis().Direction());
        case GeomAbs_Cylinder:
            return vec(surface.Cylinder().Axis().Direction());
        case GeomAbs_Cone:
            return vec(surface.Cone().Axis().Direction());
        default:
            return std::nullopt;
    }
}

Part makePart(const TopoDS_Shape& solid, const std::string& name) {
    Part part;
    guardOcct(ErrorCode::InvalidSolid, name, [&] {
        const TopoDS_Shape single = singleSolid(solid, name);
        requireValid(single, volumeOf(single), name);
        part.name = name;
        part.unit_in_file = "mm";
        describeShape(part, single);
    });
    return part;
}

}  // namespace stepmill
