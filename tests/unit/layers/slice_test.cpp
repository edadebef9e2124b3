#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "stepmill/core/units.h"
#include "stepmill/layers/stock_after.h"
#include "stepmill/planar/region_text.h"
#include "support/occt_solids.h"

using namespace stepmill;
using namespace stepmill::test;

namespace {

double booksError(const LayerStack& stack) {
    double removed = 0;
    for (const Layer& layer : stack.layers)
        removed += (area(layer.stock) - area(layer.part)) * layer.height_mm() + layer.sloped_volume_mm3;
    return removed - (stack.stock_volume_mm3 - stack.part_volume_mm3);
}

std::string text(const LayerStack& stack) {
    std::string all;
    for (const Layer& layer : stack.layers)
        all += std::to_string(layer.bottom_z_mm) + "\n" + toText(layer.part) + toText(layer.shadow) +
               toText(layer.stock) + std::to_string(layer.sloped_volume_mm3) + "\n";
    for (const std::string& remark : stack.remarks)
        all += remark + "\n";
    return all;
}

}  // namespace

TEST(Slice, BoxWithPocketHasTwoExactLayers) {
    const LayerStack stack = sliced(cut(box(0, 0, 0, 100, 80, 30), box(20, 10, 18, 50, 40, 12)));
    ASSERT_EQ(stack.layers.size(), 2u);
    EXPECT_NEAR(stack.layers[0].bottom_z_mm, -12, 1e-9);
    EXPECT_NEAR(stack.layers[1].bottom_z_mm, -30, 1e-9);
    EXPECT_NEAR(area(stack.layers[0].part), 8000 - 2000, 1e-9);
    EXPECT_NEAR(area(stack.layers[1].part), 8000, 1e-9);
    EXPECT_NEAR(area(stack.layers[0].stock), 8000, 1e-9);
    EXPECT_TRUE(stack.layers[0].vertical_walls);
    EXPECT_TRUE(stack.remarks.empty());
    EXPECT_NEAR(booksError(stack), 0, 1e-6);
}

TEST(Slice, RoundHoleIsAnExactCircle) {
    const LayerStack stack = sliced(cut(box(0, 0, 0, 40, 30, 10), cylinder(15, 12, -1, 4.25, 20)));
    ASSERT_EQ(stack.layers.size(), 1u);
    const Region& part = stack.layers[0].part;
    ASSERT_EQ(part.loops.size(), 2u);
    ASSERT_EQ(part.loops[1].segments.size(), 2u);
    ASSERT_TRUE(part.loops[1].segments[0].arc.has_value());
    EXPECT_EQ(part.loops[1].segments[0].arc->centre, Vec2(15, 12));
    EXPECT_EQ(part.loops[1].segments[0].arc->radius_mm, 4.25);
    EXPECT_FALSE(part.loops[1].segments[0].arc->ccw);
    EXPECT_NEAR(area(part), 1200 - kPi * 4.25 * 4.25, 1e-9);
}

TEST(Slice, PartTurnedOverShowsItsMirroredY) {
    const LayerStack stack =
        sliced(cut(box(0, 0, 0, 40, 30, 10), cylinder(15, 12, -1, 4, 5)), -Vec3::UnitZ());
    ASSERT_EQ(stack.layers.size(), 2u);
    EXPECT_NEAR(stack.layers[0].bottom_z_mm, -4, 1e-9);
    ASSERT_EQ(stack.layers[0].part.loops.size(), 2u);
    EXPECT_EQ(stack.layers[0].part.loops[1].segments[0].arc->centre, Vec2(15, 18));
}

TEST(Slice, DraftedWallIsAsWideAsItsFoot) {
    // A frustum of 60 x 60 at the foot and 40 x 40 at the top, 20 high.
    const TopoDS_Shape frustum = BRepPrimAPI_MakeWedge(60, 20, 60, 10, 10, 50, 50).Shape();
    const LayerStack stack =
        slice(setupOf(part(frustum), Vec3::UnitY()), Tolerances{},
              SliceOptions{.largest_hidden_share = 2, .thinnest_slab_mm = 1, .level_merge_mm = 1e-3});
    ASSERT_EQ(stack.layers.size(), 1u);
    EXPECT_FALSE(stack.layers[0].vertical_walls);
    // Half a micrometre over the foot the wall stands a quarter micrometre inside it.
    EXPECT_NEAR(area(stack.layers[0].part), 3600, 4 * 60 * 3e-4);
    EXPECT_NEAR(stack.layers[0].sloped_volume_mm3, 3600 * 20 - 20.0 / 3 * (3600 + 1600 + 2400), 2);
    EXPECT_NEAR(booksError(stack), 0, 1e-3);
}

