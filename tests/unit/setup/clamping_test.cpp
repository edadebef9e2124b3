#include "stepmill/setup/clamping.h"

#include <gtest/gtest.h>

#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"

using namespace stepmill;

namespace {

using test::kTol;
const Region kBlock = makeRectangle(Vec2(0, 0), Vec2(80, 50));

Clamping clampingOf(const std::vector<Prism>& arriving, const std::vector<Prism>& removed) {
    return suggestClamping(arriving, std::vector<bool>(arriving.size(), true), removed, kTol);
}

}  // namespace

TEST(SuggestClamping, HoldsABlockOnItsLongSides) {
    const Clamping clamping =
        clampingOf({{kBlock, 0, -30}}, {{makeRectangle(Vec2(20, 20), Vec2(60, 30)), 0, -10}});
    ASSERT_TRUE(clamping.vise) << clamping.text;
    EXPECT_NEAR(clamping.opening_mm, 50, 1e-9);
    EXPECT_NEAR(clamping.length_mm, 80, 1e-9);
    EXPECT_NEAR(clamping.depth_mm, 28, 1e-9);  // grown jaws end at the stock's top
    EXPECT_NEAR(clamping.seat_mm2, 80 * 50, 1e-6);
}

TEST(SuggestClamping, PutsTheJawsBesideWhatTheyHoldAndUnderWhatIsCut) {
    const Clamping clamping =
        clampingOf({{kBlock, 0, -30}}, {{makeRectangle(Vec2(0, 0), Vec2(80, 10)), 0, -18}});
    ASSERT_EQ(clamping.jaws.size(), 2U);
    double side = 0;
    for (const Fixture& jaw : clamping.jaws) {
        EXPECT_LE(jaw.top_z_mm, -18 + 1e-9);
        EXPECT_EQ(area(intersect(jaw.section, kBlock, kTol)), 0);
        const Box2 box = boundingBox(jaw.section);
        EXPECT_NEAR(box.min().x() + box.max().x(), 80, 1e-6);
        EXPECT_NEAR(box.sizes().x(), 150 * (1 + kFixtureGrowth), 1e-6);
        EXPECT_TRUE(box.min().y() == 50 || box.max().y() == 0);
        side += box.min().y() == 50 ? 1 : -1;
    }
    EXPECT_EQ(side, 0);
}

TEST(SuggestClamping, StaysBelowAnOpenStep) {
    const Clamping clamping =
        clampingOf({{kBlock, 0, -30}}, {{makeRectangle(Vec2(0, 0), Vec2(80, 10)), 0, -18}});
    ASSERT_TRUE(clamping.vise) << clamping.text;
    EXPECT_NEAR(clamping.depth_mm, 10, 1e-9);
}

TEST(SuggestClamping, TakesTheOtherSidesWhereTwoAreCutToTheBottom) {
    const Clamping clamping =
        clampingOf({{kBlock, 0, -30}}, {{makeRectangle(Vec2(20, 0), Vec2(60, 10)), 0, -30}});
    ASSERT_TRUE(clamping.vise) << clamping.text;
    EXPECT_NEAR(clamping.opening_mm, 80, 1e-9);
    EXPECT_NEAR(clamping.seat_mm2, 80 * 50 - 40 * 10, 1e-6);
}

TEST(SuggestClamping, SaysWhyNoViseWillDo) {
    const Region ring = subtract(kBlock, makeRectangle(Vec2(5, 5), Vec2(75, 45)), kTol);
    const Clamping cut = clampingOf({{kBlock, 0, -30}}, {{ring, 0, -30}});
    EXPECT_FALSE(cut.vise);
    EXPECT_NE(cut.text.find("cutting reaches down"), std::string::npos) << cut.text;
    const Clamping round = clampingOf({{makeCircle(Vec2(0, 0), 20), 0, -30}}, {});
    EXPECT_FALSE(round.vise);
    EXPECT_NE(round.text.find("no two flat parallel sides"), std::string::npos) << round.text;
}

TEST(SuggestClamping, GripsAboveNarrowPadsAtTheBottom) {
    const Clamping clamping =
        clampingOf({{kBlock, 0, -30}, {makeRectangle(Vec2(10, 10), Vec2(30, 40)), -30, -34}}, {});
    ASSERT_TRUE(clamping.vise) << clamping.text;
    EXPECT_NEAR(clamping.from_mm, 4, 1e-9);
    EXPECT_NEAR(clamping.opening_mm, 50, 1e-9);
}
