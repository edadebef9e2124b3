#include "report/sheets/scene.h"

#include <algorithm>
#include <array>

#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace stepmill::report {
namespace {

Vec3 lifted(const Vec2& p, double z_mm) {
    return {p.x(), p.y(), z_mm};
}

/// The upright walls under a chain of points that runs with the body on its left.
void addWalls(const std::vector<Vec2>& line, const Prism& prism, const Eigen::Isometry3d& placed,
              std::vector<Patch>& patches) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec2 along = line[i + 1] - line[i];
        if (along.norm() < kGridMm) continue;
        const Vec2 out = -leftOf(along).normalized();
        Patch wall;
        wall.normal = placed.linear() * Vec3(out.x(), out.y(), 0);
        wall.loops = {
            {placed * lifted(line[i], prism.bottom_z_mm), placed * lifted(line[i + 1], prism.bottom_z_mm),
             placed * lifted(line[i + 1], prism.top_z_mm), placed * lifted(line[i], prism.top_z_mm)}};
        patches.push_back(std::move(wall));
    }
}

Patch triangle(const std::array<Vec3, 3>& corners, bool reversed) {
    Patch facet;
    facet.loops = {{corners[0], corners[1], corners[2]}};
    const Vec3 across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double length = across.norm();
    facet.normal = length > 0 ? Vec3((reversed ? -1.0 : 1.0) / length * across) : Vec3(Vec3::Zero());
    return facet;
}

}  // namespace

Body prismBody(BodyKind kind, const Prism& prism, const Eigen::Isometry3d& placed, double chord_mm) {
    Body body{kind, {}};
    Patch top;
    Patch bottom;
    top.normal = placed.linear() * Vec3::UnitZ();
    bottom.normal = -top.normal;
    for (const Loop& loop : prism.region.loops) {
        const std::vector<Vec2> line = tessellate(loop, chord_mm);
        addWalls(line, prism, placed, body.patches);
        for (Patch* end : {&top, &bottom}) {
            const double z_mm = end == &top ? prism.top_z_mm : prism.bottom_z_mm;
            std::vector<Vec3>& corners = end->loops.emplace_back();
            for (std::size_t i = 0; i + 1 < line.size(); ++i)
                corners.push_back(placed * lifted(line[i], z_mm));
        }
    }
    body.patches.push_back(std::move(top));
    body.patches.push_back(std::move(bottom));
    return body;
}

Body facetBody(BodyKind kind, const TopoDS_Shape& solid, const Eigen::Isometry3d& placed) {
    Body body{kind, {}};
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
        TopLoc_Location location;
        const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(it.Current()), location);
        if (mesh.IsNull()) continue;
        for (int i = 1; i <= mesh->NbTriangles(); ++i) {
            std::array<int, 3> node{};
            mesh->Triangle(i).Get(node[0], node[1], node[2]);
            std::array<Vec3, 3> corners;
            for (int k = 0; k < 3; ++k) {
                const gp_Pnt at = mesh->Node(node[k]).Transformed(location.Transformation());
                corners[k] = placed * Vec3(at.X(), at.Y(), at.Z());
            }
            body.patches.push_back(triangle(corners, it.Current().Orientation() == TopAbs_REVERSED));
        }
    }
    return body;
}

}  // namespace stepmill::report
