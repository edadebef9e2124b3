#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <gp_Elips.hxx>
#include <ShapeCustom.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <fmt/format.h>

#include "part/measure.h"
#include "part/step/elementary_solid.h"
#include "stepmill/part/face_graph.h"
#include "stepmill/part/part_shape.h"
#include "support/closed_curves.h"

namespace stepmill {
namespace {

TopoDS_Shape onlySolid(const TopoDS_Shape& shape) {
    return TopExp_Explorer(shape, TopAbs_SOLID).Current();
}

/// Everything a spline, as exporters write it that know nothing else.
TopoDS_Shape splined(const TopoDS_Shape& solid) {
    return onlySolid(BRepBuilderAPI_NurbsConvert(solid, true).Shape());
}

/// A block with a hole, a countersink, a round pocket floor and a rounded edge.
TopoDS_Shape shopBlock() {
    TopoDS_Shape block = BRepPrimAPI_MakeBox(40, 30, 20).Shape();
    const auto upright = [](double x, double y, double z) { return gp_Ax2(gp_Pnt(x, y, z), gp::DZ()); };
    block = BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCylinder(upright(10, 10, -1), 3, 30)).Shape();
    block = BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCone(upright(10, 10, 17), 3, 6, 3)).Shape();
    block = BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeSphere(gp_Pnt(28, 14, 22), 8)).Shape();
    BRepFilletAPI_MakeFillet fillet(block);
    for (TopExp_Explorer edges(block, TopAbs_EDGE); edges.More(); edges.Next()) {
        const Box3 box = boxOf(edges.Current());
        if (box.min().x() > 39 && box.sizes().y() > 29 && box.min().z() > 19)
            fillet.Add(2, TopoDS::Edge(edges.Current()));
    }
    return onlySolid(fillet.Shape());
}

TopoDS_Shape askew(const TopoDS_Shape& solid) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(3, -5, 7), gp_Dir(1, 2, 3)), 0.7);
    return onlySolid(BRepBuilderAPI_Transform(solid, turn, true).Shape());
}

HealedSolid healed(const TopoDS_Shape& solid) {
    return {solid, volumeOf(solid)};
}

TopoDS_Shape recognised(const TopoDS_Shape& solid) {
    ShapeNames names;
    std::vector<Remark> remarks;
    return withElementarySurfaces(healed(solid), names, remarks);
}

std::map<std::string, int> kindsOf(const TopoDS_Shape& solid) {
    std::map<std::string, int> kinds;
    for (const TopoDS_Face& face : facesOf(solid))
        ++kinds[surfaceKind(face)];
    return kinds;
}

/// Radii of the cylinders, smallest first; below 0 where these are hollow.
std::vector<double> radiiOf(const TopoDS_Shape& solid) {
    std::vector<double> radii;
    for (const FaceShape& face : faceGraph(makePart(solid, "test"), Tolerances{}).faces)
        if (face.surface == "cylinder") radii.push_back(face.hollow ? -face.radius_mm : face.radius_mm);
    std::sort(radii.begin(), radii.end());
    return radii;
}

/// An upright wall over an ellipse that a circle of 10 mm misses by `off_mm`.
TopoDS_Shape ellipticPrism(double off_mm) {
    const gp_Elips ellipse(gp::XOY(), 10 + off_mm, 10 - off_mm);
    return test::prismIn(BRepBuilderAPI_MakeEdge(ellipse).Edge(), 5);
}

TEST(ElementarySolid, ASplinedBlockIsWhatItWas) {
    for (const TopoDS_Shape& drawn : {shopBlock(), askew(shopBlock())}) {
        const TopoDS_Shape solid = recognised(splined(drawn));
        EXPECT_EQ(kindsOf(solid), kindsOf(drawn));
        EXPECT_NEAR(volumeOf(solid), volumeOf(drawn), 1e-6 * volumeOf(drawn));
        EXPECT_EQ(countEdges(solid), countEdges(drawn));
    }
}

TEST(ElementarySolid, AHoleIsHollowWithItsRadius) {
    const std::vector<double> radii = radiiOf(recognised(splined(shopBlock())));
    ASSERT_EQ(radii.size(), 2U);
    EXPECT_NEAR(radii[0], -3, 1e-6);
    EXPECT_NEAR(radii[1], 2, 1e-6);
}

TEST(ElementarySolid, WholeSurfacesOfRevolutionKeepTheirPolesAndSeams) {
    const std::vector<TopoDS_Shape> wholes{
        BRepPrimAPI_MakeSphere(5).Shape(), BRepPrimAPI_MakeTorus(10, 3).Shape(),
        BRepPrimAPI_MakeCone(4, 0, 6).Shape(), BRepPrimAPI_MakeCylinder(4, 6).Shape()};
    for (const TopoDS_Shape& whole : wholes)
        for (const TopoDS_Shape& drawn : {onlySolid(whole), askew(whole)}) {
            const TopoDS_Shape solid = recognised(splined(drawn));
            EXPECT_EQ(kindsOf(solid), kindsOf(drawn));
            EXPECT_NEAR(volumeOf(solid), volumeOf(drawn), 1e-6 * volumeOf(drawn));
        }
}

TEST(ElementarySolid, WhatIsTurnedAboutAnAxisIsRecognisedToo) {
    const TopoDS_Shape turned = onlySolid(ShapeCustom::ConvertToRevolution(shopBlock()));
    ASSERT_GT(kindsOf(turned)["revolution"], 0);
    EXPECT_EQ(kindsOf(recognised(turned)), kindsOf(shopBlock()));
}

TEST(ElementarySolid, AWallIsAsRoundAsATenthOfAMicron) {
    EXPECT_EQ(kindsOf(recognised(ellipticPrism(0.5 * 1e-4))).at("cylinder"), 1);
    const TopoDS_Shape oval = ellipticPrism(2e-4);
    EXPECT_TRUE(recognised(oval).IsEqual(oval));
}

TEST(ElementarySolid, WhatIsDrawnWellStaysAsItIs) {
    const TopoDS_Shape block = shopBlock();
    EXPECT_TRUE(recognised(block).IsEqual(block));
}

TEST(ElementarySolid, KeepsNamesAndTellsWhatItDrewAnew) {
    const TopoDS_Shape drawn = splined(shopBlock());
    ShapeNames names;
    std::vector<Remark> remarks;
    int number = 0;
    for (const TopoDS_Face& face : facesOf(drawn))
        names.set(face, "face " + std::to_string(number++));
    const TopoDS_Shape solid = withElementarySurfaces(healed(drawn), names, remarks);
    number = 0;
    for (const TopoDS_Face& face : facesOf(solid))
        EXPECT_EQ(names.of(face), "face " + std::to_string(number++));
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_EQ(remarks[0].text.find(fmt::format("{0} of {0} faces", number)), 0U) << remarks[0].text;
}

}  // namespace
}  // namespace stepmill
