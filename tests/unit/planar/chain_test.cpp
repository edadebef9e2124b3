#include "stepmill/planar/chain.h"

#include <gtest/gtest.h>

#include "stepmill/planar/edge.h"

namespace stepmill {
namespace {

Path line(const Vec2& from, const Vec2& to) {
    return {from, {{to, std::nullopt}}};
}

TEST(Chained, PiecesOfALineAreOneEdge) {
    const std::vector<Path> chains =
        chained({line({0, 0}, {1, 1}), line({1, 1}, {3, 3}), line({3, 3}, {3, 5})});
    ASSERT_EQ(chains.size(), 1U);
    ASSERT_EQ(chains[0].segments.size(), 2U);
    EXPECT_EQ(chains[0].segments[0].to, Vec2(3, 3));
    EXPECT_EQ(chains[0].end(), Vec2(3, 5));
}

TEST(Chained, AWayBackIsAnEdgeOfItsOwn) {
    const std::vector<Path> chains = chained({line({0, 0}, {4, 0}), line({4, 0}, {1, 0})});
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_EQ(chains[0].segments.size(), 2U);
}

TEST(Chained, PiecesOfAnArcAreOneButNoWholeTurn) {
    const Arc arc{{0, 0}, 1, true};
    const Path first{{1, 0}, {{{0, 1}, arc}}};
    const Path second{{0, 1}, {{{-1, 0}, arc}}};
    const Path third{{-1, 0}, {{{0, -1}, arc}}};
    const Path last{{0, -1}, {{{1, 0}, arc}}};
    const std::vector<Path> chains = chained({first, second, third, last});
    ASSERT_EQ(chains.size(), 1U);
    ASSERT_EQ(chains[0].segments.size(), 2U);
    EXPECT_EQ(chains[0].segments[0].to, Vec2(0, -1));
}

TEST(Chained, WaysApartStayApart) {
    const std::vector<Path> chains = chained({line({0, 0}, {1, 0}), line({2, 0}, {3, 0}), Path{{3, 0}, {}}});
    ASSERT_EQ(chains.size(), 3U);
    EXPECT_TRUE(chains[2].segments.empty());
}

}  // namespace
}  // namespace stepmill
