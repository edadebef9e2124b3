#include "verify/cut_ways.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/random_regions.h"

namespace stepmill::verify {
namespace {

const Box2 kPlate{Vec2(0, 0), Vec2(200, 100)};

Path line(const Vec2& from, const Vec2& to) {
    return {from, {{to, std::nullopt}}};
}

TEST(CutWays, AreFoundByPlaceFromAbove) {
    CutWays ways(kPlate, 10);
    ways.add(-1, line({5, 5}, {15, 5}));
    ways.add(-2, line({5, 6}, {15, 6}));
    ways.add(-1, line({5, 7}, {15, 7}));
    ways.add(-1, line({150, 50}, {190, 50}));
    const std::vector<Path> below = ways.below(-1, {Vec2(0, 0), Vec2(20, 20)});
    ASSERT_EQ(below.size(), 3u);
    EXPECT_EQ(below[0].start.y(), 5);
    EXPECT_EQ(below[1].start.y(), 7);
    EXPECT_EQ(below[2].start.y(), 6);
    EXPECT_EQ(ways.below(-1.5, {Vec2(0, 0), Vec2(20, 20)}).size(), 1u);
    EXPECT_TRUE(ways.below(-3, kPlate).empty());
}

TEST(CutWays, BeyondTheAreaCountToo) {
    CutWays ways(kPlate, 10);
    ways.add(0, line({-50, -50}, {-40, -50}));
    EXPECT_EQ(ways.below(0, {Vec2(-60, -60), Vec2(-45, -40)}).size(), 1u);
    EXPECT_TRUE(ways.below(0, {Vec2(0, 0), Vec2(5, 5)}).empty());
}

TEST(CutWays, AreThoseThatALookAtAllOfThemFinds) {
    test::Random random(7);
    CutWays ways(kPlate, 5);
    std::vector<std::pair<double, Path>> all;
    for (int i = 0; i < 400; ++i) {
        const Vec2 from(random.real(-20, 220), random.real(-20, 120));
        const Vec2 to(from + Vec2(random.real(-30, 30), random.real(-30, 30)));
        all.emplace_back(-random.below(10), line(from, to));
        ways.add(all.back().first, all.back().second);
    }
    for (int i = 0; i < 50; ++i) {
        const Vec2 at(random.real(-20, 220), random.real(-20, 120));
        const Box2 around{at, Vec2(at + Vec2(random.real(0, 40), random.real(0, 40)))};
        const double highest_mm = -random.below(10);
        const auto expected = std::count_if(all.begin(), all.end(), [&](const auto& way) {
            return way.first <= highest_mm && boundingBox(way.second).intersects(around);
        });
        EXPECT_EQ(static_cast<long>(ways.below(highest_mm, around).size()), expected);
    }
}

}  // namespace
}  // namespace stepmill::verify
