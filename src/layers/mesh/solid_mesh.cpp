// Facets of a solid with the surfaces and curves they stand for.

#include "layers/mesh/solid_mesh.h"

#include <BRep_Tool.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <gp_Trsf.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "layers/faces/face_surface.h"
#include "stepmill/core/error.h"
#include "stepmill/part/part_shape.h"

namespace stepmill::layers {

double facetChord(const Box3& bbox_mm) {
    const double size = bbox_mm.diagonal().norm();
    // Half a tenth of a millimetre is fine enough for all but giants: facets find what a section meets, the
    // surfaces say where.
    return std::clamp(size * 1e-4, 5e-4, std::max(5e-2, size * 1e-5));
}

namespace {

constexpr double kFacetAngle = 0.25;  // rad between the normals of neighbouring facets

std::pair<int, int> unorderedPair(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

TopoDS_Shape movedCopy(const TopoDS_Shape& solid, const Eigen::Isometry3d& to_setup) {
    const Eigen::Matrix3d& r = to_setup.linear();
    const Vec3 t = to_setup.translation();
    gp_Trsf move;
    move.SetValues(r(0, 0), r(0, 1), r(0, 2), t.x(), r(1, 0), r(1, 1), r(1, 2), t.y(), r(2, 0), r(2, 1),
                   r(2, 2), t.z());
    // A deep copy: facets are stored on the shape, and the caller's shape must not change.
    return BRepBuilderAPI_Transform(solid, move, true).Shape();
}

}  // namespace

/// Collects the facets face by face, naming nodes and sides that faces share by edge and vertex.
class MeshBuilder {
  public:
    MeshBuilder(SolidMesh& mesh, const TopoDS_Shape& shape, const Tolerances& tol)
        : mesh_(mesh), shape_(shape), tol_(tol) {
        TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
        TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
    }

    void build() {
        addCurves();
        int index = 0;
        for (TopExp_Explorer it(shape_, TopAbs_FACE); it.More(); it.Next(), ++index)
            addFace(TopoDS::Face(it.Current()), index);
        countOpenSides();
        orientOutward();
        for (std::size_t i = 0; i < mesh_.faces_.size(); ++i) {
            measureFacets(mesh_.faces_[i], mesh_.of_face_[i], mesh_.nodes_, mesh_.triangles_, tol_);
            addSilhouette(mesh_.faces_[i], mesh_.silhouettes_);
        }
    }

  private:
    void addCurves() {
        mesh_.curves_.resize(edges_.Extent());
        edge_nodes_.resize(edges_.Extent());
        edge_sides_.resize(edges_.Extent());
        vertex_nodes_.assign(vertices_.Extent(), -1);
        for (int i = 1; i <= edges_.Extent(); ++i) {
            double first = 0;
            double last = 0;
            mesh_.curves_[i - 1] = BRep_Tool::Curve(TopoDS::Edge(edges_(i)), first, last);
        }
    }

    int newNode(const gp_Pnt& p) {
        mesh_.nodes_.emplace_back(p.X(), p.Y(), p.Z());
        return static_cast<int>(mesh_.nodes_.size()) - 1;
    }

    int vertexNode(const TopoDS_Vertex& vertex) {
        int& node = vertex_nodes_[vertices_.FindIndex(vertex) - 1];
        if (node < 0) node = newNode(BRep_Tool::Pnt(vertex));
        return node;
    }

    /// Node i of the edge's polygon; the polygon runs with the curve's parameter in every face.
    const std::vector<int>& nodesOfEdge(int edge, const std::vector<gp_Pnt>& points) {
        std::vector<int>& nodes = edge_nodes_[edge];
        if (!nodes.empty()) return nodes;
        const TopoDS_Edge e = TopoDS::Edge(edges_(edge + 1).Oriented(TopAbs_FORWARD));
        const TopoDS_Vertex first = TopExp::FirstVertex(e);
        const TopoDS_Vertex last = TopExp::LastVertex(e);
        const bool collapsed = BRep_Tool::Degenerated(e);
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!first.IsNull() && (i == 0 || collapsed)) {
                nodes.push_back(vertexNode(first));
            } else if (!last.IsNull() && i + 1 == points.size()) {
                nodes.push_back(vertexNode(last));
            } else {
                nodes.push_back(newNode(points[i]));
            }
        }
        return nodes;
    }

