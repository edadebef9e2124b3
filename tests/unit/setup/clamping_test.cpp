#include "stepmill/setup/clamping.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"

using namespace stepmill;

namespace {

using test::kTol;
const Region kBlock = makeRectangle(Vec2(0, 0), Vec2(80, 50));

/// A stock whose walls are all upright.
StockToHold upright(const std::vector<Prism>& arriving, const std::vector<Prism>& removed,
                    const std::vector<Prism>& leaning = {}) {
    StockToHold stock{arriving, {}, removed, leaning};
    for (const Prism& slab : arriving)
        stock.standing.push_back(slab.region);
    return stock;
}

Clamping clampingOf(const std::vector<Prism>& arriving, const std::vector<Prism>& removed) {
    return suggestClamping(upright(arriving, removed), {}, kTol);
}

}  // namespace

TEST(SuggestClamping, HoldsABlockOnItsLongSides) {
    const Clamping clamping =
        clampingOf({{kBlock, 0, -30}}, {{makeRectangle(Vec2(20, 20), Vec2(60, 30)), 0, -10}});
    ASSERT_TRUE(clamping.isVise()) << clamping.text;
    EXPECT_NEAR(clamping.opening_mm, 50, 1e-9);
    EXPECT_NEAR(clamping.length_mm, 80, 1e-9);
    EXPECT_NEAR(clamping.depth_mm, 28, 1e-9);  // grown jaws end at the stock's top
    EXPECT_NEAR(clamping.seat_mm2, 80 * 50, 1e-6);
}

TEST(SuggestClamping, LeavesFormCuttersRoomUnderChamfersIfItHoldsEnoughSo) {
    const auto depthUnder = [](const Region& chamfer, double from_mm, double to_mm) {
        return suggestClamping(upright({{kBlock, 0, -30}}, {}, {{chamfer, to_mm, from_mm}}), {}, kTol)
            .depth_mm;
    };
    const Region on_side = makeRectangle(Vec2(0, 0), Vec2(80, 1));
    EXPECT_NEAR(depthUnder(on_side, -1, 0), 22, 1e-9);  // 29 less 5 below and 2 clear
    EXPECT_NEAR(depthUnder(makeRectangle(Vec2(0, 20), Vec2(80, 21)), -1, 0), 28, 1e-9);
    // What leans nearly down to the bottom leaves nothing to hold below it.
    EXPECT_NEAR(depthUnder(on_side, -28, 0), 28, 1e-9);
}

TEST(SuggestClamping, PutsTheJawsBesideWhatTheyHoldAndUnderWhatIsCut) {
    HoldWish wish;
    wish.growth_mm = 1.5;
    const Clamping clamping = suggestClamping(
        upright({{kBlock, 0, -30}}, {{makeRectangle(Vec2(0, 0), Vec2(80, 10)), 0, -18}}), wish, kTol);
    ASSERT_EQ(clamping.fixtures.size(), 2U);
    double side = 0;
    for (const Fixture& jaw : clamping.fixtures) {
        EXPECT_LE(jaw.top_z_mm, -18 + 1e-9);
        EXPECT_EQ(area(intersect(jaw.section, kBlock, kTol)), 0);
        const Box2 box = boundingBox(jaw.section);
        EXPECT_NEAR(box.min().x() + box.max().x(), 80, 1e-6);
        EXPECT_NEAR(box.sizes().x(), 150 + 2 * 1.5, 1e-6);
        EXPECT_TRUE(box.min().y() == 50 || box.max().y() == 0);
        side += box.min().y() == 50 ? 1 : -1;
    }
    EXPECT_EQ(side, 0);
}

TEST(SuggestClamping, StaysBelowAnOpenStep) {
    const Clamping clamping =
        clampingOf({{kBlock, 0, -30}}, {{makeRectangle(Vec2(0, 0), Vec2(80, 10)), 0, -18}});
    ASSERT_TRUE(clamping.isVise()) << clamping.text;
    EXPECT_NEAR(clamping.depth_mm, 10, 1e-9);
}

