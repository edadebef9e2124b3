#include "part/step/kinds.h"

#include <algorithm>
#include <array>

namespace stepmill {
namespace {

/// Sorted, for the search.
constexpr std::array<std::string_view, 56> kShapeEntities = {"ADVANCED_BREP_SHAPE_REPRESENTATION",
                                                             "ADVANCED_FACE",
                                                             "AXIS1_PLACEMENT",
                                                             "AXIS2_PLACEMENT_2D",
                                                             "AXIS2_PLACEMENT_3D",
                                                             "BEZIER_CURVE",
                                                             "BEZIER_SURFACE",
                                                             "BOUNDED_CURVE",
                                                             "BOUNDED_SURFACE",
                                                             "BREP_WITH_VOIDS",
                                                             "B_SPLINE_CURVE",
                                                             "B_SPLINE_CURVE_WITH_KNOTS",
                                                             "B_SPLINE_SURFACE",
                                                             "B_SPLINE_SURFACE_WITH_KNOTS",
                                                             "CARTESIAN_POINT",
                                                             "CIRCLE",
                                                             "CLOSED_SHELL",
                                                             "CONICAL_SURFACE",
                                                             "CYLINDRICAL_SURFACE",
                                                             "DEGENERATE_TOROIDAL_SURFACE",
                                                             "DIRECTION",
                                                             "EDGE_CURVE",
                                                             "EDGE_LOOP",
                                                             "ELLIPSE",
                                                             "FACETED_BREP",
                                                             "FACE_BOUND",
                                                             "FACE_OUTER_BOUND",
                                                             "FACE_SURFACE",
                                                             "HYPERBOLA",
                                                             "INTERSECTION_CURVE",
                                                             "ITEM_DEFINED_TRANSFORMATION",
                                                             "LINE",
                                                             "MANIFOLD_SOLID_BREP",
                                                             "MAPPED_ITEM",
                                                             "OFFSET_SURFACE",
                                                             "OPEN_SHELL",
                                                             "ORIENTED_CLOSED_SHELL",
                                                             "ORIENTED_EDGE",
                                                             "ORIENTED_FACE",
                                                             "PARABOLA",
                                                             "PCURVE",
                                                             "PLANE",
                                                             "POLYLINE",
                                                             "POLY_LOOP",
                                                             "RECTANGULAR_TRIMMED_SURFACE",
                                                             "SEAM_CURVE",
                                                             "SHELL_BASED_SURFACE_MODEL",
                                                             "SPHERICAL_SURFACE",
                                                             "SURFACE_CURVE",
                                                             "SURFACE_OF_LINEAR_EXTRUSION",
                                                             "SURFACE_OF_REVOLUTION",
                                                             "TOROIDAL_SURFACE",
                                                             "TRIMMED_CURVE",
                                                             "VECTOR",
                                                             "VERTEX_LOOP",
                                                             "VERTEX_POINT"};
static_assert(std::is_sorted(kShapeEntities.begin(), kShapeEntities.end()));

struct KeywordClass {
    std::string_view keyword;
    StepClass kind;
};

/// The entities of ISO 10303-42 by what they may stand for, sorted.
constexpr auto kClasses = std::to_array<KeywordClass>({
    KeywordClass{"ADVANCED_FACE", StepClass::Face},
    KeywordClass{"AXIS1_PLACEMENT", StepClass::Axis},
    KeywordClass{"AXIS2_PLACEMENT_2D", StepClass::Placement},
    KeywordClass{"AXIS2_PLACEMENT_3D", StepClass::Placement},
    KeywordClass{"BEZIER_CURVE", StepClass::Curve},
    KeywordClass{"BEZIER_SURFACE", StepClass::Surface},
    KeywordClass{"BOUNDARY_CURVE", StepClass::Curve},
    KeywordClass{"BOUNDED_CURVE", StepClass::Curve},
    KeywordClass{"BOUNDED_PCURVE", StepClass::Curve},
    KeywordClass{"BOUNDED_SURFACE", StepClass::Surface},
    KeywordClass{"BOUNDED_SURFACE_CURVE", StepClass::Curve},
    KeywordClass{"BREP_WITH_VOIDS", StepClass::Solid},
    KeywordClass{"B_SPLINE_CURVE", StepClass::Curve},
    KeywordClass{"B_SPLINE_CURVE_WITH_KNOTS", StepClass::Curve},
    KeywordClass{"B_SPLINE_SURFACE", StepClass::Surface},
    KeywordClass{"B_SPLINE_SURFACE_WITH_KNOTS", StepClass::Surface},
    KeywordClass{"CARTESIAN_POINT", StepClass::Point},
    KeywordClass{"CIRCLE", StepClass::Curve},
    KeywordClass{"CLOSED_SHELL", StepClass::Shell},
    KeywordClass{"CLOTHOID", StepClass::Curve},
    KeywordClass{"COMPOSITE_CURVE", StepClass::Curve},
    KeywordClass{"COMPOSITE_CURVE_ON_SURFACE", StepClass::Curve},
    KeywordClass{"CONIC", StepClass::Curve},
    KeywordClass{"CONICAL_SURFACE", StepClass::Surface},
    KeywordClass{"CONNECTED_FACE_SET", StepClass::Shell},
    KeywordClass{"CURVE", StepClass::Curve},
    KeywordClass{"CURVE_BOUNDED_SURFACE", StepClass::Surface},
    KeywordClass{"CURVE_REPLICA", StepClass::Curve},
    KeywordClass{"CYLINDRICAL_SURFACE", StepClass::Surface},
    KeywordClass{"DEGENERATE_PCURVE", StepClass::Point},
    KeywordClass{"DEGENERATE_TOROIDAL_SURFACE", StepClass::Surface},
    KeywordClass{"DIRECTION", StepClass::Direction},
    KeywordClass{"DUPIN_CYCLIDE_SURFACE", StepClass::Surface},
    KeywordClass{"EDGE_CURVE", StepClass::Edge},
    KeywordClass{"EDGE_LOOP", StepClass::Loop},
    KeywordClass{"ELEMENTARY_SURFACE", StepClass::Surface},
    KeywordClass{"ELLIPSE", StepClass::Curve},
    KeywordClass{"EVALUATED_DEGENERATE_PCURVE", StepClass::Point},
    KeywordClass{"FACETED_BREP", StepClass::Solid},
    KeywordClass{"FACE_BOUND", StepClass::Bound},
    KeywordClass{"FACE_OUTER_BOUND", StepClass::Bound},
    KeywordClass{"FACE_SURFACE", StepClass::Face},
    KeywordClass{"HYPERBOLA", StepClass::Curve},
    KeywordClass{"INTERSECTION_CURVE", StepClass::Curve},
    KeywordClass{"LINE", StepClass::Curve},
    KeywordClass{"MANIFOLD_SOLID_BREP", StepClass::Solid},
    KeywordClass{"OFFSET_CURVE_2D", StepClass::Curve},
    KeywordClass{"OFFSET_CURVE_3D", StepClass::Curve},
    KeywordClass{"OFFSET_SURFACE", StepClass::Surface},
    KeywordClass{"OPEN_SHELL", StepClass::Shell},
    KeywordClass{"ORIENTED_CLOSED_SHELL", StepClass::Shell},
    KeywordClass{"ORIENTED_EDGE", StepClass::OrientedEdge},
    KeywordClass{"ORIENTED_FACE", StepClass::Face},
    KeywordClass{"ORIENTED_OPEN_SHELL", StepClass::Shell},
    KeywordClass{"ORIENTED_SURFACE", StepClass::Surface},
    KeywordClass{"OUTER_BOUNDARY_CURVE", StepClass::Curve},
    KeywordClass{"PARABOLA", StepClass::Curve},
    KeywordClass{"PCURVE", StepClass::Curve},
    KeywordClass{"PLANE", StepClass::Surface},
    KeywordClass{"POINT_ON_CURVE", StepClass::Point},
    KeywordClass{"POINT_ON_SURFACE", StepClass::Point},
    KeywordClass{"POINT_REPLICA", StepClass::Point},
    KeywordClass{"POLYLINE", StepClass::Curve},
    KeywordClass{"POLY_LOOP", StepClass::Loop},
    KeywordClass{"QUASI_UNIFORM_CURVE", StepClass::Curve},
    KeywordClass{"QUASI_UNIFORM_SURFACE", StepClass::Surface},
    KeywordClass{"RATIONAL_B_SPLINE_CURVE", StepClass::Curve},
    KeywordClass{"RATIONAL_B_SPLINE_SURFACE", StepClass::Surface},
    KeywordClass{"RECTANGULAR_COMPOSITE_SURFACE", StepClass::Surface},
    KeywordClass{"RECTANGULAR_TRIMMED_SURFACE", StepClass::Surface},
    KeywordClass{"SEAM_CURVE", StepClass::Curve},
    KeywordClass{"SEAM_EDGE", StepClass::OrientedEdge},
    KeywordClass{"SPHERICAL_SURFACE", StepClass::Surface},
    KeywordClass{"SUBEDGE", StepClass::Edge},
    KeywordClass{"SUBFACE", StepClass::Face},
    KeywordClass{"SURFACE", StepClass::Surface},
    KeywordClass{"SURFACE_CURVE", StepClass::Curve},
    KeywordClass{"SURFACE_OF_LINEAR_EXTRUSION", StepClass::Surface},
    KeywordClass{"SURFACE_OF_REVOLUTION", StepClass::Surface},
    KeywordClass{"SURFACE_REPLICA", StepClass::Surface},
    KeywordClass{"SWEPT_SURFACE", StepClass::Surface},
    KeywordClass{"TOROIDAL_SURFACE", StepClass::Surface},
    KeywordClass{"TRIMMED_CURVE", StepClass::Curve},
    KeywordClass{"UNIFORM_CURVE", StepClass::Curve},
    KeywordClass{"UNIFORM_SURFACE", StepClass::Surface},
    KeywordClass{"VECTOR", StepClass::Vector},
    KeywordClass{"VERTEX_LOOP", StepClass::Loop},
    KeywordClass{"VERTEX_POINT", StepClass::Vertex},
});
static_assert(std::is_sorted(kClasses.begin(), kClasses.end(),
                             [](const KeywordClass& a, const KeywordClass& b) {
                                 return a.keyword < b.keyword;
                             }));

}  // namespace

bool isShapeEntity(std::string_view keyword) {
    return std::binary_search(kShapeEntities.begin(), kShapeEntities.end(), keyword);
}

bool isSolidBody(std::string_view keyword) {
    return keyword == "MANIFOLD_SOLID_BREP" || keyword == "BREP_WITH_VOIDS" || keyword == "FACETED_BREP" ||
           keyword == "FACETED_BREP_AND_BREP_WITH_VOIDS";
}

StepClass classOf(std::string_view keyword) {
    const auto found =
        std::lower_bound(kClasses.begin(), kClasses.end(), keyword,
                         [](const KeywordClass& a, std::string_view b) { return a.keyword < b; });
    return found != kClasses.end() && found->keyword == keyword ? found->kind : StepClass::Other;
}

std::string_view nameOf(StepClass kind) {
    static constexpr std::array<std::string_view, 16> kNames = {"another entity",    "a CARTESIAN_POINT",
                                                                "a DIRECTION",       "a VECTOR",
                                                                "an axis placement", "an AXIS1_PLACEMENT",
                                                                "a curve",           "a surface",
                                                                "a VERTEX_POINT",    "an EDGE_CURVE",
                                                                "an ORIENTED_EDGE",  "a loop",
                                                                "a face bound",      "a face",
                                                                "a shell",           "a solid"};
    return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace stepmill