    void addEdgePolygon(const TopoDS_Edge& edge, const Handle(Poly_PolygonOnTriangulation) & polygon,
                        const std::vector<gp_Pnt>& points, std::vector<int>& local_to_node,
                        std::map<std::pair<int, int>, int>& side_of_pair) {
        const int index = edges_.FindIndex(edge) - 1;
        const int count = polygon->NbNodes();
        std::vector<gp_Pnt> on_edge;
        for (int i = 1; i <= count; ++i)
            on_edge.push_back(points[polygon->Node(i) - 1]);
        const std::vector<int>& nodes = nodesOfEdge(index, on_edge);
        STEPMILL_CHECK(static_cast<int>(nodes.size()) == count, "faces disagree on the facets of an edge");
        std::vector<int>& sides = edge_sides_[index];
        const bool first_visit = sides.empty();
        for (int i = 0; i < count; ++i) {
            local_to_node[polygon->Node(i + 1) - 1] = nodes[i];
            if (i + 1 == count) break;
            if (first_visit) {
                MeshSide side{nodes[i], nodes[i + 1], index, 0, 0};
                if (polygon->HasParameters() && !mesh_.curves_[index].IsNull()) {
                    side.t_a = polygon->Parameter(i + 1);
                    side.t_b = polygon->Parameter(i + 2);
                } else {
                    side.edge = -1;
                }
                sides.push_back(newSide(side));
            }
            side_of_pair[unorderedPair(polygon->Node(i + 1) - 1, polygon->Node(i + 2) - 1)] = sides[i];
        }
    }

    int newSide(const MeshSide& side) {
        mesh_.sides_.push_back(side);
        return static_cast<int>(mesh_.sides_.size()) - 1;
    }

