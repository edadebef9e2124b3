#include "layers/stock/askew_cut.h"

#include <gtest/gtest.h>

#include "stepmill/core/units.h"

using namespace stepmill;
using namespace stepmill::layers;

namespace {

/// A sliver between two arcs, 0.22 long and 1.5 um wide, beside a wall: as nist_ftc_06 has eight of them.
Loop sliver() {
    return {Vec2(21.59, 11.566619),
            {{Vec2(21.59, 11.663159), std::nullopt},
             {Vec2(21.565771, 11.785415), Arc{Vec2(19.126344, 11.238425), 2.5, true}},
             {Vec2(21.59, 11.566619), Arc{Vec2(20.59, 11.566619), 1, false}}}};
}

Eigen::Isometry3d leaning() {
    return Eigen::Isometry3d(Eigen::AngleAxisd(degToRad(30), Vec3::UnitX()));
}

}  // namespace

TEST(AskewCut, LeavesOutLoopsThatHaveNoPolygonWithin) {
    const Region block = makeRectangle(Vec2(0, 0), Vec2(10, 10));
    const Region far_block = makeRectangle(Vec2(40, 0), Vec2(50, 10));
    Prism with{block, 5, 0};
    with.region.loops.push_back(far_block.loops.front());
    Prism without = with;
    with.region.loops.push_back(sliver());
    ASSERT_GT(signedArea(sliver()), 0);
    const AskewCut cut(with, leaning());
    const AskewCut expected(without, leaning());
    const double middle_mm = (expected.low_mm() + expected.high_mm()) / 2;
    EXPECT_DOUBLE_EQ(cut.low_mm(), expected.low_mm());
    EXPECT_DOUBLE_EQ(cut.high_mm(), expected.high_mm());
    const double area_mm2 = area(cut.between(middle_mm, middle_mm, Tolerances()));
    EXPECT_GT(area_mm2, 0);
    EXPECT_DOUBLE_EQ(area_mm2, area(expected.between(middle_mm, middle_mm, Tolerances())));
}

TEST(AskewCut, OfASliverAloneTakesNothing) {
    const AskewCut cut({Region{{sliver()}}, 5, 0}, leaning());
    EXPECT_TRUE(cut.empty());
    EXPECT_TRUE(cut.between(-100, 100, Tolerances()).empty());
    EXPECT_TRUE(cut.at(0).sides.empty());
}
