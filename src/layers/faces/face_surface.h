#pragma once

#include <TopoDS_Face.hxx>

#include "layers/mesh/solid_mesh.h"

namespace stepmill::layers {

/// Kind, surface, orientation and, where the surface is simple, its numbers. Height range left open.
MeshFace describeFace(const TopoDS_Face& face, const Tolerances& tol);

/// Outward unit normal at surface parameters; zero where the surface has none.
Vec3 normalAt(const MeshFace& face, const gp_Pnt2d& uv);

/// Fills in what the surface says at the facets: normals, bumps, height range. A face whose normals are
/// all horizontal is vertical whatever its surface type.
void measureFacets(MeshFace& face, const std::vector<int>& facets, const std::vector<Vec3>& nodes,
                   std::vector<MeshTriangle>& triangles, const Tolerances& tol);

/// Lowest (direction -1) or highest (+1) point of a face whose edges end at `edge_z` and whose facet
/// nodes at `node_z`.
double innerExtreme(const MeshFace& face, double node_z, double edge_z, int direction, double chord_mm);

/// Widens [low, high] by how far a curve reaches along a direction between two parameters.
void widenByCurve(const Geom_Curve& curve, const Vec3& along, double t0, double t1, double& low,
                  double& high);

/// Adds the height, if any, where the face's outline seen from above turns back between its ends.
void addSilhouette(const MeshFace& face, std::vector<double>& heights);

}  // namespace stepmill::layers
