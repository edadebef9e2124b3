#include <gtest/gtest.h>
#include <BRep_Tool.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/plan/plan.h"
#include "support/occt_solids.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

constexpr double kHeightMm = 20;
constexpr double kScallopMm = 0.02;

double heightOf(const TopoDS_Vertex& vertex) {
    return BRep_Tool::Pnt(vertex).Z();
}

/// A block of 60 x 40 mm with a chamfer of 1 mm on the edges at these heights.
TopoDS_Shape chamferedShape(const std::vector<double>& heights_mm) {
    const TopoDS_Shape block = test::box(0, 0, 0, 60, 40, kHeightMm);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(block, TopAbs_EDGE, edges);
    BRepFilletAPI_MakeChamfer chamfer(block);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        const double from_mm = heightOf(TopExp::FirstVertex(edge));
        const double to_mm = heightOf(TopExp::LastVertex(edge));
        for (const double height_mm : heights_mm)
            if (from_mm == height_mm && to_mm == height_mm) chamfer.Add(1, edge);
    }
    return chamfer.Shape();
}

Part chamferedBlock(const std::vector<double>& heights_mm) {
    return makePart(chamferedShape(heights_mm), "chamfered block");
}

Plan planned(const Part& part) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.scallop_mm = kScallopMm;
    const ToolLibrary library =
        readToolLibrary(std::string(STEPMILL_SOURCE_DIR) + "/samples/shop_with_forms_tools.json");
    return planPart(part, request, library, defaultMachine(), kTol);
}

/// In the vise along these axes, a chamfer mill alone in each, and no more left than ridges.
void expectChamferMillIn(const Plan& plan, const std::vector<Vec3>& axes) {
    ASSERT_EQ(plan.setups.size(), axes.size());
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const PlannedSetup& setup = plan.setups[i];
        EXPECT_EQ(setup.setup.axis, axes[i]);
        EXPECT_TRUE(setup.clamping.isVise()) << setup.clamping.text;
        ASSERT_EQ(setup.operations.size(), 1U);
        EXPECT_EQ(setup.operations.front().tool_id, "CM10");
    }
    const double bevels_mm2 = static_cast<double>(axes.size()) * 200 * std::sqrt(2);
    EXPECT_LT(plan.balance.stock_minus_part_mm3 - plan.balance.planned_mm3, 1.2 * kScallopMm * bevels_mm2);
}

TEST(ChamferedBlock, IsHeldSoLowThatTheChamferMillGoesRound) {
    expectChamferMillIn(planned(chamferedBlock({kHeightMm})), {Vec3::UnitZ()});
}

TEST(ChamferedBlock, IsTurnedOverForTheOtherEdges) {
    expectChamferMillIn(planned(chamferedBlock({0, kHeightMm})), {Vec3::UnitZ(), -Vec3::UnitZ()});
}

TEST(ChamferedBlock, FormCuttersLeaveThePointsOfDrilledHoles) {
    constexpr double kRadiusMm = 3.4;
    constexpr double kPointMm = kRadiusMm * 0.6008606190;  // of 118 degrees
    TopoDS_Shape block = chamferedShape({kHeightMm});
    for (const double x_mm : {10.0, 50.0}) {
        const gp_Ax2 down(gp_Pnt(x_mm, 20, 8), -gp::DZ());
        block = test::cut(block, BRepPrimAPI_MakeCylinder(gp_Ax2(down.Location(), gp::DZ()), kRadiusMm, 20));
        block = test::cut(block, BRepPrimAPI_MakeCone(down, kRadiusMm, 0, kPointMm));
    }
    const Plan plan = planned(test::part(block));
    for (const PlannedSetup& setup : plan.setups)
        for (const Operation& operation : setup.operations)
            EXPECT_NE(operation.tool_id, "BM6");
    EXPECT_EQ(std::count_if(plan.warnings.begin(), plan.warnings.end(),
                            [](const Warning& warning) { return warning.code == "planning-failed"; }),
              0);
    EXPECT_LT(plan.balance.gapShare(), kTol.volume_share);
}

TEST(ChamferedBlock, ItsBooksCloseWhereAnEarlierSetupDrilledAcross) {
    const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(30, -1, 10), gp::DY()), 3, 16).Shape();
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.setup.axes = {-Vec3::UnitY(), Vec3::UnitX()};
    const Part part = test::part(test::cut(chamferedShape({0, kHeightMm}), hole));
    const Plan plan = planPart(part, request, defaultToolLibrary(), defaultMachine(), kTol);
    EXPECT_LT(plan.balance.gapShare(), 0.1 * kTol.volume_share);
}

}  // namespace
}  // namespace stepmill
