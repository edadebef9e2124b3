// Words for faces.

#include "stepmill/layers/face_trace.h"
#include "stepmill/core/enum_words.h"

namespace stepmill {
namespace {

constexpr EnumWord<SurfaceKind> kSurfaceKinds[] = {
    {SurfaceKind::Plane, "plane"}, {SurfaceKind::Cylinder, "cylinder"},
    {SurfaceKind::Cone, "cone"},   {SurfaceKind::Sphere, "sphere"},
    {SurfaceKind::Torus, "torus"}, {SurfaceKind::FreeForm, "free form"}};
constexpr EnumWord<FaceStand> kFaceStands[] = {
    {FaceStand::Floor, "floor"},     {FaceStand::Ceiling, "ceiling"},   {FaceStand::Wall, "wall"},
    {FaceStand::Leaning, "leaning"}, {FaceStand::Overhang, "overhang"}, {FaceStand::Turning, "turning"}};

}  // namespace

std::string toString(SurfaceKind kind) {
    return wordOf(kSurfaceKinds, kind);
}

std::string toString(FaceStand stand) {
    return wordOf(kFaceStands, stand);
}

}  // namespace stepmill
