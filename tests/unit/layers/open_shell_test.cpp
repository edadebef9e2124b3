#include <gtest/gtest.h>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>

#include "layers/mesh/solid_mesh.h"
#include "layers/section/hull_section.h"
#include "layers/section/section.h"
#include "layers/slab/slab.h"
#include "support/occt_solids.h"

using namespace stepmill;
using namespace stepmill::test;

namespace {

/// The shape's faces but for one.
TopoDS_Shape withoutFace(const TopoDS_Shape& shape, int left_out) {
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    int index = 0;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next(), ++index)
        if (index != left_out) builder.Add(compound, it.Current());
    return compound;
}

layers::SolidMesh meshOf(const TopoDS_Shape& shape) {
    return layers::SolidMesh(shape, Eigen::Isometry3d::Identity(), 0.01, Tolerances{});
}

}  // namespace

TEST(HullSection, HullOfPointsIsConvexAndCounterClockwise) {
    const std::vector<Vec2> hull =
        layers::convexHull({{0, 0}, {2, 0}, {1, 0.5}, {2, 2}, {0, 2}, {1, 1}, {1, 0}});
    EXPECT_EQ(hull, (std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST(HullSection, GrownHullHoldsTheDiscsAboutItsPoints) {
    const Region grown = layers::grownHull({{0, 0}, {5, 0}}, 1);
    EXPECT_FALSE(diagnose(grown).has_value());
    EXPECT_GE(distanceToBoundary(grown, Vec2(0, 0)), 1);
    EXPECT_GE(distanceToBoundary(grown, Vec2(5, 0)), 1);
    EXPECT_LE(distanceToBoundary(grown, Vec2(2, 0)), 1.1);
}

TEST(OpenShell, AMissingWallCostsAccuracyNotThePart) {
    const TopoDS_Shape block = box(0, 0, 0, 40, 30, 10);
    const Tolerances tol;
    for (int face = 0; face < 6; ++face) {
        SCOPED_TRACE(face);
        const layers::SolidMesh mesh = meshOf(withoutFace(block, face));
        const layers::SlabCut cut = layers::cutSlab(mesh, 10, 0, SliceOptions{}, tol);
        EXPECT_FALSE(diagnose(cut.region).has_value());
        EXPECT_GE(area(cut.region), 1200 - 1e-6);
        EXPECT_LE(area(cut.region), 1200 + 140 * 0.03);
        // Faces 4 and 5 are the horizontal ones; sections do not meet them.
        EXPECT_EQ(cut.remarks.empty(), layers::exactSection(mesh, 5, tol).has_value());
        if (!cut.remarks.empty()) {
            EXPECT_GT(cut.mended_by_mm, 0);
        }
    }
}

TEST(OpenShell, AnOpenHoleIsFilledAndSaysByHowMuch) {
    const TopoDS_Shape block = cut(box(0, 0, 0, 40, 30, 10), box(10, 10, -1, 8, 6, 20));
    const Tolerances tol;
    int mended = 0;
    for (int face = 0; face < 10; ++face) {
        const layers::SolidMesh mesh = meshOf(withoutFace(block, face));
        const layers::SlabCut slab = layers::cutSlab(mesh, 10, 0, SliceOptions{}, tol);
        EXPECT_GE(area(slab.region), 1200 - 48 - 1e-6) << face;
        if (area(slab.region) > 1190) {
            ++mended;
            EXPECT_GE(slab.mended_by_mm, 3) << face;
            EXPECT_FALSE(slab.remarks.empty());
        }
    }
    EXPECT_EQ(mended, 4);
}
