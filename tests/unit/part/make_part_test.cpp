#include <gtest/gtest.h>
#include <BRep_Builder.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>

#include "part/measure.h"
#include "part/step/heal.h"
#include "stepmill/core/units.h"
#include "stepmill/part/part_shape.h"
#include "support/closed_curves.h"

namespace stepmill {
namespace {

constexpr double kLength_mm = 1e-9;
constexpr double kRelative = 1e-9;

TopoDS_Shape block() {
    return BRepPrimAPI_MakeBox(gp_Pnt(1, 2, 3), gp_Pnt(11, 22, 33)).Shape();
}

TopoDS_Compound compoundOf(const std::vector<TopoDS_Shape>& shapes) {
    TopoDS_Compound compound;
    BRep_Builder builder;
    builder.MakeCompound(compound);
    for (const TopoDS_Shape& shape : shapes)
        builder.Add(compound, shape);
    return compound;
}

/// The block with its last face left out, still called a solid.
TopoDS_Shape openBlock() {
    BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    const std::vector<TopoDS_Face> faces = facesOf(block());
    for (std::size_t i = 0; i + 1 < faces.size(); ++i)
        builder.Add(shell, faces[i]);
    return BRepBuilderAPI_MakeSolid(shell).Shape();
}

template <class Work>
std::optional<ErrorCode> codeOf(Work&& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.code();
    }
    return std::nullopt;
}

TEST(MakePart, MeasuresABlock) {
    const Part part = makePart(block(), "block");
    EXPECT_EQ(part.name, "block");
    EXPECT_NEAR((part.bbox_mm.min() - Vec3(1, 2, 3)).norm(), 0, kLength_mm);
    EXPECT_NEAR((part.bbox_mm.max() - Vec3(11, 22, 33)).norm(), 0, kLength_mm);
    EXPECT_NEAR(part.volume_mm3, 6000, 6000 * kRelative);
    EXPECT_EQ(part.surfaces, (std::map<std::string, int>{{"plane", 6}}));
    ASSERT_EQ(part.faces.size(), 6U);
    EXPECT_EQ(part.faces[5].index, 5);
}

TEST(MakePart, TheBoxOfARoundPartIsTight) {
    const Part part = makePart(BRepPrimAPI_MakeCylinder(7, 4).Shape(), "disc");
    EXPECT_NEAR(part.bbox_mm.sizes().x(), 14, 1e-6);
    EXPECT_NEAR(part.bbox_mm.sizes().y(), 14, 1e-6);
    EXPECT_NEAR(part.bbox_mm.sizes().z(), 4, 1e-6);
    EXPECT_NEAR(part.volume_mm3, kPi * 49 * 4, 1e-6);
    EXPECT_EQ(part.surfaces, (std::map<std::string, int>{{"cylinder", 1}, {"plane", 2}}));
}

TEST(MakePart, TakesTheOnlySolidOfACompound) {
    EXPECT_NEAR(makePart(compoundOf({block()}), "block").volume_mm3, 6000, 1e-6);
}

TEST(MakePart, RefusesTwoSolidsAndNone) {
    const TopoDS_Shape other = BRepPrimAPI_MakeBox(gp_Pnt(50, 0, 0), 1, 1, 1).Shape();
    EXPECT_EQ(codeOf([&] { makePart(compoundOf({block(), other}), "two"); }), ErrorCode::InvalidSolid);
    EXPECT_EQ(codeOf([&] { makePart(compoundOf({}), "none"); }), ErrorCode::InvalidSolid);
    EXPECT_EQ(codeOf([&] { makePart(TopoDS_Shape(), "null"); }), ErrorCode::InvalidSolid);
}

TEST(MakePart, RefusesASolidWithAHoleInItsShell) {
    EXPECT_EQ(countFreeEdges(openBlock()), 4);
    EXPECT_EQ(codeOf([&] { makePart(openBlock(), "open"); }), ErrorCode::InvalidSolid);
}

TEST(GuardOcct, TurnsAKernelFailureIntoAnErrorThatNamesIt) {
    try {
        guardOcct(ErrorCode::GeometryKernel, "face 3", [] { throw Standard_Failure("no luck"); });
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::GeometryKernel);
        EXPECT_EQ(error.subject(), "face 3");
        EXPECT_NE(std::string(error.what()).find("no luck"), std::string::npos);
    }
}