TEST(SuggestClamping, TakesTheOtherSidesWhereTwoAreCutToTheBottom) {
    const Clamping clamping =
        clampingOf({{kBlock, 0, -30}}, {{makeRectangle(Vec2(20, 0), Vec2(60, 10)), 0, -30}});
    ASSERT_TRUE(clamping.isVise()) << clamping.text;
    EXPECT_NEAR(clamping.opening_mm, 80, 1e-9);
    EXPECT_NEAR(clamping.seat_mm2, 80 * 50 - 40 * 10, 1e-6);
}

TEST(SuggestClamping, SaysWhyNoViseWillDo) {
    const Region ring = subtract(kBlock, makeRectangle(Vec2(5, 5), Vec2(75, 45)), kTol);
    const Clamping cut = clampingOf({{kBlock, 0, -30}}, {{ring, 0, -30}});
    EXPECT_FALSE(cut.isVise());
    EXPECT_NE(cut.text.find("cutting reaches down"), std::string::npos) << cut.text;
    const Clamping round = clampingOf({{makeCircle(Vec2(0, 0), 20), 0, -30}}, {});
    EXPECT_EQ(round.kind, HoldKind::SoftJaws);
    EXPECT_NE(round.text.find("no two flat parallel sides"), std::string::npos) << round.text;
}

TEST(SuggestClamping, GripsAboveNarrowPadsAtTheBottom) {
    const Clamping clamping =
        clampingOf({{kBlock, 0, -30}, {makeRectangle(Vec2(10, 10), Vec2(30, 40)), -30, -34}}, {});
    ASSERT_TRUE(clamping.isVise()) << clamping.text;
    EXPECT_NEAR(clamping.from_mm, 4, 1e-9);
    EXPECT_NEAR(clamping.opening_mm, 50, 1e-9);
}

namespace {

const Region kRing = subtract(kBlock, makeRectangle(Vec2(5, 5), Vec2(75, 45)), kTol);

}  // namespace

TEST(SuggestClamping, AsksForNoWiderJawsThanTheViseHas) {
    HoldWish wish;
    wish.vise.opening_mm = 60;
    const Clamping narrow = suggestClamping(upright({{kBlock, 0, -30}}, {}), wish, kTol);
    ASSERT_TRUE(narrow.isVise()) << narrow.text;
    EXPECT_NEAR(narrow.opening_mm, 50, 1e-9);
    wish.vise.opening_mm = 49;
    const Clamping none = suggestClamping(upright({{kBlock, 0, -30}}, {}), wish, kTol);
    EXPECT_EQ(none.kind, HoldKind::Plate);
    EXPECT_NE(none.text.find("it opens 49 mm, the stock is 50 mm wide"), std::string::npos) << none.text;
}

TEST(SuggestClamping, HoldsNoMoreOfALongSideThanTheJawsAreWide) {
    const Clamping long_bar = clampingOf({{makeRectangle(Vec2(0, 0), Vec2(500, 40)), 0, -30}}, {});
    ASSERT_TRUE(long_bar.isVise()) << long_bar.text;
    EXPECT_NEAR(long_bar.length_mm, 150, 1e-9);
    EXPECT_NE(long_bar.text.find("175 mm of stock stick out"), std::string::npos) << long_bar.text;
    const Clamping longer = clampingOf({{makeRectangle(Vec2(0, 0), Vec2(800, 40)), 0, -30}}, {});
    EXPECT_FALSE(longer.isVise());
    EXPECT_NE(longer.text.find("two vises"), std::string::npos) << longer.text;
}

TEST(SuggestClamping, HoldsTheUprightSidesOfASlabThatLeansElsewhere) {
    // A hole across has opened the middle of both long sides, and a groove some of the bottom.
    const Region open = makeRectangle(Vec2(30, 0), Vec2(50, 50));
    StockToHold stock = upright({{kBlock, 0, -30}}, {});
    stock.standing = {subtract(kBlock, open, kTol)};
    const Clamping clamping = suggestClamping(stock, {}, kTol);
    ASSERT_TRUE(clamping.isVise()) << clamping.text;
    EXPECT_NEAR(clamping.length_mm, 60, 1e-9);
    EXPECT_NEAR(clamping.seat_mm2, 60 * 50, 1e-6);
}