TEST(Slice, SlopedSlabIsHalvedUntilLittleHides) {
    const TopoDS_Shape frustum = BRepPrimAPI_MakeWedge(60, 20, 60, 10, 10, 50, 50).Shape();
    const LayerStack stack = sliced(frustum, Vec3::UnitY());
    EXPECT_GT(stack.layers.size(), 4u);
    for (const Layer& layer : stack.layers)
        EXPECT_GE(layer.height_mm(), 1.0 - 1e-9);
    EXPECT_NEAR(booksError(stack), 0, 1e-3);
}

TEST(Slice, CountersinkTakesTheNarrowCircleOfEachSlab) {
    const gp_Ax2 at(gp_Pnt(20, 20, 7), gp::DZ());
    const TopoDS_Shape sink = BRepPrimAPI_MakeCone(at, 3, 6, 3).Shape();
    const TopoDS_Shape shape = cut(cut(box(0, 0, 0, 40, 40, 10), cylinder(20, 20, -1, 3, 20)), sink);
    SliceOptions options = allLevels();
    options.largest_hidden_share = 2;
    const LayerStack stack = sliced(shape, Vec3::UnitZ(), options);
    ASSERT_EQ(stack.layers.size(), 2u);
    EXPECT_NEAR(stack.layers[0].bottom_z_mm, -3, 1e-9);
    EXPECT_FALSE(stack.layers[0].vertical_walls);
    EXPECT_TRUE(stack.layers[1].vertical_walls);
    // Never wider than the hole at the slab's floor plus half a micrometre of cone.
    EXPECT_NEAR(area(stack.layers[0].part), 1600 - kPi * 9, 2 * kPi * 3 * 6e-4);
    EXPECT_NEAR(booksError(stack), 0, 1e-4);
}

TEST(Slice, BuriedSphereIsCutAtItsEquator) {
    const TopoDS_Shape cavity = BRepPrimAPI_MakeSphere(gp_Pnt(20, 20, 15), 8).Shape();
    const LayerStack stack = sliced(cut(box(0, 0, 0, 40, 40, 30), cavity), Vec3::UnitZ(), allLevels());
    const auto ends_at = [&](double z) {
        return std::any_of(stack.layers.begin(), stack.layers.end(),
                           [&](const Layer& layer) { return std::abs(layer.bottom_z_mm - z) < 1e-6; });
    };
    EXPECT_TRUE(ends_at(-7));
    EXPECT_TRUE(ends_at(-15));
    EXPECT_TRUE(ends_at(-23));
    // From above nothing of the cavity can be seen.
    EXPECT_NEAR(area(stack.layers.back().shadow), 1600, 1e-6);
    EXPECT_NEAR(booksError(stack), 0, 1e-3);
}

TEST(Slice, LyingCylinderCoversItsWidthBelowTheAxis) {
    const gp_Ax2 along_x(gp_Pnt(0, 0, 0), gp::DX());
    const LayerStack stack =
        sliced(BRepPrimAPI_MakeCylinder(along_x, 10, 50).Shape(), Vec3::UnitZ(), allLevels());
    bool axis_is_level = false;
    for (const Layer& layer : stack.layers) {
        axis_is_level = axis_is_level || std::abs(layer.bottom_z_mm + 10) < 1e-6;
        const double nearest = std::clamp(-10.0, layer.bottom_z_mm, layer.top_z_mm) + 10;
        const double widest = 2 * 50 * std::sqrt(100 - nearest * nearest);
        EXPECT_NEAR(area(layer.part), widest, 8) << layer.bottom_z_mm;
    }
    EXPECT_TRUE(axis_is_level);
    EXPECT_NEAR(area(stack.layers.back().shadow), 1000, 0.01);
}

TEST(Slice, WallsThatMeetAtTheBottomOfARoundGrooveLeaveNoGap) {
    const gp_Ax2 along_x(gp_Pnt(-1, 15, 10), gp::DX());
    const TopoDS_Shape groove = BRepPrimAPI_MakeCylinder(along_x, 4, 42).Shape();
    // A saw cut beside it is as narrow as the gap would be, and stays.
    const TopoDS_Shape shape = cut(cut(box(0, 0, 0, 40, 30, 10), groove), box(-1, 24, 6, 42, 0.2, 5));
    const LayerStack stack = sliced(shape, Vec3::UnitZ(), allLevels());
    for (const Layer& layer : stack.layers) {
        const double depth_mm = layer.bottom_z_mm + 4;
        EXPECT_EQ(contains(layer.part, Vec2(20, 15)), depth_mm < 1e-6) << layer.bottom_z_mm;
        EXPECT_EQ(contains(layer.part, Vec2(20, 24.1)), depth_mm < -1e-6) << layer.bottom_z_mm;
    }
    EXPECT_NEAR(booksError(stack), 0, 1e-3);
}

