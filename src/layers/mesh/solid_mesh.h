#pragma once

#include <array>
#include <string>
#include <vector>

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <gp_Pnt2d.hxx>
#include <TopoDS_Shape.hxx>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"
#include "stepmill/setup/setup.h"

namespace stepmill::layers {

/// What a horizontal plane cuts out of a face.
enum class FaceKind {
    Plane,   ///< a straight line
    Turned,  ///< a circle about a vertical axis: cylinder, cone, sphere, torus
    Lying,   ///< one or two parallel lines: a cylinder with horizontal axis
    Free     ///< any other curve
};

struct MeshFace {
    FaceKind kind = FaceKind::Free;
    Handle(Geom_Surface) surface;  ///< in setup coordinates
    bool reversed = false;         ///< outward normal opposite to the surface's
    bool horizontal = false;       ///< a plane with vertical normal: a level, never cut
    bool vertical = false;         ///< the normal is horizontal everywhere
    double z_min_mm = 0;
    double z_max_mm = 0;
    double facets_low_mm = 0;  ///< least and greatest height of the facets' nodes
    double facets_high_mm = 0;
    double least_normal_z = 0;  ///< of the outward unit normal, over the facets' corners
    double greatest_normal_z = 0;
    Vec3 normal = Vec3::Zero();  ///< outward, of a Plane
    double offset_mm = 0;        ///< normal . p = offset on a Plane
    Vec2 axis = Vec2::Zero();    ///< of a Turned face, on the grid; direction of a Lying one

    /// Radius of the section circle of a Turned face, of a torus' two circles the one nearer `hint_mm`.
    double radiusAt(double z_mm, double hint_mm) const;
};

/// A side of triangles: a stretch between two nodes, on an edge of the solid or inside a face.
struct MeshSide {
    int a = -1;  ///< node indices
    int b = -1;
    int edge = -1;   ///< edge of the solid, or -1 inside a face
    double t_a = 0;  ///< curve parameters of the nodes on that edge
    double t_b = 0;
};

/// Nodes counter-clockwise seen from outside; side k runs from node k to node k + 1.
struct MeshTriangle {
    int face = -1;
    std::array<int, 3> node{};
    std::array<int, 3> side{};
    std::array<gp_Pnt2d, 3> uv;
    std::array<double, 3> normal_z{};  ///< of the surface's outward unit normal at the nodes
    double bump_mm3 = 0;               ///< material between facet and surface; negative where that is hollow
};

/// A solid in setup coordinates as facets that know the exact surface and curve they stand for.
///
/// The facets give sections their topology (which faces a plane meets, in which order, where loops close:
/// neighbours share sides, so every chain of crossed facets closes); all coordinates come from the
/// surfaces and curves. Immutable after construction; safe to read from several threads.
class SolidMesh {
  public:
    /// \param chord_mm  sagitta of the facets; bounds what may be overlooked on free-form faces only
    /// \throws Error(GeometryKernel) if OCCT cannot make facets of a face.
    SolidMesh(const TopoDS_Shape& solid, const Eigen::Isometry3d& to_setup, double chord_mm,
              const Tolerances& tol);

    const std::vector<MeshFace>& faces() const { return faces_; }
    const std::vector<Vec3>& nodes() const { return nodes_; }
    const std::vector<MeshSide>& sides() const { return sides_; }
    const std::vector<MeshTriangle>& triangles() const { return triangles_; }
    const Handle(Geom_Curve) & curve(int edge) const { return curves_[edge]; }
    double chord_mm() const { return chord_mm_; }
    /// Indices of the triangles of each face.
    const std::vector<std::vector<int>>& trianglesOfFace() const { return of_face_; }
    /// Heights where a face's outline seen from above turns back, other than its ends: centres of spheres
    /// and of tori and horizontal cylinders.
    const std::vector<double>& silhouettes() const { return silhouettes_; }
    /// Sides that do not join exactly two triangles: gaps of the facets.
    int openSides() const { return open_sides_; }

  private:
    friend class MeshBuilder;
    double chord_mm_ = 0;
    std::vector<MeshFace> faces_;
    std::vector<Vec3> nodes_;
    std::vector<MeshSide> sides_;
    std::vector<MeshTriangle> triangles_;
    std::vector<std::vector<int>> of_face_;
    std::vector<Handle(Geom_Curve)> curves_;
    std::vector<double> silhouettes_;
    int open_sides_ = 0;
};

/// Facet sagitta that suits a solid of that size.
double facetChord(const Box3& bbox_mm);

}  // namespace stepmill::layers
