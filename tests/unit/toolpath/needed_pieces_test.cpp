// Pieces of loops that are needed, of edges that were cut to be asked one by one.

#include <gtest/gtest.h>

#include "toolpath/needed_pieces.h"

namespace stepmill {
namespace {

/// A slot of 40 x 10 mm with round ends.
Loop slotLoop() {
    return {{0, -5},
            {{{40, -5}, std::nullopt},
             {{40, 5}, Arc{{40, 0}, 5, true}},
             {{0, 5}, std::nullopt},
             {{0, -5}, Arc{{0, 0}, 5, true}}}};
}

std::vector<Edge> inPieces(const Loop& loop, int of_each) {
    std::vector<Edge> edges;
    for (const auto& [from, segment] : eachEdge(loop))
        for (int i = 0; i < of_each; ++i)
            edges.push_back(*cutOut(makeEdge(from, segment), static_cast<double>(i) / of_each,
                                    static_cast<double>(i + 1) / of_each));
    return edges;
}

TEST(NeededPieces, HaveLinesAndArcsWholeAgain) {
    const std::vector<Edge> edges = inPieces(slotLoop(), 8);
    std::vector<char> needed(edges.size(), 1);
    // Of the first line a quarter in its middle is not.
    needed[3] = needed[4] = 0;
    const std::vector<Path> pieces = toolpath::neededPieces(slotLoop(), edges, needed, 1);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(pieces[0].start, Vec2(25, -5));
    ASSERT_EQ(pieces[0].segments.size(), 5U);
    EXPECT_EQ(pieces[0].segments[0].to, Vec2(40, -5));
    EXPECT_EQ(pieces[0].segments[1].to, Vec2(40, 5));
    EXPECT_TRUE(pieces[0].segments[1].arc);
    EXPECT_EQ(pieces[0].segments[4].to, Vec2(15, -5));
}

TEST(NeededPieces, AreTheLoopWhereAllOfItIs) {
    const std::vector<Edge> edges = inPieces(slotLoop(), 3);
    const std::vector<Path> pieces =
        toolpath::neededPieces(slotLoop(), edges, std::vector<char>(edges.size(), 1), 1);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(pieces[0].segments.size(), 4U);
}

}  // namespace
}  // namespace stepmill
