#include "stepmill/part/square_up.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_Transform.hxx>
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