TEST(SuggestClamping, HoldsNoSideThatLeans) {
    StockToHold stock = upright({{kBlock, 0, -30}}, {});
    stock.standing = {makeRectangle(Vec2(5, 5), Vec2(75, 45))};
    EXPECT_EQ(suggestClamping(stock, {}, kTol).kind, HoldKind::Plate);
}

TEST(SuggestClamping, HoldsAPlateOverItsRoundEnd) {
    // Twelve millimetres thick, its outline a circle of 30 mm below.
    std::vector<Prism> slabs{{makeRectangle(Vec2(-30, 0), Vec2(30, 12)), 30, 0}};
    for (int low_mm = 0; low_mm > -30; low_mm -= 3) {
        const double bottom_mm = low_mm - 3;
        const double half_mm = std::max(1.0, std::sqrt(900 - bottom_mm * bottom_mm));
        slabs.push_back({makeRectangle(Vec2(-half_mm, 0), Vec2(half_mm, 12)), bottom_mm + 3, bottom_mm});
    }
    const Clamping clamping = clampingOf(slabs, {});
    ASSERT_TRUE(clamping.isVise()) << clamping.text;
    EXPECT_NEAR(clamping.opening_mm, 12, 1e-9);
    EXPECT_GT(clamping.from_mm, 3);
    EXPECT_GT(clamping.length_mm, 30);
}

TEST(SuggestClamping, SaysHowLittleOfItsSidesFaceEachOther) {
    const Region slanted = makePolygon({{0, 0}, {20, 0}, {36, 10}, {16, 10}});
    const Clamping clamping = clampingOf({{slanted, 0, -30}}, {{slanted, 0, -1}});
    EXPECT_NE(clamping.text.find("mm of two sides face each other"), std::string::npos) << clamping.text;
}

TEST(SuggestClamping, HoldsNoTallStockByAShortLength) {
    const auto heldUpright = [](double height_mm) {
        return clampingOf({{makeRectangle(Vec2(0, 0), Vec2(72, 6)), 0, -height_mm}},
                          {{makeRectangle(Vec2(1, 0), Vec2(71, 1)), 0, -height_mm}});
    };
    EXPECT_TRUE(heldUpright(40).isVise());
    const Clamping tall = heldUpright(146);
    EXPECT_FALSE(tall.isVise());
    EXPECT_NE(tall.text.find("mm of the stock would stand over jaws that hold 6 mm"), std::string::npos)
        << tall.text;
}

TEST(SuggestClamping, PutsTheJawsWhereTheyHoldMost) {
    // Pads of 60 and 30 mm at the ends of a bar that is narrower between them.
    const Region bar = unite(
        std::vector<Region>{makeRectangle(Vec2(0, 5), Vec2(300, 35)), makeRectangle(Vec2(0, 0), Vec2(60, 40)),
                            makeRectangle(Vec2(270, 0), Vec2(300, 40))},
        kTol);
    const Clamping clamping = clampingOf({{bar, 0, -30}}, {{bar, 0, -1}});
    ASSERT_TRUE(clamping.isVise()) << clamping.text;
    EXPECT_NEAR(clamping.opening_mm, 40, 1e-9);
    EXPECT_NEAR(clamping.length_mm, 60, 1e-9);
    const Box2 jaw = boundingBox(clamping.fixtures.front().section);
    EXPECT_LE(jaw.min().x(), 0);
    EXPECT_GE(jaw.max().x(), 60);
}