TEST(Slice, ShadowOfAnOverhangHidesTheSlotBelowIt) {
    const LayerStack stack = sliced(cut(box(0, 0, 0, 40, 30, 20), box(-1, 10, 5, 42, 30, 6)));
    ASSERT_EQ(stack.layers.size(), 3u);
    EXPECT_NEAR(area(stack.layers[1].part), 400, 1e-9);
    EXPECT_NEAR(area(stack.layers[1].shadow), 1200, 1e-9);
}

TEST(Slice, StepStockIsSlicedWithItsOwnLevels) {
    SetupRequest request;
    request.axes = {Vec3::UnitZ()};
    request.stock_part =
        part(BRepAlgoAPI_Fuse(box(-5, -5, 0, 50, 40, 10), box(0, 0, 10, 30, 30, 10)).Shape());
    const auto setup = chooseSetups(part(box(0, 0, 0, 30, 30, 8)), request).front();
    const LayerStack stack = slice(setup, Tolerances{});
    ASSERT_EQ(stack.layers.size(), 3u);
    EXPECT_NEAR(area(stack.layers[0].stock), 900, 1e-9);
    EXPECT_NEAR(area(stack.layers[1].stock), 2000, 1e-9);
    EXPECT_TRUE(stack.layers[0].part.empty());
    EXPECT_TRUE(stack.layers[1].part.empty());
    EXPECT_NEAR(area(stack.layers[2].part), 900, 1e-9);
    EXPECT_NEAR(booksError(stack), 0, 1e-6);
}

TEST(Slice, PartsStockThatWasCutBeforeOnlyWhereItMatters) {
    // Steps of 0.01 mm in a corner are worth no slabs; a step of 10 x 10 mm is.
    const Tolerances tol;
    SetupRequest request;
    request.axes = {Vec3::UnitZ(), Vec3::UnitX()};
    request.margin.top_mm = 15;
    std::vector<stepmill::Setup> setups = chooseSetups(part(box(0, 0, 0, 60, 40, 5)), request);
    stepmill::Setup& setup = setups[0];
    const stepmill::Setup& side = setups[1];
    std::vector<Prism> removed;
    const auto cutFrom = [&](double x, double z, double dx, double dz) {
        // Along x: the setup's plane is y and z of the part, its depth x.
        removed.push_back({makeRectangle(Vec2(0, z), Vec2(39, z + dz)), x + dx - 60, x - 60});
    };
    for (int i = 0; i < 4; ++i)
        cutFrom(0.01 * i, 18 - 0.5 * i, 0.01, 2 + 0.5 * i);
    cutFrom(50, 10, 9, 10);
    setup = onStock(setup, stockAfter(side, slice(side, tol), removed, tol).stock);
    SliceOptions options;
    options.least_gain_share = 0;
    const std::size_t all = slice(setup, tol, options).layers.size();
    options.least_gain_share = 2e-4;
    const LayerStack stack = slice(setup, tol, options);
    EXPECT_LT(stack.layers.size(), all);
    EXPECT_TRUE(stack.stock_cut_before);
    double hull_mm3 = 0;
    double air_mm3 = 0;
    for (const Layer& layer : stack.layers) {
        hull_mm3 += area(layer.stock) * layer.height_mm();
        air_mm3 += layer.stock_air_mm3;
    }
    EXPECT_GT(air_mm3, 0);
    // Cuts too small to part slabs are integrated as well as decides about slabs.
    EXPECT_NEAR(hull_mm3 - air_mm3, setup.stock.volume_mm3, options.least_gain_share * setup.removable_mm3);
}

TEST(Slice, ABoreStaysRoundWhereALyingHoleOpensIt) {
    const auto along_y = [](double x, double radius) {
        return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, -1, 20), gp::DY()), radius, 80).Shape();
    };
    const gp_Ax2 along_x(gp_Pnt(-1, 20, 20), gp::DX());
    const TopoDS_Shape bores =
        cut(cut(box(0, 0, 0, 90, 60, 40), cylinder(20, 20, -1, 4, 50)), cylinder(63, 40, -1, 3, 50));
    // Through the middle of the first, narrower; its ridge along the side of the second, wider.
    const TopoDS_Shape crossed = cut(cut(bores, along_y(20, 2.5)), along_y(60, 5));
    const TopoDS_Shape thrice = cut(crossed, BRepPrimAPI_MakeCylinder(along_x, 3, 100).Shape());
    for (const SliceOptions& options : {SliceOptions{}, test::allLevels()})
        for (const Layer& layer : sliced(thrice, Vec3::UnitZ(), options).layers) {
            ASSERT_EQ(layer.shadow.loops.size(), 3U);
            for (std::size_t bore : {1, 2}) {
                const std::vector<Segment>& edges = layer.shadow.loops[bore].segments;
                EXPECT_EQ(edges.size(), 2U) << layer.top_z_mm;
                for (const Segment& edge : edges)
                    EXPECT_TRUE(edge.arc) << layer.top_z_mm;
            }
        }
}

