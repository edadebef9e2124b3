// A slab's part region covers the part at every height of the slab: no point of the part's surface lies
// outside it by more than the gouge budget.

#include <random>

#include <gtest/gtest.h>

#include "layers/mesh/solid_mesh.h"
#include "support/occt_solids.h"
#include "support/run_program.h"

using namespace stepmill;
using namespace stepmill::test;

namespace {

struct Worst {
    double outside_mm = 0;
    Vec3 at = Vec3::Zero();
};

/// Points surely on the part: of its edges, and of its faces where a facet has no side on an edge (beside
/// edges the facets' parameters may reach past the face).
std::vector<Vec3> pointsOfPart(const layers::SolidMesh& mesh, std::mt19937& random, int points_per_facet) {
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<Vec3> points;
    const auto add = [&](const gp_Pnt& p) { points.emplace_back(p.X(), p.Y(), p.Z()); };
    for (const layers::MeshSide& side : mesh.sides())
        if (side.edge >= 0)
            add(mesh.curve(side.edge)->Value(side.t_a + share(random) * (side.t_b - side.t_a)));
    for (const layers::MeshTriangle& triangle : mesh.triangles()) {
        bool inner = true;
        for (const int side : triangle.side)
            inner = inner && mesh.sides()[side].edge < 0;
        for (int i = 0; inner && i < points_per_facet; ++i) {
            const double a = share(random);
            const double b = (1 - a) * share(random);
            const double c = 1 - a - b;
            add(mesh.faces()[triangle.face].surface->Value(
                a * triangle.uv[0].X() + b * triangle.uv[1].X() + c * triangle.uv[2].X(),
                a * triangle.uv[0].Y() + b * triangle.uv[1].Y() + c * triangle.uv[2].Y()));
        }
    }
    return points;
}

/// The point farthest outside the slab it lies in. The last half micrometre at a slab's ends is left out:
/// the sections are cut there.
Worst worstPoint(const Setup& setup, const LayerStack& stack, std::mt19937& random, int points_per_facet) {
    const Tolerances tol;
    const layers::SolidMesh mesh(setup.part.shape->solid, setup.part_to_setup,
                                 layers::facetChord(setup.part.bbox_mm), tol);
    Worst worst;
    for (const Vec3& p : pointsOfPart(mesh, random, points_per_facet)) {
        for (const Layer& layer : stack.layers) {
            const double inset = 0.6 * tol.gouge_mm;
            if (p.z() > layer.top_z_mm - inset || p.z() < layer.bottom_z_mm + inset) continue;
            if (contains(layer.part, p.head<2>())) continue;
            const double outside = distanceToBoundary(layer.part, p.head<2>());
            if (outside > worst.outside_mm) worst = {outside, p};
        }
    }
    return worst;
}

void expectOneSided(const Setup& setup, std::mt19937& random, int points_per_facet) {
    const Tolerances tol;
    const LayerStack stack = slice(setup, tol);
    const Worst worst = worstPoint(setup, stack, random, points_per_facet);
    EXPECT_LE(worst.outside_mm, tol.gouge_mm) << worst.at.transpose();
}

TopoDS_Shape leaningBlock(std::mt19937& random) {
    const auto pick = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    TopoDS_Shape shape = BRepPrimAPI_MakeWedge(80, 30, 60, pick(0, 15), pick(0, 15), 70, 50).Shape();
    for (int i = 0; i < 2; ++i) {
        const gp_Ax2 tilted(gp_Pnt(pick(20, 60), -10, pick(15, 45)),
                            gp_Dir(pick(-0.6, 0.6), 1, pick(-0.6, 0.6)));
        shape = cut(shape, BRepPrimAPI_MakeCylinder(tilted, pick(1, 5), 80).Shape());
    }
    const gp_Ax2 pin(gp_Pnt(pick(20, 60), 10, 50), gp_Dir(pick(-0.5, 0.5), pick(-0.5, 0.5), 1));
    shape = BRepAlgoAPI_Fuse(shape, BRepPrimAPI_MakeCylinder(pin, pick(2, 4), 30).Shape()).Shape();
    return cut(shape,
               BRepPrimAPI_MakeSphere(gp_Pnt(pick(10, 70), pick(5, 35), pick(10, 50)), pick(3, 10)).Shape());
}

}  // namespace

TEST(OneSided, HoldsOnLeaningBlocks) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        std::mt19937 random(seed);
        const Part block = part(leaningBlock(random));
        for (const char* axis : {"+y", "-y", "+x", "+z"}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + " axis " + axis);
            expectOneSided(setupOf(block, *parseAxis(axis)), random, 4);
        }
    }
}

TEST(OneSided, HoldsOnRealPartsWithFilletsAndDrafts) {
    std::mt19937 random(3);
    for (const char* folder : {"machined", "nist"})
        for (const std::string& file : sharedParts(folder)) {
            bool wanted = false;
            for (const char* name : {"boxblend_03", "hole_model", "ftc_06"})
                wanted = wanted || file.find(name) != std::string::npos;
            if (!wanted) continue;
            SCOPED_TRACE(file);
            expectOneSided(setupOf(readStep(file).front(), *parseAxis("+y")), random, 1);
        }
}