TEST(SuggestClamping, StandsOnParallelsThatTheShopHas) {
    HoldWish wish;
    wish.vise.parallels_mm = {15, 33};
    const StockToHold stock =
        upright({{kBlock, 0, -30}}, {{makeRectangle(Vec2(0, 0), Vec2(80, 10)), 0, -18}});
    const Clamping clamping = suggestClamping(stock, wish, kTol);
    ASSERT_TRUE(clamping.isVise()) << clamping.text;
    EXPECT_NEAR(clamping.parallels_mm, 33, 1e-9);
    EXPECT_NEAR(clamping.depth_mm, 40 - 33, 1e-9);
    wish.vise.grip_mm = 8;  // neither the bed, nor these parallels hold so much and keep clear
    EXPECT_NE(suggestClamping(stock, wish, kTol).kind, HoldKind::Vise);
}

TEST(SuggestClamping, HoldsStockBelowThePart) {
    StockToHold stock = upright({{kBlock, 0, -42}}, {{kRing, 0, -42}});
    stock.under_part_mm = 12;
    const Clamping clamping = suggestClamping(stock, {}, kTol);
    ASSERT_TRUE(clamping.isVise()) << clamping.text;
    EXPECT_TRUE(clamping.holds_all);
    // The overlap below the part, the clearance, and parallels in steps of 2 mm: 12 - 1 - 2 is 9.
    EXPECT_NEAR(clamping.depth_mm, 8, 1e-9);
    EXPECT_NEAR(clamping.held_mm, 12 - kGripOverlapMm, 1e-9);
    EXPECT_NEAR(clamping.seat_mm2, area(kBlock), 1e-6);
    stock.under_part_mm = 6.9;  // less than grip and clearance
    EXPECT_EQ(suggestClamping(stock, {}, kTol).kind, HoldKind::Plate);
}

TEST(SuggestClamping, HoldsSidesThatAreCutAboveWhereThatIsAskedFor) {
    StockToHold stock = upright({{kBlock, 0, -30}}, {{kRing, 0, -30}});
    HoldWish wish;
    EXPECT_EQ(suggestClamping(stock, wish, kTol).kind, HoldKind::Plate);
    wish.kind = HoldKind::Vise;
    const Clamping clamping = suggestClamping(stock, wish, kTol);
    ASSERT_TRUE(clamping.isVise()) << clamping.text;
    EXPECT_FALSE(clamping.holds_all);
    EXPECT_NEAR(clamping.depth_mm, 5, 1e-9);
    EXPECT_NEAR(clamping.held_mm, 7, 1e-9);
    // What is left above must do for the next setup's jaws.
    stock.arriving = {{kBlock, 0, -13}};
    stock.removed = {{kRing, 0, -13}};
    EXPECT_EQ(suggestClamping(stock, wish, kTol).kind, HoldKind::None);
}

TEST(SuggestClamping, TakesThePlateOrTheViseThatWasAskedFor) {
    const StockToHold cut_around = upright({{kBlock, 0, -30}}, {{kRing, 0, -30}});
    HoldWish wish;
    const StockToHold block = upright({{kBlock, 0, -30}}, {});
    wish.kind = HoldKind::Plate;
    EXPECT_EQ(suggestClamping(block, wish, kTol).kind, HoldKind::Plate);
    wish.kind = HoldKind::Skin;
    const Clamping skin = suggestClamping(cut_around, wish, kTol);
    EXPECT_EQ(skin.kind, HoldKind::Skin);
    EXPECT_NEAR(skin.held_mm, kSkinMm, 1e-9);
    EXPECT_TRUE(skin.fixtures.empty());
}

TEST(SuggestClamping, LiesOnNoBedWhereAnythingGoesThrough) {
    const Region hole = makeCircle(Vec2(40, 25), 4);
    EXPECT_EQ(clampingOf({{kBlock, 0, -45}}, {{hole, 0, -20}}).parallels_mm, 0);
    const Clamping on_parallels = clampingOf({{kBlock, 0, -45}}, {{hole, 0, -45}});
    EXPECT_NEAR(on_parallels.parallels_mm, 6, 1e-9);
    EXPECT_NEAR(on_parallels.depth_mm, 34, 1e-9);
}

