#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stepmill/part/face_graph.h"
#include "stepmill/planar/region.h"

namespace stepmill {

enum class SurfaceKind { Plane, Cylinder, Cone, Sphere, Torus, FreeForm };
std::string toString(SurfaceKind kind);

/// How a part face stands to the tool axis.
enum class FaceStand {
    Floor,     ///< horizontal plane looking up to the tool
    Ceiling,   ///< horizontal plane looking down
    Wall,      ///< vertical everywhere
    Leaning,   ///< looks up, or up and sideways: a tool from above sees all of it
    Overhang,  ///< looks down, or down and sideways
    Turning    ///< looks up in some places and down in others: cross holes, balls, tubes
};
std::string toString(FaceStand stand);

/// Why a slab's region covers more than the part: what the leaning face is.
enum class SlopeCause {
    Draft,        ///< plane or cone within 20 degrees of vertical
    SlantedFace,  ///< plane or cone farther from vertical, no chamfer
    Chamfer,      ///< plane or cone between a horizontal face above and a vertical one below, or the edge
                  ///< of a hole (a countersink is a wide one)
    EdgeFillet,   ///< convex blend that ends tangent to the horizontal face above it
    FloorFillet,  ///< concave blend that starts tangent to the floor below it, and the balls in its corners
    DrillPoint,   ///< hollow cone that closes to a point below
    AcrossAxis,   ///< hollow cylinder or cone whose axis is not the tool's: a hole for another setup
    FreeForm,     ///< any other curved face
    Overhang      ///< looks down: no tool from above reaches below it
};
/// The words of reports: "wall not vertical", "slanted face", "chamfer", "edge fillet", "floor fillet",
/// "drill point", "hole across the axis", "free form", "overhang".
inline std::string toString(SlopeCause cause) {
    switch (cause) {
        case SlopeCause::Draft:
            return "wall not vertical";
        case SlopeCause::SlantedFace:
            return "slanted face";
        case SlopeCause::Chamfer:
            return "chamfer";
        case SlopeCause::EdgeFillet:
            return "edge fillet";
        case SlopeCause::FloorFillet:
            return "floor fillet";
        case SlopeCause::DrillPoint:
            return "drill point";
        case SlopeCause::AcrossAxis:
            return "hole across the axis";
        case SlopeCause::FreeForm:
            return "free form";
        case SlopeCause::Overhang:
            return "overhang";
    }
    return {};
}

/// A face on the other side of one or several of a face's edges.
struct FaceNeighbour {
    int face = -1;
    Bend bend = Bend::Smooth;  ///< of the longest common edge; smooth: within 1 degree
};

/// One face of the part as a setup sees it, from the B-rep, in setup coordinates.
struct FaceTrace {
    int face = -1;  ///< order of TopExp_Explorer(FACE) on the part's shape; also its place in the vector
    SurfaceKind surface = SurfaceKind::FreeForm;
    FaceStand stand = FaceStand::Wall;
    /// Why the face hides volume; nothing for floors, ceilings and walls.
    std::optional<SlopeCause> cause;
    double top_z_mm = 0;
    double bottom_z_mm = 0;
    /// Least and greatest z of the outward unit normal: 1 looks up, 0 sideways, -1 down. On curved faces
    /// from the facets' corners.
    double least_normal_z = 0;
    double greatest_normal_z = 0;
    /// Of a Wall: where it stands, material on the left; one path of one line or arc (of a free-form wall
    /// of several), from end to end over all heights. A full circle is closed. Empty for other faces.
    Path footprint;
    /// What the face covers seen from above, if it does so once (Floor, Ceiling, and Leaning or Overhang
    /// faces that do not fold over themselves); else empty. Outline exact for lines and circles about
    /// vertical axes, else fitted within `Tolerances::curve_fit_mm`.
    Region region;
    /// Cylinder, cone, sphere, torus: is material outside (a hole, a fillet at an inner edge)?
    bool hollow = false;
    /// Cylinder, cone, sphere, torus: radius; of a cone the larger end's, of a torus the tube's. Else 0.
    double radius_mm = 0;
    /// Where the axis of a vertical cylinder, cone or torus, or the centre of a sphere, stands.
    std::optional<Vec2> axis_point;
    /// By face index.
    std::vector<FaceNeighbour> neighbours;
};

/// Volume of a slab that leaning walls of one cause hide.
struct HiddenVolume {
    SlopeCause cause = SlopeCause::FreeForm;
    double volume_mm3 = 0;
    std::vector<int> faces;  ///< that hide it, ascending
};

}  // namespace stepmill
