#include <gtest/gtest.h>

#include <cmath>

#include "setup/frame.h"
#include "stepmill/setup/stock_growth.h"

namespace stepmill {
namespace {

Stock box(double tolerance_mm) {
    Stock stock;
    stock.raw_bbox_mm = Box3(Vec3(0, 0, 0), Vec3(100, 60, 30));
    stock.bbox_mm = stock.raw_bbox_mm;
    stock.tolerance_mm = tolerance_mm;
    return stock;
}

Eigen::Isometry3d frameAlong(const Vec3& axis, const Box3& stock) {
    return setup::frameFor(axis, setup::turnedBox(stock, setup::rotationFor(axis)));
}

TEST(StockGrowth, OfAnExactStockIsNothing) {
    EXPECT_FALSE(growthOf(box(0), frameAlong(Vec3::UnitZ(), box(0).bbox_mm)).any());
}

TEST(StockGrowth, OfABoxIsOnItsRawSidesAndItsRawTop) {
    const StockGrowth growth = growthOf(box(0.5), frameAlong(Vec3::UnitX(), box(0.5).bbox_mm));
    EXPECT_DOUBLE_EQ(growth.side_mm, 0.5);
    EXPECT_DOUBLE_EQ(growth.top_mm, 0.5);
    ASSERT_TRUE(growth.raw_sides_mm);
    EXPECT_TRUE(growth.raw_sides_mm->isApprox(Box2(Vec2(0, 0), Vec2(60, 30))));
}

TEST(StockGrowth, LeavesATopThatAnEarlierSetupHasCut) {
    const Box3 left(Vec3(0, 0, 0), Vec3(100, 60, 28));
    const StockGrowth growth = growthOf(box(0.5), frameAlong(Vec3::UnitZ(), left));
    EXPECT_DOUBLE_EQ(growth.side_mm, 0.5);
    EXPECT_DOUBLE_EQ(growth.top_mm, 0);
}

TEST(StockGrowth, OfATiltedBoxIsBesideAllThatStands) {
    const Vec3 axis = Vec3(1, 0, 1).normalized();
    const StockGrowth growth = growthOf(box(0.5), frameAlong(axis, box(0.5).bbox_mm));
    EXPECT_FALSE(growth.raw_sides_mm);
    // A corner goes out by the tolerance along two edges at once.
    EXPECT_NEAR(growth.top_mm, 0.5 * std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(growth.side_mm, 0.5 * std::sqrt(2.0), 1e-12);
}

TEST(StockGrowth, OfAStockFromAFileIsBesideAllThatStands) {
    Stock stock = box(1);
    stock.kind = Stock::Kind::Step;
    EXPECT_FALSE(growthOf(stock, frameAlong(Vec3::UnitZ(), stock.bbox_mm)).raw_sides_mm);
}

}  // namespace
}  // namespace stepmill
