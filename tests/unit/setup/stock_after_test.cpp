#include <gtest/gtest.h>
#include <BRepCheck_Analyzer.hxx>

#include "stepmill/planar/boolean.h"
#include "stepmill/setup/in_process.h"
#include "unit/layers/solids.h"

using namespace stepmill;
using namespace stepmill::test;

namespace {

const Tolerances kTol;

/// A block 60 x 40 x 20 set up from above: z 0 is its top.
stepmill::Setup block(const Vec3& axis = Vec3::UnitZ()) {
    return setupOf(part(box(0, 0, 0, 60, 40, 20)), axis);
}

std::vector<Prism> whole(const stepmill::Setup& setup) {
    const Box3& box = setup.stock_bbox_mm;
    return {{makeRectangle(box.min().head<2>(), box.max().head<2>()), 0, box.min().z()}};
}

void expectGone(const stepmill::Setup& setup, const std::vector<Prism>& removed) {
    const StockAfter after = stockAfter(setup, removed, whole(setup), kTol);
    EXPECT_TRUE(after.remarks.empty()) << after.remarks.front();
    EXPECT_NEAR(after.removed_mm3, volumeOf(removed), 1e-6 * volumeOf(removed));
    EXPECT_TRUE(BRepCheck_Analyzer(after.stock.shape->solid).IsValid());
    EXPECT_EQ(after.stock.kind, Stock::Kind::InProcess);
}

}  // namespace

TEST(StockAfter, IsTheStockItselfWhereNothingIsRemoved) {
    const stepmill::Setup setup = block();
    EXPECT_EQ(stockAfter(setup, {}, whole(setup), kTol).stock.shape, setup.stock.shape);
}

TEST(StockAfter, CutsAPocketWithAnIslandAndTrueArcs) {
    const Region pocket =
        subtract(makeRectangle(Vec2(10, 10), Vec2(50, 30)), makeCircle(Vec2(30, 20), 5), kTol);
    expectGone(block(), {{pocket, 0, -8}});
}

TEST(StockAfter, CutsStackedPrismsWhoseWallsCoincide) {
    // A pocket, a smaller one in its floor sharing a wall, a through hole in that, an open step beside.
    expectGone(block(), {{makeRectangle(Vec2(10, 10), Vec2(50, 30)), 0, -5},
                         {makeRectangle(Vec2(10, 10), Vec2(30, 30)), -5, -12},
                         {makeCircle(Vec2(20, 20), 4), -12, -20},
                         {makeRectangle(Vec2(50, 0), Vec2(60, 40)), 0, -5}});
}

TEST(StockAfter, CutsAcrossWhatAnEarlierSetupCut) {
    const stepmill::Setup first = block();
    const StockAfter after =
        stockAfter(first, {{makeRectangle(Vec2(0, 10), Vec2(60, 30)), 0, -10}}, whole(first), kTol);
    const stepmill::Setup second = onStock(block(Vec3::UnitX()), after.stock);
    // Through the whole length: half of the prism is the slot already, and its slabs are no hull.
    const Region hole = makeCircle(Vec2(20, 10), 6);
    const std::vector<Prism> slot = {
        {subtract(makeRectangle(Vec2(0, 0), Vec2(40, 20)), makeRectangle(Vec2(10, 10), Vec2(30, 20)), kTol),
         0, -60}};
    const Region left = intersect(hole, slot.front().region, kTol);
    const StockAfter drilled = stockAfter(second, {{left, 0, -60}}, slot, kTol);
    EXPECT_NEAR(drilled.removed_mm3, area(left) * 60, 1e-3);
    EXPECT_TRUE(drilled.remarks.empty());
}

TEST(StockAfter, MovesTheWorkOffsetToWhatIsLeft) {
    const stepmill::Setup first = block();
    const StockAfter after =
        stockAfter(first, {{makeRectangle(Vec2(0, 0), Vec2(60, 40)), 0, -4}}, whole(first), kTol);
    const stepmill::Setup second = onStock(block(-Vec3::UnitX()), after.stock);
    EXPECT_NEAR(second.stock_bbox_mm.sizes().y(), 16, 1e-6);
    EXPECT_NEAR((second.part_to_setup * Vec3(0, 0, 0)).z(), 0, 1e-6);
}

TEST(StockAfter, RebuildsFromSlabsWhereTheSolidIsNoGood) {
    // A stock whose slabs say more than its shape: the Boolean cannot remove what is not there.
    stepmill::Setup setup = block();
    setup.stock.volume_mm3 = 60 * 40 * 20;
    setup.stock.shape = part(box(0, 0, 0, 60, 40, 10)).shape;
    const std::vector<Prism> removed = {{makeRectangle(Vec2(10, 10), Vec2(50, 30)), 0, -10}};
    const StockAfter after = stockAfter(setup, removed, whole(setup), kTol);
    EXPECT_NEAR(after.stock.volume_mm3, 60 * 40 * 20 - 40 * 20 * 10, 1e-3);
    ASSERT_FALSE(after.remarks.empty());
    EXPECT_NE(after.remarks.back().find("rebuilt from slabs"), std::string::npos) << after.remarks.back();
}
