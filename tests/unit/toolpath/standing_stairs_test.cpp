#include "stepmill/toolpath/standing_stairs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"
#include "support/tool_makers.h"

namespace stepmill::test {
namespace {

using test::kTol;
constexpr double kLengthMm = 40;
constexpr double kHeightMm = 2;
/// Slices are no higher where bands are not.
constexpr double kSliceMm = 0.1;

/// A wall along x that leans by 45 degrees, its foot at y = 0 and z = 0, in bands of that height.
FormGround leaningWall(double band_mm) {
    FormGround ground;
    ground.window = makeRectangle({-20, -20}, {kLengthMm + 20, 20});
    for (double z = 0; z < kHeightMm - 1e-9; z += band_mm)
        ground.must_stand.push_back({z, z + band_mm, makeRectangle({-20, z}, {kLengthMm + 20, 20})});
    ground.stairs.push_back({0, kHeightMm, makeRectangle({0, 0}, {kLengthMm, kHeightMm})});
    return ground;
}

constexpr double kTrueMm3 = kLengthMm * kHeightMm * kHeightMm / 2;

TEST(StandingStairs, AreTheWedgeOverAWallOfFortyFiveDegrees) {
    for (const double band_mm : {0.01, 0.04, 0.05, 0.08}) {
        SCOPED_TRACE(band_mm);
        const double found_mm3 = StandingStairs(leaningWall(band_mm), kTol).volumeMm3();
        EXPECT_LE(found_mm3, kTrueMm3 + 1e-6);
        EXPECT_GE(found_mm3, kTrueMm3 - kLengthMm * kHeightMm * band_mm);
    }
}

TEST(StandingStairs, LoseToAFlatCutterNoMoreThanItSweeps) {
    // The cutter's edge runs along y = 1 with its tip at z = 1; the first half of a millimetre over it
    // counts.
    const double counted_mm3 = kLengthMm * 1 * 0.5;
    for (const double band_mm : {0.01, 0.04, 0.05, 0.08}) {
        SCOPED_TRACE(band_mm);
        StandingStairs stairs(leaningWall(band_mm), kTol);
        const double before_mm3 = stairs.volumeMm3();
        stairs.cut({1, {Path{{-10, -4}, {{{kLengthMm + 10, -4}, std::nullopt}}}}},
                   CutterForm(flatEndMill(10)));
        EXPECT_LE(before_mm3 - stairs.volumeMm3(), kLengthMm * 1 + 1e-6);
        EXPECT_GE(before_mm3 - stairs.volumeMm3(), counted_mm3 - kLengthMm * 1 * kSliceMm);
    }
}

TEST(StandingStairs, LoseToAConeOfTheWallsLeanWhatIsBetweenItAndTheWall) {
    // A pointed mill of 90 degrees whose flank runs a tenth of a millimetre in front of the wall.
    const ToolAssembly mill = chamferMill(10, 0, 90);
    const double left_mm3 = kLengthMm * 0.1 * kHeightMm;
    for (const double band_mm : {0.01, 0.04, 0.05, 0.08}) {
        SCOPED_TRACE(band_mm);
        StandingStairs stairs(leaningWall(band_mm), kTol);
        stairs.cut({0, {Path{{-10, -0.1}, {{{kLengthMm + 10, -0.1}, std::nullopt}}}}}, CutterForm(mill));
        // The wedge's foot is thinner than a tenth.
        EXPECT_NEAR(stairs.volumeMm3(), left_mm3 - kLengthMm * 0.1 * 0.1 / 2,
                    kLengthMm * kHeightMm * band_mm / 2);
    }
}

TEST(StandingStairs, KeepWhatLiesUnderTheVeryTipOfABall) {
    // Half-way up a slice the ball is a hair wide.
    StandingStairs stairs(leaningWall(0.1), kTol);
    const double before_mm3 = stairs.volumeMm3();
    const double tip_mm = stairs.slices().back().z_mm - 1e-9;
    stairs.cut({tip_mm, {Path{{0, 1}, {{{kLengthMm, 1}, std::nullopt}}}}}, CutterForm(ballMill(6)));
    EXPECT_EQ(stairs.volumeMm3(), before_mm3);
}

TEST(StandingStairs, LoseUnderASlopeLessThanUnderALevelAtItsFoot) {
    // Along the wall, the cutter's edge over y = 1 all the way.
    const auto leftBy = [](double rise_mm) {
        StandingStairs stairs(leaningWall(0.05), kTol);
        stairs.cut(std::vector<SurfaceWay>{{{-10, -4, 0.5}, {kLengthMm + 10, -4, 0.5 + rise_mm}}},
                   CutterForm(flatEndMill(10)));
        return stairs.volumeMm3();
    };
    EXPECT_GT(leftBy(0.4), leftBy(0));
    EXPECT_GT(leftBy(0.8), leftBy(0.4));
    EXPECT_LT(leftBy(0.8), StandingStairs(leaningWall(0.05), kTol).volumeMm3());
}

TEST(StandingStairs, LoseToABallOnASlopeWhatItsTipAloneDoesNotMeet) {
    // A millimetre off the wall's foot, where the ball is half a millimetre wide just over its tip and 1.66
    // half a millimetre over it.
    StandingStairs stairs(leaningWall(0.05), kTol);
    const double before_mm3 = stairs.volumeMm3();
    stairs.cut(std::vector<SurfaceWay>{{{-10, -1, 0}, {kLengthMm + 10, -1, 0.05}}}, CutterForm(ballMill(6)));
    EXPECT_LT(stairs.volumeMm3(), before_mm3 - kLengthMm * 0.5 * (kHeightMm - 0.7));
}

TEST(SurfaceWays, AreStraightFeedsThatRiseOrFallSomewhere) {
    const Arc arc{{10.5, 0}, 1.5, true};
    const auto move = [](MoveKind kind, const Vec3& to, const std::optional<Arc>& along = std::nullopt) {
        return Move{kind, to, along, false};
    };
    const std::vector<Move> moves{move(MoveKind::Rapid, {0, 0, 1}),  move(MoveKind::Plunge, {0, 0, 0}),
                                  move(MoveKind::Feed, {5, 0, 0}),   move(MoveKind::Rapid, {5, 0, 2}),
                                  move(MoveKind::Plunge, {5, 0, 1}), move(MoveKind::Feed, {8, 0, 1}),
                                  move(MoveKind::Feed, {9, 0, 1.5}), move(MoveKind::Feed, {12, 0, 1.5}, arc)};
    const std::vector<SurfaceWay> ways = surfaceWays({0, 0, 5}, moves);
    ASSERT_EQ(ways.size(), 1U);
    EXPECT_EQ(ways.front(), (SurfaceWay{{5, 0, 2}, {5, 0, 1}, {8, 0, 1}, {9, 0, 1.5}}));
    // What goes over a surface is no way at one height.
    const std::vector<LevelWays> levels = levelWays({0, 0, 5}, moves);
    ASSERT_EQ(levels.size(), 2U);
    EXPECT_EQ(levels[0].tip_z_mm, 1.5);
    EXPECT_EQ(levels[1].tip_z_mm, 0);
}

TEST(StandingStairs, KeepWhatLiesBetweenTwoStairs) {
    FormGround ground = leaningWall(0.25);
    ground.stairs = {{0.1, 0.2, makeRectangle({0, -1}, {kLengthMm, 2})},
                     {0.2, 0.45, makeRectangle({0, -1}, {kLengthMm, 1})}};
    const StandingStairs stairs(ground, kTol);
    ASSERT_EQ(stairs.slices().size(), 3U);
    EXPECT_DOUBLE_EQ(stairs.slices()[0].bottom_mm, 0.1);
    EXPECT_DOUBLE_EQ(stairs.slices()[1].top_mm, 0.25);
    EXPECT_DOUBLE_EQ(stairs.slices()[2].top_mm, 0.45);
}

}  // namespace
}  // namespace stepmill::test