    void addFace(const TopoDS_Face& face, int index) {
        TopLoc_Location location;
        const Handle(Poly_Triangulation) facets = BRep_Tool::Triangulation(face, location);
        if (facets.IsNull() || facets->NbTriangles() == 0)
            throw Error(ErrorCode::GeometryKernel, "face " + std::to_string(index),
                        "cannot be turned into facets");
        std::vector<gp_Pnt> points;
        for (int i = 1; i <= facets->NbNodes(); ++i)
            points.push_back(facets->Node(i).Transformed(location.Transformation()));
        std::vector<int> local_to_node(points.size(), -1);
        std::map<std::pair<int, int>, int> side_of_pair;
        for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
            const TopoDS_Edge edge = TopoDS::Edge(it.Current());
            const Handle(Poly_PolygonOnTriangulation) polygon =
                BRep_Tool::PolygonOnTriangulation(edge, facets, location);
            if (!polygon.IsNull()) addEdgePolygon(edge, polygon, points, local_to_node, side_of_pair);
        }
        for (std::size_t i = 0; i < points.size(); ++i)
            if (local_to_node[i] < 0) local_to_node[i] = newNode(points[i]);
        addTriangles(face, index, *facets, local_to_node, side_of_pair);
        MeshFace info = describeFace(face, tol_);
        heightRange(face, index, info);
        mesh_.faces_.push_back(info);
    }

    void addTriangles(const TopoDS_Face& face, int index, const Poly_Triangulation& facets,
                      const std::vector<int>& local_to_node,
                      std::map<std::pair<int, int>, int>& side_of_pair) {
        mesh_.of_face_.emplace_back();
        const bool reversed = face.Orientation() == TopAbs_REVERSED;
        for (int i = 1; i <= facets.NbTriangles(); ++i) {
            std::array<int, 3> local{};
            facets.Triangle(i).Get(local[0], local[1], local[2]);
            if (reversed) std::swap(local[1], local[2]);
            MeshTriangle triangle;
            triangle.face = index;
            for (int k = 0; k < 3; ++k) {
                triangle.node[k] = local_to_node[local[k] - 1];
                if (facets.HasUVNodes()) triangle.uv[k] = facets.UVNode(local[k]);
                const auto key = unorderedPair(local[k] - 1, local[(k + 1) % 3] - 1);
                auto found = side_of_pair.find(key);
                if (found == side_of_pair.end())
                    found =
                        side_of_pair
                            .emplace(key,
                                     newSide({local_to_node[key.first], local_to_node[key.second], -1, 0, 0}))
                            .first;
                triangle.side[k] = found->second;
            }
            mesh_.of_face_.back().push_back(static_cast<int>(mesh_.triangles_.size()));
            mesh_.triangles_.push_back(triangle);
        }
    }

    /// Lowest and highest point of the face: of its edges, exactly, and of its inside.
    void heightRange(const TopoDS_Face& face, int index, MeshFace& info) const {
        info.z_min_mm = 1e300;
        info.z_max_mm = -1e300;
        for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
            const int edge = edges_.FindIndex(it.Current()) - 1;
            const auto [low, high] = edgeHeights(edge);
            info.z_min_mm = std::min(info.z_min_mm, low);
            info.z_max_mm = std::max(info.z_max_mm, high);
        }
        if (info.kind == FaceKind::Plane) return;
        double low = info.z_min_mm;
        double high = info.z_max_mm;
        for (const int t : mesh_.of_face_[index])
            for (const int node : mesh_.triangles_[t].node) {
                low = std::min(low, mesh_.nodes_[node].z());
                high = std::max(high, mesh_.nodes_[node].z());
            }
        info.z_min_mm = innerExtreme(info, low, info.z_min_mm, -1, mesh_.chord_mm_);
        info.z_max_mm = innerExtreme(info, high, info.z_max_mm, 1, mesh_.chord_mm_);
    }

    std::pair<double, double> edgeHeights(int edge) const {
        const std::vector<int>& nodes = edge_nodes_[edge];
        double low = 1e300;
        double high = -1e300;
        for (const int node : nodes) {
            low = std::min(low, mesh_.nodes_[node].z());
            high = std::max(high, mesh_.nodes_[node].z());
        }
        if (mesh_.curves_[edge].IsNull()) return {low, high};
        for (const int s : edge_sides_[edge]) {
            const MeshSide& side = mesh_.sides_[s];
            if (side.edge >= 0)
                widenByCurve(*mesh_.curves_[edge], Vec3::UnitZ(), side.t_a, side.t_b, low, high);
        }
        return {low, high};
    }

    void countOpenSides() {
        std::vector<int> uses(mesh_.sides_.size(), 0);
        for (const MeshTriangle& triangle : mesh_.triangles_)
            for (const int side : triangle.side)
                ++uses[side];
        for (std::size_t i = 0; i < uses.size(); ++i)
            if (uses[i] != 2 && mesh_.sides_[i].a != mesh_.sides_[i].b) ++mesh_.open_sides_;
    }

    /// A solid read inside out encloses a negative volume.
    void orientOutward() {
        double six_volumes = 0;
        const Vec3 origin = mesh_.nodes_.front();
        for (const MeshTriangle& t : mesh_.triangles_)
            six_volumes +=
                (mesh_.nodes_[t.node[0]] - origin)
                    .dot((mesh_.nodes_[t.node[1]] - origin).cross(mesh_.nodes_[t.node[2]] - origin));
        if (six_volumes >= 0) return;
        for (MeshTriangle& t : mesh_.triangles_) {
            std::swap(t.node[1], t.node[2]);
            std::swap(t.uv[1], t.uv[2]);
            std::swap(t.side[0], t.side[2]);
        }
        for (MeshFace& face : mesh_.faces_) {
            face.reversed = !face.reversed;
            face.normal = -face.normal;
            face.offset_mm = -face.offset_mm;
        }
    }

    SolidMesh& mesh_;
    TopoDS_Shape shape_;
    const Tolerances& tol_;
    TopTools_IndexedMapOfShape edges_;
    TopTools_IndexedMapOfShape vertices_;
    std::vector<int> vertex_nodes_;
    std::vector<std::vector<int>> edge_nodes_;
    std::vector<std::vector<int>> edge_sides_;
};

SolidMesh::SolidMesh(const TopoDS_Shape& solid, const Eigen::Isometry3d& to_setup, double chord_mm,
                     const Tolerances& tol)
    : chord_mm_(chord_mm) {
    guardOcct(ErrorCode::GeometryKernel, "facets of the solid", [&] {
        const TopoDS_Shape shape = movedCopy(solid, to_setup);
        makeFacets(shape, chord_mm, kFacetAngle);
        MeshBuilder(*this, shape, tol).build();
    });
}

}  // namespace stepmill::layers