TEST(SuggestClamping, BoresSoftJawsToARoundOutline) {
    const Region disc = makeCircle(Vec2(30, 30), 30);
    const Clamping clamping = clampingOf({{disc, 0, -20}}, {{makeCircle(Vec2(30, 30), 12), 0, -20}});
    ASSERT_EQ(clamping.kind, HoldKind::SoftJaws) << clamping.text;
    EXPECT_NEAR(clamping.depth_mm, 15, 1e-9);
    EXPECT_NEAR(clamping.opening_mm, 60, 1e-9);
    ASSERT_EQ(clamping.fixtures.size(), 2U);
    for (const Fixture& jaw : clamping.fixtures) {
        EXPECT_EQ(jaw.kind, FixtureKind::Jaw);
        EXPECT_NEAR(jaw.top_z_mm, -20 + 15 + Vise{}.jaw_clearance_mm, 1e-9);
        EXPECT_NEAR(area(intersect(jaw.section, disc, kTol)), 0, 1e-6);
        EXPECT_NEAR(distanceToBoundary(jaw.section, disc.loops.front().start), 0, 31);
    }
    EXPECT_TRUE(intersect(clamping.fixtures[0].section, clamping.fixtures[1].section, kTol).empty());
    // Cut beside the jaws it must be held otherwise.
    const Region rim = subtract(disc, makeCircle(Vec2(30, 30), 28), kTol);
    EXPECT_EQ(clampingOf({{disc, 0, -20}}, {{rim, 0, -16}}).kind, HoldKind::Plate);
}

TEST(SuggestClamping, ScrewsThroughItsOwnHolesIntoAPlate) {
    // A lens: no flat sides, and its outline is cut.
    Region lens = makeCircle(Vec2(50, 50), 50);
    for (const Vec2& at : {Vec2(15, 50), Vec2(85, 50)})
        lens = subtract(lens, makeCircle(at, 3.3), kTol);
    const Region rim = subtract(makeCircle(Vec2(50, 50), 50), makeCircle(Vec2(50, 50), 49), kTol);
    const Region top = makeCircle(Vec2(50, 50), 10);
    const Clamping clamping = clampingOf({{lens, 0, -12}}, {{top, 0, -12}, {rim, 0, -12}});
    EXPECT_NE(clamping.kind, HoldKind::Screws) << "a cutter on the rim would meet the heads";
    const Region far_rim = subtract(makeCircle(Vec2(50, 50), 80), makeCircle(Vec2(50, 50), 70), kTol);
    Region wide = makeCircle(Vec2(50, 50), 80);
    wide = subtract(wide, subtract(makeCircle(Vec2(50, 50), 50), lens, kTol), kTol);
    const Clamping screwed = clampingOf({{wide, 0, -12}}, {{top, 0, -12}, {far_rim, 0, -12}});
    ASSERT_EQ(screwed.kind, HoldKind::Screws) << screwed.text;
    ASSERT_EQ(screwed.fixtures.size(), 2U);
    EXPECT_EQ(screwed.fixtures.front().name, "screw M6");
    EXPECT_EQ(screwed.fixtures.front().kind, FixtureKind::Screw);
    EXPECT_EQ(screwed.fixtures.front().bottom_z_mm, 0);
    HoldWish wish;
    wish.kind = HoldKind::Screws;
    EXPECT_EQ(suggestClamping(upright({{kBlock, 0, -30}}, {}), wish, kTol).kind, HoldKind::None);
}

