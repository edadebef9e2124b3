// Triangles against the solid they are made of.

#include "part/mesh_check.h"

#include <gtest/gtest.h>
#include <numbers>

#include <BRep_Builder.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include "part/measure.h"
#include "stepmill/core/error.h"
#include "support/closed_curves.h"

namespace stepmill {
namespace {

/// The solid with one of its faces turned over.
TopoDS_Shape withFaceTurned(const TopoDS_Shape& solid, int turned) {
    const BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    int index = 0;
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
        builder.Add(shell, index++ == turned ? it.Current().Reversed() : it.Current());
    TopoDS_Solid result;
    builder.MakeSolid(result);
    builder.Add(result, shell);
    return result;
}

TEST(MeshVolume, IsOneNumberForASoundSolid) {
    const MeshVolume box = meshVolume(BRepPrimAPI_MakeBox(10, 20, 30).Solid());
    EXPECT_NEAR(box.mean_mm3, 6000, 1e-9);
    EXPECT_LT(box.spread_mm3, 1e-9);
    const MeshVolume pin = meshVolume(BRepPrimAPI_MakeCylinder(5, 20).Solid());
    EXPECT_LT(pin.spread_mm3, 1e-9 * pin.mean_mm3);
}

TEST(MeshVolume, TellsEveryFaceThatIsTurnedOver) {
    const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(5, 20).Solid();
    const double volume_mm3 = 500 * std::numbers::pi;
    for (int face = 0; face < 3; ++face) {
        const TopoDS_Shape turned = withFaceTurned(pin, face);
        EXPECT_GT(meshVolume(turned).spread_mm3, 100) << "face " << face;
        EXPECT_THROW(requireMesh(turned, volume_mm3, "pin"), Error);
    }
    EXPECT_NO_THROW(requireMesh(pin, volume_mm3, "pin"));
}

TEST(RequireMesh, TakesClosedSplines) {
    for (int turned = 0; turned < 24; ++turned) {
        std::vector<double> radii_mm;
        for (int i = 0; i < 12; ++i)
            radii_mm.push_back(30 + 4 * std::sin(0.26 * turned + 2 * std::numbers::pi * i / 12));
        const TopoDS_Shape solid =
            test::prismIn(BRepBuilderAPI_MakeEdge(test::closedSpline(radii_mm)).Edge(), 10);
        EXPECT_NO_THROW(requireMesh(solid, volumeOf(solid), "cam")) << turned;
    }
}

}  // namespace
}  // namespace stepmill
