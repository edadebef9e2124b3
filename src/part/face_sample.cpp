#include "part/face_sample.h"

#include "part/occt_values.h"

namespace stepmill {

FaceSample sampleAt(const TopoDS_Face& face, const BRepAdaptor_Surface& surface, double u, double v) {
    gp_Pnt p;
    gp_Vec du;
    gp_Vec dv;
    surface.D1(u, v, p, du, dv);
    gp_Vec normal = du.Crossed(dv);
    if (face.Orientation() == TopAbs_REVERSED) normal.Reverse();
    const double size = normal.Magnitude();
    constexpr double kPole = 1e-12;
    return {toVec3(p), size > kPole ? Vec3(toVec3(gp_Pnt(normal.XYZ())) / size) : Vec3(Vec3::Zero())};
}

}  // namespace stepmill
