// Which faces meet, and whether the edge between them is an inner or an outer one.

#include <map>

#include "layers/faces/face_surface.h"
#include "layers/faces/trace_faces.h"
#include "stepmill/core/units.h"

namespace stepmill::layers {

namespace {

struct SideUse {
    int triangle = -1;
    int corner = 0;
};

/// What two faces share.
struct Shared {
    double length_mm = 0;
    double longest_mm = 0;
    EdgeSense sense = EdgeSense::Tangent;
};

/// Outward normal of the surface in the middle of a facet's side; of the facet where the surface has none.
Vec3 normalBeside(const SolidMesh& mesh, const SideUse& use) {
    const MeshTriangle& triangle = mesh.triangles()[use.triangle];
    const gp_Pnt2d& a = triangle.uv[use.corner];
    const gp_Pnt2d& b = triangle.uv[(use.corner + 1) % 3];
    const Vec3 normal =
        normalAt(mesh.faces()[triangle.face], gp_Pnt2d((a.X() + b.X()) / 2, (a.Y() + b.Y()) / 2));
    if (normal.squaredNorm() > 0.5) return normal;
    const Vec3& p = mesh.nodes()[triangle.node[0]];
    return (mesh.nodes()[triangle.node[1]] - p).cross(mesh.nodes()[triangle.node[2]] - p).normalized();
}

EdgeSense senseOf(const SolidMesh& mesh, const SideUse& a, const SideUse& b) {
    constexpr double kTangent = kPi / 180;
    const Vec3 turn = normalBeside(mesh, a).cross(normalBeside(mesh, b));
    const MeshTriangle& triangle = mesh.triangles()[a.triangle];
    const Vec3 along =
        (mesh.nodes()[triangle.node[(a.corner + 1) % 3]] - mesh.nodes()[triangle.node[a.corner]])
            .normalized();
    const double sine = turn.dot(along);
    if (std::abs(sine) < std::sin(kTangent)) return EdgeSense::Tangent;
    return sine > 0 ? EdgeSense::Convex : EdgeSense::Concave;
}

}  // namespace

std::vector<std::vector<FaceNeighbour>> findNeighbours(const SolidMesh& mesh) {
    std::vector<std::vector<SideUse>> uses(mesh.sides().size());
    for (std::size_t t = 0; t < mesh.triangles().size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int side = mesh.triangles()[t].side[k];
            if (mesh.sides()[side].edge >= 0) uses[side].push_back({static_cast<int>(t), k});
        }
    std::map<std::pair<int, int>, Shared> shared;
    // Of every edge its longest side tells the sense; of several common edges the one with the longest.
    for (std::size_t s = 0; s < uses.size(); ++s) {
        if (uses[s].size() != 2) continue;
        const int a = mesh.triangles()[uses[s][0].triangle].face;
        const int b = mesh.triangles()[uses[s][1].triangle].face;
        if (a == b) continue;
        const double length = (mesh.nodes()[mesh.sides()[s].a] - mesh.nodes()[mesh.sides()[s].b]).norm();
        Shared& common = shared[{std::min(a, b), std::max(a, b)}];
        common.length_mm += length;
        if (length <= common.longest_mm) continue;
        common.longest_mm = length;
        common.sense = senseOf(mesh, uses[s][0], uses[s][1]);
    }
    std::vector<std::vector<FaceNeighbour>> out(mesh.faces().size());
    for (const auto& [faces, common] : shared) {
        out[faces.first].push_back({faces.second, common.sense, common.length_mm});
        out[faces.second].push_back({faces.first, common.sense, common.length_mm});
    }
    for (std::vector<FaceNeighbour>& neighbours : out)
        std::sort(neighbours.begin(), neighbours.end(),
                  [](const FaceNeighbour& a, const FaceNeighbour& b) { return a.face < b.face; });
    return out;
}

}  // namespace stepmill::layers
