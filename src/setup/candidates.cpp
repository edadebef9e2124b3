// Which tool axes could make sense for a part.

#include "setup/candidates.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "setup/frame.h"
#include "stepmill/part/part_shape.h"

namespace stepmill::setup {

namespace {

/// Sculpted parts have hundreds of normals; those of the largest faces are worth asking about.
constexpr std::size_t kMostTiltedAxes = 26;

struct Direction {
    Vec3 axis;
    double area_mm2 = 0;
};

bool among(const Vec3& axis, const std::vector<Vec3>& axes) {
    return std::any_of(axes.begin(), axes.end(), [&](const Vec3& other) { return isSameAxis(axis, other); });
}

/// Outward normal of a plane; both senses of the axis of a cylinder or cone.
std::vector<Vec3> directionsOf(const TopoDS_Face& face) {
    const std::optional<Vec3> axis = axisOf(face);
    if (!axis) return {};
    const BRepAdaptor_Surface surface(face, Standard_False);
    if (surface.GetType() != GeomAbs_Plane) return {*axis, -*axis};
    // A plane's own frame may be left-handed; then its surface normal is opposite to its axis.
    const bool turned = surface.Plane().Direct() == (face.Orientation() == TopAbs_REVERSED);
    return {*axis * (turned ? -1 : 1)};
}

double areaOf(const TopoDS_Face& face) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties);
    return properties.Mass();
}

/// Distinct directions that are no box directions, in the order of their first faces.
std::vector<Direction> tiltedDirections(const TopoDS_Shape& solid) {
    const std::vector<Vec3> box = boxDirections();
    std::vector<Direction> found;
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Face& face = TopoDS::Face(it.Current());
        std::optional<double> area_mm2;
        for (const Vec3& direction : directionsOf(face)) {
            const Vec3 axis = cleanAxis(direction);
            if (among(axis, box)) continue;
            if (!area_mm2) area_mm2 = areaOf(face);
            const auto known = std::find_if(found.begin(), found.end(), [&](const Direction& other) {
                return isSameAxis(other.axis, axis);
            });
            if (known == found.end())
                found.push_back({axis, *area_mm2});
            else
                known->area_mm2 += *area_mm2;
        }
    }
    return found;
}

std::vector<Direction> tiltedDirections(const Part& part) {
    std::vector<Direction> tilted;
    guardOcct(ErrorCode::GeometryKernel, "tool axes", [&] { tilted = tiltedDirections(part.shape->solid); });
    return tilted;
}

}  // namespace

std::vector<Vec3> boxDirections() {
    return {Vec3::UnitZ(), -Vec3::UnitZ(), Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitY()};
}

std::vector<Vec3> candidateAxes(const Part& part, const std::vector<Vec3>& forbidden) {
    std::vector<Vec3> axes = boxDirections();
    std::vector<Direction> tilted = tiltedDirections(part);
    std::stable_sort(tilted.begin(), tilted.end(),
                     [](const Direction& a, const Direction& b) { return a.area_mm2 > b.area_mm2; });
    if (tilted.size() > kMostTiltedAxes) tilted.resize(kMostTiltedAxes);
    for (const Direction& direction : tilted)
        axes.push_back(direction.axis);
    std::erase_if(axes, [&](const Vec3& axis) { return among(axis, forbidden); });
    if (axes.empty()) throw Error(ErrorCode::Usage, "--no-setup", "leaves no tool axis to machine from");
    return axes;
}

}  // namespace stepmill::setup

namespace stepmill {

std::size_t axesNotWeighed(const Part& part) {
    const std::size_t tilted = setup::tiltedDirections(part).size();
    return tilted - std::min(tilted, setup::kMostTiltedAxes);
}

}  // namespace stepmill
