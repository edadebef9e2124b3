#include "report/sheets/scene.h"

#include "report/page/facets.h"
#include "report/page/hidden_lines.h"
#include "stepmill/part/part_shape.h"

namespace stepmill::report {
namespace {

/// Facets of curved faces turn by no more than this from one to the next [rad].
constexpr double kFacetAngle = 0.12;

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

Patch patchOf(const SolidFacet& facet, const Eigen::Isometry3d& placed) {
    Patch patch;
    std::vector<Vec3>& corners = patch.loops.emplace_back();
    for (const Vec3& corner : facet.corners)
        corners.push_back(placed * corner);
    const Vec3 across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double length = across.norm();
    patch.normal = length > 0 ? Vec3((facet.reversed ? -1.0 : 1.0) / length * across) : Vec3(Vec3::Zero());
    return patch;
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
    for (const SolidFacet& facet : facetsOf(solid))
        body.patches.push_back(patchOf(facet, placed));
    return body;
}

std::vector<Body> arrivingStock(const Setup& setup, double chord_mm) {
    const TopoDS_Shape raw = solidIn(*setup.stock.shape, setup.part_to_setup);
    makeFacets(raw, chord_mm, kFacetAngle);
    std::vector<Body> bodies{facetBody(BodyKind::Raw, raw, Eigen::Isometry3d::Identity())};
    for (const CutPrisms& cut : setup.stock.cuts)
        for (const Prism& prism : cut.prisms)
            bodies.push_back(
                prismBody(BodyKind::Cut, prism, setup.part_to_setup * cut.part_to_setup.inverse(), chord_mm));
    return bodies;
}

}  // namespace stepmill::report
