#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "stepmill/core/units.h"
#include "stepmill/part/face_graph.h"
#include "stepmill/part/part_shape.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

TopoDS_Shape block() {
    return BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(40, 30, 20)).Shape();
}

FaceGraph graphOf(const TopoDS_Shape& solid) {
    return faceGraph(makePart(solid, "test"), kTol);
}

int countBends(const FaceGraph& graph, Bend bend) {
    return static_cast<int>(std::count_if(graph.edges.begin(), graph.edges.end(),
                                          [&](const FaceEdge& edge) { return edge.bend == bend; }));
}

const FaceShape& only(const FaceGraph& graph, const std::string& surface) {
    const auto found = std::find_if(graph.faces.begin(), graph.faces.end(),
                                    [&](const FaceShape& face) { return face.surface == surface; });
    EXPECT_NE(found, graph.faces.end());
    return *found;
}

TEST(FaceGraph, ABlockHasSixFacesThatMeetInTwelveOuterEdges) {
    const FaceGraph graph = graphOf(block());
    ASSERT_EQ(graph.faces.size(), 6U);
    EXPECT_EQ(graph.edges.size(), 12U);
    EXPECT_EQ(countBends(graph, Bend::Convex), 12);
    const Vec3 middle(20, 15, 10);
    double area = 0;
    for (const FaceShape& face : graph.faces) {
        area += face.area_mm2;
        ASSERT_FALSE(face.samples.empty());
        for (const FaceSample& sample : face.samples)
            EXPECT_GT(sample.normal.dot(sample.at - middle), 0) << "normals look out of the material";
    }
    EXPECT_NEAR(area, 2 * (40 * 30 + 40 * 20 + 30 * 20), 1e-6);
}

TEST(FaceGraph, ABlindBoreIsHollowAndMeetsItsFloorInAnInnerEdge) {
    const TopoDS_Shape bore =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20, 15, 5), gp_Dir(0, 0, 1)), 4, 20).Shape();
    const FaceGraph graph = graphOf(BRepAlgoAPI_Cut(block(), bore).Shape());
    ASSERT_EQ(graph.faces.size(), 8U);
    EXPECT_EQ(countBends(graph, Bend::Concave), 1);
    EXPECT_EQ(countBends(graph, Bend::Convex), 13);
    const FaceShape& wall = only(graph, "cylinder");
    EXPECT_TRUE(wall.hollow);
    EXPECT_NEAR(wall.radius_mm, 4, 1e-9);
    EXPECT_NEAR(wall.angle_rad, 2 * kPi, 1e-9);
}

TEST(FaceGraph, ABossIsNotHollow) {
    const FaceGraph graph = graphOf(BRepPrimAPI_MakeCylinder(5, 10).Shape());
    EXPECT_FALSE(only(graph, "cylinder").hollow);
}

TEST(FaceGraph, AConeTellsWhetherItRunsToItsApex) {
    EXPECT_TRUE(only(graphOf(BRepPrimAPI_MakeCone(5, 0, 10).Shape()), "cone").pointed);
    const FaceGraph blunt = graphOf(BRepPrimAPI_MakeCone(5, 2, 10).Shape());
    EXPECT_FALSE(only(blunt, "cone").pointed);
    EXPECT_NEAR(only(blunt, "cone").half_angle_rad, std::atan(0.3), 1e-9);
}

TEST(FaceGraph, ARoundedEdgeIsSmoothOnBothSides) {
    const TopoDS_Shape solid = block();
    BRepFilletAPI_MakeFillet fillet(solid);
    fillet.Add(3, TopoDS::Edge(TopExp_Explorer(solid, TopAbs_EDGE).Current()));
    const FaceGraph graph = graphOf(fillet.Shape());
    EXPECT_EQ(countBends(graph, Bend::Smooth), 2);
    EXPECT_FALSE(only(graph, "cylinder").hollow);
}

}  // namespace
}  // namespace stepmill
