#include "stepmill/part/square_up.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <gp_Ax1.hxx>

#include "stepmill/core/units.h"
#include "stepmill/part/part_shape.h"
#include "support/occt_solids.h"

using namespace stepmill;

namespace {

const double kPlateMm3 = 60 * 40 * 20 - kPi * 5 * 5 * 20;

TopoDS_Shape plate() {
    return test::cut(test::box(0, 0, 0, 60, 40, 20), test::cylinder(20, 15, -1, 5, 30));
}

Part turnedBy(const TopoDS_Shape& solid, const gp_Dir& about, double angle_rad) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(7, -3, 11), about), angle_rad);
    return makePart(BRepBuilderAPI_Transform(solid, turn, true).Shape(), "plate");
}

void expectSize(const Part& part, const Vec3& size) {
    EXPECT_LT((part.bbox_mm.sizes() - size).norm(), 1e-6) << part.bbox_mm.sizes().transpose();
}

}  // namespace

TEST(SquaredUp, LaysAPartAlongTheAxesThatStandsAskew) {
    const Part askew = turnedBy(plate(), gp_Dir(1, 1, 0.3), 0.35);
    ASSERT_GT(askew.bbox_mm.sizes().z(), 30);
    const Part squared = squaredUp(askew);
    expectSize(squared, {60, 40, 20});
    EXPECT_NEAR(squared.volume_mm3, kPlateMm3, 1e-3);
    ASSERT_EQ(squared.remarks.size(), 1U);
    EXPECT_EQ(squared.remarks.front().code, kTurned);
    // Once along the axes it stays.
    EXPECT_TRUE(squaredUp(makePart(squared.shape->solid, "again")).remarks.empty());
}

TEST(SquaredUp, TakesATinyTurnToo) {
    const Part askew = turnedBy(plate(), gp_Dir(0.2, 1, 0), 1e-3);
    const Part squared = squaredUp(askew);
    expectSize(squared, {60, 40, 20});
}

TEST(SquaredUp, LeavesPartsOfWhichFacesLookAlongTwoAxes) {
    EXPECT_TRUE(squaredUp(makePart(plate(), "plate")).remarks.empty());
    // A wedge's slanted face is larger than the upright ones.
    const Part wedge = makePart(
        test::cut(test::box(0, 0, 0, 60, 40, 20),
                  turnedBy(test::box(-40, -40, 0, 200, 200, 100), gp_Dir(0, 1, 0), 0.3).shape->solid),
        "wedge");
    EXPECT_TRUE(squaredUp(wedge).remarks.empty());
}

TEST(SquaredUp, LeavesAHexagonThatStandsUpright) {
    TopoDS_Shape head = test::cylinder(0, 0, 0, 12, 8);
    for (int i = 0; i < 6; ++i) {
        gp_Trsf turn;
        turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp::DZ()), 0.1 + i * kPi / 3);
        const TopoDS_Shape beside = test::box(9, -50, -1, 50, 100, 20);
        head = test::cut(head, BRepBuilderAPI_Transform(beside, turn, true).Shape());
    }
    EXPECT_TRUE(squaredUp(makePart(head, "hexagon")).remarks.empty());
    // Lying askew it is set upright all the same.
    EXPECT_NEAR(squaredUp(turnedBy(head, gp_Dir(1, 0.3, 0), 0.4)).bbox_mm.sizes().z(), 8, 1e-6);
}

TopoDS_Shape fused(const TopoDS_Shape& a, const TopoDS_Shape& b) {
    return BRepAlgoAPI_Fuse(a, b).Shape();
}

/// Around two circles on the x axis: flats that taper.
TopoDS_Shape taperedPlate() {
    const double sine = 10.0 / 80;
    const double cosine = std::sqrt(1 - sine * sine);
    BRepBuilderAPI_MakePolygon middle;
    for (const auto& [x, radius, side] : {std::tuple{0, 20, 1}, {80, 10, 1}, {80, 10, -1}, {0, 20, -1}})
        middle.Add(gp_Pnt(x + radius * sine, side * radius * cosine, 0));
    middle.Close();
    const TopoDS_Shape between =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(middle.Wire()), gp_Vec(0, 0, 12)).Shape();
    const TopoDS_Shape ends = fused(test::cylinder(0, 0, 0, 20, 12), test::cylinder(80, 0, 0, 10, 12));
    return fused(between, ends);
}

TEST(SquaredUp, LeavesAnOutlineWithTaperingFlats) {
    EXPECT_TRUE(squaredUp(makePart(taperedPlate(), "lever")).remarks.empty());
}

TEST(SquaredUp, TakesNoTurnThatMakesTheBlankLarger) {
    // All that stands upright and flat is a web at a slant between two discs.
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(40, 0, 0), gp::DZ()), 0.3);
    const TopoDS_Shape web = BRepBuilderAPI_Transform(test::box(5, -3, 0, 75, 3, 12), turn, true).Shape();
    const TopoDS_Shape ends = fused(test::cylinder(0, 0, 0, 15, 12), test::cylinder(80, 0, 0, 15, 12));
    EXPECT_TRUE(squaredUp(makePart(fused(ends, web), "dumbbell")).remarks.empty());
}

TEST(SquaredUp, TurnsARoundPartToTheNextAxis) {
    const Part rod = turnedBy(test::cylinder(0, 0, 0, 10, 50), gp_Dir(1, 0, 0), 0.2);
    expectSize(squaredUp(rod), {20, 20, 50});
}

TEST(TurnedLike, TakesTheStockAlong) {
    const Part part = squaredUp(turnedBy(plate(), gp_Dir(1, 1, 0.3), 0.35));
    const Part stock = turnedBy(test::box(-2, -2, -2, 64, 44, 24), gp_Dir(1, 1, 0.3), 0.35);
    for (const Part& turned : {turnedLike(stock, part), turnedLike(squaredUp(stock), part)}) {
        expectSize(turned, {64, 44, 24});
        EXPECT_LT((turned.bbox_mm.min() - part.bbox_mm.min() + Vec3(2, 2, 2)).norm(), 1e-6);
    }
}