TEST(Slice, APortStaysRoundOverTheCrossBoresThatItEndsIn) {
    const auto lying = [](const gp_Dir& axis, double radius) {
        const gp_Pnt middle(30, 30, 22);
        return BRepPrimAPI_MakeCylinder(gp_Ax2(middle.Translated(gp_Vec(axis) * -50), axis), radius, 100)
            .Shape();
    };
    const TopoDS_Shape crossed = cut(cut(box(0, 0, 0, 60, 60, 50), lying(gp::DX(), 5)), lying(gp::DY(), 3.4));
    const LayerStack stack = sliced(cut(crossed, cylinder(30, 30, 22, 4, 40)));
    // The wall goes down to where the gallery of 10 mm cuts it; that narrows again below its axis.
    for (const Layer& layer : stack.layers) {
        if (layer.top_z_mm <= 25 - 50) break;
        EXPECT_NEAR(area(layer.stock) - area(layer.shadow), kPi * 16, 1e-3) << layer.top_z_mm;
    }
}

TEST(Slice, ARadialHoleIsRoundWhereTheHubIsTangent) {
    const auto disc = [](double radius, double height) { return cylinder(0, 0, 0, radius, height); };
    TopoDS_Shape hub = BRepAlgoAPI_Fuse(disc(55, 14), disc(28, 44)).Shape();
    hub = cut(cut(hub, cylinder(0, 0, -1, 21, 9)), cylinder(0, 0, -1, 15, 60));
    hub = cut(hub, cut(cylinder(0, 0, -1, 33, 3), cylinder(0, 0, -1, 30, 3)));
    const gp_Ax2 radial(gp_Pnt(0, -60, 38), gp::DY());
    const LayerStack stack =
        sliced(cut(hub, BRepPrimAPI_MakeCylinder(radial, 2.5, 60).Shape()), -Vec3::UnitY());
    const Layer& in_wall = *std::find_if(stack.layers.begin(), stack.layers.end(),
                                         [](const Layer& layer) { return layer.isWithin(-30, -39); });
    const std::vector<Region> open = components(subtract(in_wall.stock, in_wall.shadow, Tolerances{}));
    EXPECT_TRUE(std::any_of(open.begin(), open.end(),
                            [](const Region& region) { return std::abs(area(region) - kPi * 6.25) < 1e-3; }));
}

TEST(Slice, APinKeepsItsHolesEvenAtTheirRidges) {
    const gp_Ax2 along_y(gp_Pnt(20, -1, 20), gp::DY());
    const TopoDS_Shape pin = cylinder(20, 20, 0, 8, 40);
    const LayerStack stack =
        sliced(cut(pin, BRepPrimAPI_MakeCylinder(along_y, 3, 50).Shape()), Vec3::UnitZ(), test::allLevels());
    EXPECT_TRUE(stack.remarks.empty()) << stack.remarks.front();
    for (const Layer& layer : stack.layers)
        EXPECT_NEAR(area(layer.shadow), kPi * 64, 0.01) << layer.top_z_mm;
}

TEST(LayerStack, AnswersByHeight) {
    const LayerStack stack = sliced(cut(box(0, 0, 0, 100, 80, 30), box(20, 10, 18, 50, 40, 12)));
    const Tolerances tol;
    EXPECT_TRUE(stack.partAbove(0, tol).empty());
    EXPECT_NEAR(area(stack.partAbove(-5, tol)), 6000, 1e-9);
    EXPECT_NEAR(area(stack.partAbove(-12, tol)), 6000, 1e-9);
    EXPECT_NEAR(area(stack.partAbove(-20, tol)), 8000, 1e-9);
    EXPECT_NEAR(area(stack.stockAt(-3)), 8000, 1e-9);
    EXPECT_TRUE(stack.stockAt(1).empty());
}

TEST(Slice, DoesNotDependOnTheNumberOfThreads) {
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(20, 20, 25), 12).Shape();
    const gp_Ax2 tilted(gp_Pnt(30, 10, -5), gp_Dir(0.3, 0.2, 1));
    const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(tilted, 3, 60).Shape();
    const auto setup = setupOf(part(cut(cut(box(0, 0, 0, 50, 40, 30), ball), hole)));
    std::vector<std::string> texts;
    for (const std::size_t threads : {1, 2, 2}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        texts.push_back(text(slice(setup, Tolerances{})));
    }
    EXPECT_EQ(texts[0], texts[1]);
    EXPECT_EQ(texts[0], texts[2]);
}
