// Words for faces.

#include "stepmill/layers/face_trace.h"

namespace stepmill {

std::string toString(SurfaceKind kind) {
    switch (kind) {
        case SurfaceKind::Plane:
            return "plane";
        case SurfaceKind::Cylinder:
            return "cylinder";
        case SurfaceKind::Cone:
            return "cone";
        case SurfaceKind::Sphere:
            return "sphere";
        case SurfaceKind::Torus:
            return "torus";
        case SurfaceKind::FreeForm:
            return "free form";
    }
    return {};
}

std::string toString(FaceStand stand) {
    switch (stand) {
        case FaceStand::Floor:
            return "floor";
        case FaceStand::Ceiling:
            return "ceiling";
        case FaceStand::Wall:
            return "wall";
        case FaceStand::Leaning:
            return "leaning";
        case FaceStand::Overhang:
            return "overhang";
        case FaceStand::Turning:
            return "turning";
    }
    return {};
}

}  // namespace stepmill
