#include "stepmill/layers/stock_after.h"

#include <gtest/gtest.h>

#include "stepmill/core/units.h"
#include "stepmill/layers/section_cutter.h"
#include "stepmill/planar/boolean.h"
#include "support/occt_solids.h"
#include "support/tolerances.h"

using namespace stepmill;
using namespace stepmill::test;

namespace {

using test::kTol;

/// A block 60 x 40 x 20 set up from above: z 0 is its top.
stepmill::Setup block(const Vec3& axis = Vec3::UnitZ()) {
    return setupOf(part(box(0, 0, 0, 60, 40, 20)), axis);
}

StockAfter after(const stepmill::Setup& setup, const std::vector<Prism>& removed) {
    return stockAfter(setup, slice(setup, kTol), removed, kTol);
}

double airOf(const LayerStack& stack) {
    double air_mm3 = 0;
    for (const Layer& layer : stack.layers)
        air_mm3 += layer.stock_air_mm3;
    return air_mm3;
}

}  // namespace

TEST(StockAfter, IsTheStockItselfWhereNothingIsRemoved) {
    EXPECT_TRUE(after(block(), {}).stock.isRaw());
}

TEST(StockAfter, LosesThePrismsWhereNothingWasCutBefore) {
    const std::vector<Prism> removed = {
        {subtract(makeRectangle(Vec2(10, 10), Vec2(50, 30)), makeCircle(Vec2(30, 20), 5), kTol), 0, -8},
        {makeRectangle(Vec2(50, 0), Vec2(60, 40)), 0, -5}};
    const StockAfter cut = after(block(), removed);
    EXPECT_NEAR(cut.removed_mm3, volumeOf(removed), 1e-9);
    EXPECT_NEAR(cut.stock.volume_mm3, 60 * 40 * 20 - volumeOf(removed), 1e-9);
    EXPECT_EQ(cut.stock.cuts.size(), 1u);
}

TEST(StockAfter, MovesTheWorkOffsetToWhatIsLeft) {
    const StockAfter cut = after(block(), {{makeRectangle(Vec2(0, 0), Vec2(60, 40)), 0, -4}});
    const stepmill::Setup second = onStock(block(-Vec3::UnitX()), cut.stock);
    EXPECT_NEAR(second.stock_bbox_mm.sizes().y(), 16, 1e-9);
    EXPECT_NEAR((second.part_to_setup * Vec3(0, 0, 0)).z(), 0, 1e-9);
}

TEST(StockAfter, ShowsASlotUprightFromTheSideAndUpsideDownFromBelow) {
    const StockAfter cut = after(block(), {{makeRectangle(Vec2(0, 10), Vec2(60, 30)), 0, -10}});
    const LayerStack side = slice(onStock(block(Vec3::UnitX()), cut.stock), kTol);
    for (const Layer& layer : side.layers)
        EXPECT_NEAR(area(layer.stock), 40 * 20 - 20 * 10, 1e-6);
    EXPECT_EQ(airOf(side), 0);
    const LayerStack below = slice(onStock(block(-Vec3::UnitZ()), cut.stock), kTol);
    EXPECT_NEAR(area(below.stockAt(-5)), 60 * 40, 1e-6);
    EXPECT_NEAR(area(below.stockAt(-15)), 60 * 20, 1e-6);
}

TEST(StockAfter, CountsTheAirOfACrossHoleOnce) {
    // A hole along x, half of whose length a pocket from above takes away again.
    stepmill::Setup first = block(Vec3::UnitX());
    const Region hole = makeCircle(Vec2(20, 10), 4);
    const StockAfter drilled = after(first, {{hole, 0, -60}});
    const double hole_mm3 = kPi * 16 * 60;
    EXPECT_NEAR(drilled.removed_mm3, hole_mm3, 1e-6);
    const stepmill::Setup second = onStock(block(), drilled.stock);
    const LayerStack stack = slice(second, kTol);
    double hull_mm3 = 0;
    for (const Layer& layer : stack.layers)
        hull_mm3 += area(layer.stock) * layer.height_mm();
    EXPECT_GT(airOf(stack), 0);
    EXPECT_NEAR(hull_mm3 - airOf(stack), 60 * 40 * 20 - hole_mm3, 2e-3 * hole_mm3);
    std::vector<Prism> half;
    for (const Layer& layer : stack.layers)
        half.push_back({intersect(layer.stock, makeRectangle(Vec2(0, 0), Vec2(30, 40)), kTol), layer.top_z_mm,
                        layer.bottom_z_mm});
    const StockAfter milled = stockAfter(second, stack, half, kTol);
    EXPECT_NEAR(milled.stock.volume_mm3, (60 * 40 * 20 - hole_mm3) / 2, 2e-3 * hole_mm3);
    EXPECT_NEAR(milled.stock.bbox_mm.min().x(), 30, 1e-6);
}

