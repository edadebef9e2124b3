#include "stepmill/planar/svg_path.h"

#include <gtest/gtest.h>

#include "stepmill/planar/region_text.h"

namespace stepmill {
namespace {

TEST(SvgPath, KeepsArcs) {
    const Region slot =
        regionFromText("loop 0 0  line 10 0  arc 10 2 centre 10 1 ccw  line 0 2  close\n", "slot");
    EXPECT_EQ(toSvgPath(slot, 1), "M0 0l10 0a1 1 0 0 1 0 2l-10 0 0-2z");
}

TEST(SvgPath, SplitsFullCirclesAndArcsBeyondHalfOnes) {
    EXPECT_EQ(toSvgPath(Path{{1, 0}, {{{1, 0}, Arc{{0, 0}, 1, false}}}}, 1),
              "M1 0a1 1 0 0 0-2 0 1 1 0 0 0 2 0z");
    EXPECT_EQ(toSvgPath(Path{{10, 0}, {{{0, -10}, Arc{{0, 0}, 10, true}}}}, 1),
              "M10 0a10 10 0 0 1-17 7 10 10 0 0 1 7-17");
}

TEST(SvgPath, RoundsPointsNotTheWaysBetweenThem) {
    SvgPath drawing(1);
    drawing.add(std::vector<Vec2>{{0, 0}, {0.4, 0}, {0.8, 0}, {1.2, 0}, {1.6, 0}, {2, 0}});
    EXPECT_EQ(drawing.text(), "M0 0l1 0 1 0");
}

TEST(SvgPath, GoesOnWhereTheLastPieceEnded) {
    SvgPath drawing(0.1);
    drawing.add(makeRectangle({1, 1}, {2, 2}));
    drawing.add(std::vector<SvgDot>{{5, 5}, {5, 6}});
    EXPECT_EQ(drawing.text(), "M10 10l10 0 0 10-10 0 0-10zm-5-5 0 1");
}

TEST(SvgPath, ArcsTooSmallToTellAreLinesOrNothing) {
    EXPECT_EQ(toSvgPath(Path{{0, 0}, {{{0.6, 0}, Arc{{0.3, 0}, 0.3, true}}}}, 1), "M0 0l1 0");
    EXPECT_EQ(toSvgPath(Path{{0, 0}, {{{0.2, 0}, Arc{{0.1, 0}, 0.1, true}}}}, 1), "M0 0");
}

}  // namespace
}  // namespace stepmill
