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

TEST(CutFollower, TakesAGlideOverClearedGroundForAir) {
    Move glide = feedTo(20, 30, -3.8);
    glide.in_air = true;
    glide.feed_mm_per_min = 12000;
    const Followed cut = follow(wideGround(), {20, 30, -4},
                                {feedTo(80, 30, -4), feedTo(80, 30, -3.8), glide, feedTo(20, 30, -4)});
    EXPECT_EQ(cut.widest[2], 0);
    EXPECT_EQ(cut.depth[2], 0);
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
    // The cutter of 5 mm radius takes a disc of 8 mm, not a ring as wide as itself.
    const double more = 8.0 * 8 / (2 * 3) / 10;
    EXPECT_DOUBLE_EQ(cut.depth[0], 0.4 * more);
    EXPECT_DOUBLE_EQ(cut.depth[1], 0.8 * more);
    for (std::size_t i = 2; i < cut.depth.size(); ++i)
        EXPECT_NEAR(cut.depth[i], 0.8 * more, 1e-12) << i;
}

/// A thin rib across the way is met as wide in a move that rounding has made a step longer or shorter: steps
/// that divide the length evenly would come to lie elsewhere.
TEST(CutFollower, FindsTheSameWidthsInAMoveThatIsRounded) {
    CutGround ground = wideGround();
    ground.add({36.4, -10, -8}, {feedTo(36.4, 70, -8)}, 4);
    ground.add({45, -10, -8}, {feedTo(45, 70, -8)}, 4);
    const double rounded_mm = 0.5e-4;
    const double whole = follow(ground, {20, 30, -4}, {feedTo(60, 30, -4)}).widest[0];
    EXPECT_GT(whole, 1);
    for (const double by_mm : {-rounded_mm, rounded_mm})
        EXPECT_NEAR(follow(ground, {20, 30, -4}, {feedTo(60 + by_mm, 30, -4)}).widest[0], whole, 1e-3);
}

/// Programs tell an arc's centre from its start, which rounds otherwise where it is gone back.
TEST(CutFollower, KnowsALineThatIsGoneBackInSpiteOfRounding) {
    const Arc there{Vec2(50, 30), 20, true};
    const Arc back{Vec2(50 + 1e-12, 30 - 1e-12), 20, false};
    const std::vector<Move> moves{{MoveKind::Ramp, Vec3(50, 50, -1), there, false},
                                  {MoveKind::Ramp, Vec3(70, 30, -2), back, false},
                                  {MoveKind::Feed, Vec3(50, 50, -2), there, false}};
    const Followed cut = follow(wideGround(), {70, 30, 0}, moves);
    EXPECT_DOUBLE_EQ(cut.depth[0], 1);
    EXPECT_DOUBLE_EQ(cut.depth[1], 2);
    EXPECT_DOUBLE_EQ(cut.depth[2], 1);
}

TEST(CutFollower, AsksNoWidthOfAMoveThatOnlyDepthIsAskedOf) {
    const CutGround ground = wideGround();
    CutFollower asked(ground, kRadiusMm, kStepDownMm, 1e-4);
    CutFollower passed(ground, kRadiusMm, kStepDownMm, 1e-4);
    const Vec3 start(20, 30, -4);
    const Move first = feedTo(80, 30, -4);
    const Move second = feedTo(80, 33, -4);
    const Move third = feedTo(20, 33, -4);
    for (CutFollower* follower : {&asked, &passed}) {
        const bool is_asked = follower == &asked;
        const MoveCut cut = is_asked ? follower->next(start, first) : follower->nextDepth(start, first);
        EXPECT_EQ(cut.widths_mm != nullptr, is_asked);
        EXPECT_DOUBLE_EQ(cut.depth_mm, 4);
        follower->nextDepth(first.to, second);
    }
    EXPECT_EQ(asked.next(second.to, third).widest_mm, passed.next(second.to, third).widest_mm);
}

/// A micrometre is another direction altogether once its ends are rounded to tenths of one.
TEST(CutFollower, GoesOnInAMoveThatIsTooShortToHaveADirection) {
    const CutGround ground = wideGround();
    const std::vector<Move> beside{feedTo(80, 30, -4), feedTo(80, 33, -4), feedTo(50, 33, -4)};
    const double along_mm = follow(ground, {20, 30, -4}, beside).widest[2];
    for (const double off_mm : {-0.0001, 0.0, 0.0001}) {
        std::vector<Move> moves = beside;
        moves.push_back(feedTo(50 - 0.0002, 33 + off_mm, -4));
        EXPECT_NEAR(follow(ground, {20, 30, -4}, moves).widest[3], along_mm, 0.03) << off_mm;
    }
}

TEST(CutFollower, TakesAShortMoveOutOfNowhereAsFullWidth) {
    EXPECT_EQ(follow(wideGround(), {-5 + 0.02, 30, -4}, {feedTo(-5 + 0.03, 30, -4)}).widest[0], 10);
    EXPECT_EQ(follow(wideGround(), {-6, 30, -4}, {feedTo(-6 + 0.01, 30, -4)}).widest[0], 0);
}

TEST(CutFollower, SeesWhatManyShortMovesCutTogether) {
    // Round a corner into ground that nothing has swept.
    std::vector<Move> moves{feedTo(80, 20, -4), feedTo(80, 23, -4), feedTo(20, 23, -4)};
    for (int i = 1; i <= 2000; ++i)
        moves.push_back(feedTo(20, 23 + 0.01 * i, -4));
    EXPECT_GT(follow(wideGround(), {20, 20, -4}, moves).widest.back(), 9);
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