TEST(StockAfter, CountsAirBesideTheBoxOnceWhereAnEarlierCutReachesIt) {
    // Askew to the block the slabs hold its hull. The first setup clears all of that above half height, air
    // beside the block too; the second takes what is left.
    const auto all = [](const LayerStack& stack, double bottom_mm) {
        std::vector<Prism> prisms;
        for (const Layer& layer : stack.layers)
            if (layer.top_z_mm > bottom_mm)
                prisms.push_back({layer.stock, layer.top_z_mm, std::max(bottom_mm, layer.bottom_z_mm)});
        return prisms;
    };
    const stepmill::Setup first = block(Vec3(0.6, 0, 0.8));
    const LayerStack stack = slice(first, kTol);
    const double middle_mm = (first.part_to_setup * Vec3(30, 20, 10)).z();
    const StockAfter half = stockAfter(first, stack, all(stack, middle_mm), kTol);
    const double block_mm3 = 60 * 40 * 20;
    EXPECT_NEAR(half.stock.volume_mm3, block_mm3 / 2, 2e-3 * block_mm3);
    const stepmill::Setup second = onStock(block(Vec3(0, 0.6, 0.8)), half.stock);
    const LayerStack rest = slice(second, kTol);
    const StockAfter none = stockAfter(second, rest, all(rest, -1e6), kTol);
    EXPECT_NEAR(none.stock.volume_mm3, 0, 2e-3 * block_mm3);
}

TEST(StockAfter, CountsAirBesideARoundBarThatLies) {
    // Slabs hold the bar's hull; all of it above half height goes.
    SetupRequest request;
    request.axes = {Vec3::UnitZ()};
    const gp_Ax2 axis(gp_Pnt(-5, 20, 10), gp::DX());
    request.stock_part = part(BRepPrimAPI_MakeCylinder(axis, 25, 70).Shape());
    const stepmill::Setup setup = chooseSetups(part(box(0, 0, 0, 60, 40, 20)), request).front();
    const LayerStack stack = slice(setup, kTol);
    const double middle_mm = (setup.part_to_setup * Vec3(30, 20, 10)).z();
    std::vector<Prism> upper;
    for (const Layer& layer : stack.layers)
        if (layer.top_z_mm > middle_mm)
            upper.push_back({layer.stock, layer.top_z_mm, std::max(middle_mm, layer.bottom_z_mm)});
    const StockAfter half = stockAfter(setup, stack, upper, kTol);
    const double bar_mm3 = kPi * 25 * 25 * 70;
    EXPECT_NEAR(half.removed_mm3, bar_mm3 / 2, 1e-3 * bar_mm3);
    EXPECT_GT(half.prisms_mm3, 1.01 * half.removed_mm3);
}

TEST(StockSections, KnowAStackOfCutsAsOneHole) {
    // Two bands of a bore, the lower one narrower: neither reaches through, together they do.
    const stepmill::Setup setup = block();
    const Region wide = makeCircle(Vec2(20, 20), 8);
    const Region narrow = makeCircle(Vec2(20, 20), 6);
    const StockSections sections(setup, after(setup, {{wide, 0, -7.5}, {narrow, -7.5, -20}}).stock, kTol);
    const double block_mm2 = 60 * 40;
    EXPECT_NEAR(area(sections.between(-20, 0)), block_mm2 - area(narrow), 1e-6);
    EXPECT_NEAR(area(sections.between(-7, -1)), block_mm2 - area(wide), 1e-6);
    EXPECT_NEAR(area(sections.between(makeRectangle(Vec2(20, 0), Vec2(60, 40)), -10, -5)),
                40 * 40 - area(narrow) / 2, 1e-6);
}

TEST(StockSections, KnowOfNoHoleWhereASolidLayerIsLeftInAStack) {
    const stepmill::Setup setup = block();
    const Region hole = makeCircle(Vec2(20, 20), 8);
    const StockSections sections(setup, after(setup, {{hole, 0, -7.5}, {hole, -8, -20}}).stock, kTol);
    EXPECT_NEAR(area(sections.between(-20, 0)), 60 * 40, 1e-6);
}