TEST(SuggestClamping, TakesTheScrewsThatAreFarthestApart) {
    // Eight holes at one end of a plate, one at the other.
    Region plate = makeRectangle(Vec2(0, 0), Vec2(200, 60));
    for (int i = 0; i < 8; ++i)
        plate = subtract(plate, makeCircle(Vec2(12 + 14.0 * (i % 2), 9 + 14.0 * (i / 2)), 3.3), kTol);
    plate = subtract(plate, makeCircle(Vec2(188, 30), 3.3), kTol);
    HoldWish wish;
    wish.kind = HoldKind::Screws;
    const Clamping held = suggestClamping(upright({{plate, 0, -12}}, {}), wish, kTol);
    ASSERT_EQ(held.kind, HoldKind::Screws) << held.text;
    const auto is_far = [](const Fixture& screw) { return centroid(screw.section).x() > 180; };
    EXPECT_TRUE(std::any_of(held.fixtures.begin(), held.fixtures.end(), is_far));
}

TEST(SuggestClamping, TellsHowMuchBetweenTheJawsIsMaterial) {
    EXPECT_NEAR(clampingOf({{kBlock, 0, -30}}, {}).solid_share, 1, 1e-9);
    // A fork: two tines of 12 mm with 26 mm of air between them.
    const Region fork = subtract(kBlock, makeRectangle(Vec2(-1, 12), Vec2(81, 38)), kTol);
    HoldWish wish;
    wish.kind = HoldKind::Vise;
    const Clamping held = suggestClamping(upright({{fork, 0, -30}}, {}), wish, kTol);
    ASSERT_TRUE(held.isVise()) << held.text;
    EXPECT_NEAR(held.across.y(), 1, 1e-9);
    EXPECT_NEAR(held.solid_share, 24.0 / 50, 1e-6);
}

TEST(SuggestClamping, SaysWhatNeedsSupportBesideTheJaws) {
    const Region rail = makeRectangle(Vec2(0, 0), Vec2(500, 30));
    const Clamping held = clampingOf({{rail, 0, -30}}, {});
    ASSERT_TRUE(held.isVise()) << held.text;
    EXPECT_NEAR(held.beside_mm, (500 - Vise{}.jaw_width_mm) / 2, 1e-6);
    EXPECT_EQ(clampingOf({{kBlock, 0, -30}}, {}).beside_mm, 0);
}

TEST(SuggestClamping, HasNoJawsOverParallelsThatAreAsHigh) {
    HoldWish wish;
    wish.kind = HoldKind::Vise;
    wish.vise.parallels_mm = {wish.vise.jaw_height_mm, wish.vise.jaw_height_mm + 5};
    const StockToHold cut_through = upright({{kBlock, 0, -30}}, {{makeCircle(Vec2(40, 25), 4), 0, -30}});
    const Clamping none = suggestClamping(cut_through, wish, kTol);
    EXPECT_EQ(none.kind, HoldKind::None);
    EXPECT_NE(none.text.find("none of its parallels"), std::string::npos) << none.text;
}

TEST(SuggestClamping, RestsAnyStockOnThePlateThatWasAskedFor) {
    const Region stub = makeRectangle(Vec2(0, 0), Vec2(80, 4));
    HoldWish wish;
    wish.kind = HoldKind::Plate;
    EXPECT_EQ(suggestClamping(upright({{stub, 0, -4}}, {}), wish, kTol).kind, HoldKind::Plate);
}

TEST(SuggestClamping, HasNothingForAPartWithoutASeat) {
    const Region stub = makeRectangle(Vec2(0, 0), Vec2(80, 4));  // 320 mm2
    const Clamping clamping = clampingOf({{stub, 0, -4}}, {});
    EXPECT_EQ(clamping.kind, HoldKind::None) << clamping.text;
    EXPECT_NE(clamping.text.find("no plate"), std::string::npos) << clamping.text;
}

TEST(HoldKinds, HaveAWordEach) {
    for (const HoldKind kind : {HoldKind::None, HoldKind::Given, HoldKind::Vise, HoldKind::SoftJaws,
                                HoldKind::Screws, HoldKind::Plate, HoldKind::Skin})
        EXPECT_EQ(anyHoldKindFrom(toString(kind)), kind);
    EXPECT_EQ(holdKindFrom("plate"), HoldKind::Plate);
    EXPECT_FALSE(holdKindFrom("none"));
    EXPECT_FALSE(holdKindFrom("glue"));
}