TEST(GuardOcct, LetsOtherErrorsThrough) {
    EXPECT_EQ(codeOf([] {
                  guardOcct(ErrorCode::GeometryKernel, "x",
                            [] { throw Error(ErrorCode::NoSolid, "y", "z"); });
              }),
              ErrorCode::NoSolid);
}

TEST(HealSolid, TurnsASolidThatIsInsideOut) {
    ShapeNames names;
    std::vector<Remark> remarks;
    const TopoDS_Shape inside_out = block().Reversed();
    ASSERT_LT(volumeOf(inside_out), 0);
    const HealedSolid healed = healSolid(inside_out, "block", names, remarks);
    EXPECT_NEAR(volumeOf(healed.shape), 6000, 1e-6);
    EXPECT_NEAR(healed.volume_mm3, 6000, 1e-6);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].text.find("inside out"), std::string::npos);
}

TEST(HealSolid, LeavesAGoodSolidAloneAndRefusesAnOpenOne) {
    ShapeNames names;
    std::vector<Remark> remarks;
    const TopoDS_Shape good = block();
    EXPECT_TRUE(healSolid(good, "block", names, remarks).shape.IsEqual(good));
    EXPECT_TRUE(remarks.empty());
    EXPECT_EQ(codeOf([&] { healSolid(openBlock(), "open", names, remarks); }), ErrorCode::OpenShell);
}

TEST(ScaleSolid, ScalesLengthsAndKeepsShapeNames) {
    ShapeNames names;
    const TopoDS_Shape small = block();
    const std::vector<TopoDS_Face> faces = facesOf(small);
    for (std::size_t i = 0; i < faces.size(); ++i)
        names.set(faces[i], std::to_string(i));
    const TopoDS_Shape large = scaleSolid(small, 25.4, names);
    EXPECT_NEAR(boxOf(large).max().z(), 33 * 25.4, 1e-7);
    const std::vector<TopoDS_Face> scaled = facesOf(large);
    ASSERT_EQ(scaled.size(), faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
        EXPECT_EQ(names.of(scaled[i]), std::to_string(i));
}

TEST(Misfit, IsNothingOnACleanBoolean) {
    const TopoDS_Shape bored =
        BRepAlgoAPI_Cut(block(), BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(6, 12, 0), gp::DZ()), 3, 40).Shape())
            .Shape();
    const Misfit misfit = measureMisfit(bored, largestGap(boxOf(bored)), largestGap(boxOf(bored)));
    EXPECT_EQ(misfit.vertices_off + misfit.edges_off, 0);
    EXPECT_LT(misfit.vertex_mm, 1e-9);
    EXPECT_LT(misfit.edge_mm, 1e-9);
}

/// A star with round rays: a periodic spline of that many spans.
Handle(Geom_BSplineCurve) star(int spans) {
    std::vector<double> radii_mm;
    for (int i = 0; i < spans; ++i)
        radii_mm.push_back(10 + 0.8 * std::sin(9 * 2 * kPi * i / spans));
    return test::closedSpline(radii_mm, gp_Pnt(30, 20, 0));
}

// The kernel's own integrals are 0.5 to 5 % off here.
TEST(VolumeOf, SeesTheSpansOfSweptSplines) {
    for (const int spans : {8, 40, 120}) {
        const Handle(Geom_BSplineCurve) curve = star(spans);
        constexpr int kChords = 100000;
        double twice_mm2 = 0;
        double length_mm = 0;
        gp_Pnt from = curve->Value(curve->FirstParameter());
        for (int i = 1; i <= kChords; ++i) {
            const double share = static_cast<double>(i) / kChords;
            const gp_Pnt to =
                curve->Value((1 - share) * curve->FirstParameter() + share * curve->LastParameter());
            twice_mm2 += from.X() * to.Y() - to.X() * from.Y();
            length_mm += from.Distance(to);
            from = to;
        }
        const TopoDS_Shape solid = test::prismIn(BRepBuilderAPI_MakeEdge(curve).Edge(), 3);
        EXPECT_NEAR(std::abs(volumeOf(solid)), 1.5 * std::abs(twice_mm2), 1e-5 * std::abs(twice_mm2))
            << spans;
        EXPECT_NEAR(areaOf(solid), std::abs(twice_mm2) + 3 * length_mm, 1e-5 * std::abs(twice_mm2)) << spans;
    }
}

}  // namespace
}  // namespace stepmill
