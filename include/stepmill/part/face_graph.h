#pragma once

#include <string>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/part/part.h"

namespace stepmill {

/// A point inside a face with the surface's normal there, out of the material.
struct FaceSample {
    Vec3 at;
    Vec3 normal;
};

/// What later stages need to know of one part face, in part coordinates.
struct FaceShape {
    int index = 0;               ///< as PartFace::index
    std::string surface;         ///< as PartFace::surface
    Vec3 origin = Vec3::Zero();  ///< a point of the plane; a point of the axis; the cone's apex
    Vec3 axis = Vec3::Zero();    ///< plane: outward normal; cylinder, cone, torus: axis; zero for others
    double radius_mm = 0;        ///< cylinder, sphere; torus: of the tube
    double half_angle_rad = 0;   ///< cone
    bool hollow = false;         ///< cylinder, cone, sphere, torus: the material is outside (bore, fillet)
    double angle_rad = 0;        ///< cylinder, cone: how far the face goes round the axis
    double area_mm2 = 0;
    Box3 bbox_mm;                     ///< of the face's edges and samples
    bool pointed = false;             ///< cone: the face runs to its apex
    std::vector<FaceSample> samples;  ///< inside the face; none on a face too narrow for the grid
    std::vector<Vec3> outline;        ///< points along its edges, three an edge
};

/// How two faces meet, seen from the material.
enum class Bend { Convex, Concave, Smooth };

/// An edge between two faces.
struct FaceEdge {
    int first = 0;
    int second = 0;
    Bend bend = Bend::Smooth;
    bool straight = false;
    double length_mm = 0;
    Vec3 from;
    Vec3 to;
    double turn_rad = 0;  ///< angle between the outward normals at the middle
};

/// A part's faces and how they meet, as plain values.
struct FaceGraph {
    std::vector<FaceShape> faces;  ///< one a part face, in their order
    std::vector<FaceEdge> edges;   ///< in the order of the shape's edges; seams are left out
};

/// Faces of the part and how they meet.
///
/// Samples lie on a grid over the face's parameters, refined until one is inside. Edges whose normals turn
/// by less than `tol.angular_rad` at the middle are smooth.
/// \throws Error(GeometryKernel)
/// \note  O(faces + edges) evaluations of the surfaces.
FaceGraph faceGraph(const Part& part, const Tolerances& tol);

/// The graph's edges alone, which cost no samples of the faces.
/// \throws Error(GeometryKernel)
std::vector<FaceEdge> faceEdges(const Part& part, const Tolerances& tol);

}  // namespace stepmill
