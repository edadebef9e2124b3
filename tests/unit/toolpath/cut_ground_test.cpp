// Widths and depths of cuts that one can work out by hand.

#include <gtest/gtest.h>

#include <cmath>

#include "stepmill/core/units.h"
#include "stepmill/toolpath/cut_ground.h"

namespace stepmill {
namespace {

constexpr double kRadiusMm = 5;
constexpr double kStepDownMm = 4;

/// An area of 100 x 60 mm, 8 mm deep.
CutGround wideGround() {
    return CutGround(makeRectangle({0, 0}, {100, 60}), 0);
}

Move feedTo(double x, double y, double z) {
    return {MoveKind::Feed, Vec3(x, y, z), std::nullopt, false};
}

/// Goes through the moves; of each what it cuts.
struct Followed {
    std::vector<double> widest;
    std::vector<double> depth;
};
Followed follow(const CutGround& ground, const Vec3& start, const std::vector<Move>& moves) {
    CutFollower follower(ground, kRadiusMm, kStepDownMm, 1e-4);
    Followed followed;
    Vec3 from = start;
    for (const Move& move : moves) {
        const MoveCut cut = follower.next(from, move);
        followed.widest.push_back(cut.widest_mm);
        followed.depth.push_back(cut.depth_mm);
        from = move.to;
    }
    return followed;
}

TEST(CutFollower, FindsASlotAsWideAsTheCutter) {
    const Followed cut = follow(wideGround(), {20, 30, -4}, {feedTo(80, 30, -4)});
    EXPECT_NEAR(cut.widest[0], 10, 1e-9);
    EXPECT_DOUBLE_EQ(cut.depth[0], 4);
}

TEST(CutFollower, FindsTheStepOverBesideASlot) {
    const Followed cut =
        follow(wideGround(), {-10, 30, -4}, {feedTo(110, 30, -4), feedTo(110, 33, -4), feedTo(-10, 33, -4)});
    EXPECT_NEAR(cut.widest[0], 10, 1e-9);
    EXPECT_EQ(cut.widest[1], 0);
    EXPECT_NEAR(cut.widest[2], 3, 2e-3);
}

TEST(CutFollower, FindsWhatAnOpenEdgeLeavesToCut) {
    // The cutter's middle goes 2 mm outside the edge: 3 mm of it are inside.
    const Followed cut = follow(wideGround(), {-10, -2, -4}, {feedTo(110, -2, -4)});
    EXPECT_NEAR(cut.widest[0], 3, 1e-9);
}

TEST(CutFollower, CutsNothingOfAnEdgeThatItTouches) {
    EXPECT_EQ(follow(wideGround(), {50, -6, -4}, {feedTo(50, -5, -4)}).widest[0], 0);
    // In a bore of its own diameter.
    const CutGround bore(makeCircle({50, 30}, kRadiusMm), 0);
    EXPECT_LT(follow(bore, {50, 30, -4}, {feedTo(50.001, 30, -4)}).widest[0], 0.5);
}

TEST(CutFollower, FindsAir) {
    EXPECT_EQ(follow(wideGround(), {-10, -6, -4}, {feedTo(110, -6, -4)}).widest[0], 0);
    EXPECT_EQ(follow(wideGround(), {-10, 30, 0}, {feedTo(110, 30, 0)}).widest[0], 0);
    const Followed again = follow(wideGround(), {20, 30, -4}, {feedTo(80, 30, -4), feedTo(20, 30, -4)});
    EXPECT_NEAR(again.widest[1], 0, 2e-3);
}

TEST(CutFollower, GoesOnAtTheWidthItHad) {
    const Followed cut = follow(wideGround(), {20, 30, -4}, {feedTo(50, 30, -4), feedTo(80, 30, -4)});
    EXPECT_NEAR(cut.widest[1], 10, 2e-3);
}

TEST(CutFollower, FindsTheWiderCutInACorner) {
    // A ring's corner: along the first wall 3 mm wide, and into ground that nothing has swept yet.
    const std::vector<Move> moves{feedTo(80, 20, -4), feedTo(80, 23, -4), feedTo(20, 23, -4),
                                  feedTo(20, 45, -4)};
    const Followed cut = follow(wideGround(), {20, 20, -4}, moves);
    EXPECT_GT(cut.widest[3], 9);
}

TEST(CutFollower, KnowsTheDepthUnderTheTop) {
    const Followed cut = follow(wideGround(), {20, 30, -1.5}, {feedTo(80, 30, -1.5)});
    EXPECT_DOUBLE_EQ(cut.depth[0], 1.5);
}

TEST(CutFollower, TakesARampAsFullWidthUnderWhatWasCutThere) {
    const std::vector<Move> moves{feedTo(60, 30, -2), feedTo(20, 30, -4), feedTo(60, 30, -4)};
    const Followed cut = follow(wideGround(), {20, 30, 0}, moves);
    EXPECT_DOUBLE_EQ(cut.widest[0], 10);
    EXPECT_DOUBLE_EQ(cut.depth[0], 2);
    // From -2 down to -4 where the first leg began at 0: 4 mm at the end.
    EXPECT_DOUBLE_EQ(cut.depth[1], 4);
    // Level over the slope.
    EXPECT_DOUBLE_EQ(cut.depth[2], 2);
}

TEST(CutFollower, CutsThePitchOfAHelix) {
    const Arc circle{Vec2(50, 30), 3, true};
    std::vector<Move> moves;
    for (int i = 1; i <= 8; ++i)
        moves.push_back({MoveKind::Ramp, Vec3(i % 2 == 1 ? 47 : 53, 30, -0.4 * i), circle, false});
    const Followed cut = follow(wideGround(), {53, 30, 0}, moves);
    EXPECT_DOUBLE_EQ(cut.depth[0], 0.4);
    EXPECT_DOUBLE_EQ(cut.depth[1], 0.8);
    for (std::size_t i = 2; i < cut.depth.size(); ++i)
        EXPECT_NEAR(cut.depth[i], 0.8, 1e-12) << i;
}

TEST(CutFollower, FindsOtherDepthsLikeTheFirst) {
    const std::vector<Move> plan_view{feedTo(80, 30, 0), feedTo(80, 33, 0), feedTo(20, 33, 0)};
    std::vector<Move> moves;
    for (const double z : {-4.0, -8.0}) {
        moves.push_back({MoveKind::Plunge, Vec3(20, 30, z), std::nullopt, false});
        for (Move move : plan_view) {
            move.to.z() = z;
            moves.push_back(move);
        }
        moves.push_back({MoveKind::Rapid, Vec3(20, 33, 5), std::nullopt, false});
        moves.push_back({MoveKind::Rapid, Vec3(20, 30, 5), std::nullopt, false});
    }
    const Followed cut = follow(wideGround(), {20, 30, 5}, moves);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(cut.widest[i], cut.widest[i + 6]) << i;
        EXPECT_EQ(cut.depth[i], cut.depth[i + 6]) << i;
    }
}

TEST(CutGround, KnowsWhatAnEarlierOperationCut) {
    CutGround ground = wideGround();
    ground.add({-10, 30, -8}, {feedTo(110, 30, -8)}, 10);
    const Followed cut = follow(ground, {-10, 43, -4}, {feedTo(110, 43, -4)});
    EXPECT_NEAR(cut.widest[0], 8, 2e-3);
    // It went no deeper than that.
    const Followed below = follow(ground, {-10, 43, -10}, {feedTo(110, 43, -10)});
    EXPECT_NEAR(below.widest[0], 10, 1e-9);
}

TEST(CutFollower, TakesNoLesserWidthForAGreaterCusp) {
    CutGround ground = wideGround();
    ground.add({-10, 30, -8}, {feedTo(110, 31, -8), feedTo(60, 50, -8)}, 7);
    const std::vector<Move> moves{feedTo(90, 42, -4), feedTo(70, 12, -4), feedTo(30, 40, -4)};
    CutFollower narrow(ground, kRadiusMm, kStepDownMm, 0.005);
    CutFollower wide(ground, kRadiusMm, kStepDownMm, 0.01);
    Vec3 from(10, 20, -4);
    for (const Move& move : moves) {
        const MoveCut a = narrow.next(from, move);
        const MoveCut b = wide.next(from, move);
        ASSERT_EQ(a.widths_mm->size(), b.widths_mm->size());
        for (std::size_t i = 0; i < a.widths_mm->size(); ++i)
            EXPECT_LE((*a.widths_mm)[i], (*b.widths_mm)[i] + 1e-12);
        from = move.to;
    }
}

}  // namespace
}  // namespace stepmill
