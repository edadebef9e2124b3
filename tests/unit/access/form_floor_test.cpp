// How low form cutters may go beside and over what must stand.

#include <gtest/gtest.h>

#include <cmath>

#include "stepmill/access/form_floor.h"
#include "support/shape_makers.h"
#include "support/tolerances.h"
#include "support/tool_makers.h"

namespace stepmill::test {
namespace {

/// A wall from x = 0 on that is 10 mm high, on ground at z = 0.
FormGround wall() {
    FormGround ground;
    ground.window = makeRectangle({-50, -50}, {50, 50});
    ground.must_stand.push_back({-5, 0, ground.window});
    ground.must_stand.push_back({0, 10, makeRectangle({0, -50}, {50, 50})});
    ground.obstacles = ground.must_stand;
    return ground;
}

TEST(FormFloor, IsTheGroundAwayFromTheWall) {
    const FormGround ground = wall();
    const ToolAssembly ball = ballMill(6);
    const FormFloor floor(ground, ball, kTol);
    for (const double low_mm : floor.over(equalPieces({-20, 0}, {-4, 0}, 7)))
        EXPECT_DOUBLE_EQ(low_mm, 0);
}

TEST(FormFloor, IsOverALongWayWhatItIsOverItsPieces) {
    const FormGround ground = wall();
    const ToolAssembly ball = ballMill(6);
    const FormFloor floor(ground, ball, kTol);
    const std::vector<Vec2> way = equalPieces({-15, -4}, {15, 4}, 60);
    const std::vector<double> over = floor.over(way);
    ASSERT_EQ(over.size(), 60U);
    for (std::size_t i = 0; i < over.size(); ++i)
        EXPECT_DOUBLE_EQ(over[i], floor.over({way[i], way[i + 1]}).front()) << i;
}

TEST(FormFloor, GivesUpAfterItsDeadline) {
    const FormGround ground = wall();
    const ToolAssembly ball = ballMill(6);
    const FormFloor floor(ground, ball, kTol, Deadline::in(0));
    EXPECT_THROW(floor.over({{-20, 0}, {-4, 0}}), Error);
}

TEST(FormFloor, IsTheWallsTopOverIt) {
    const FormGround ground = wall();
    const ToolAssembly ball = ballMill(6);
    const FormFloor floor(ground, ball, kTol);
    const std::vector<double> over = floor.over(equalPieces({5, 0}, {15, 0}, 3));
    EXPECT_EQ(over, (std::vector<double>{10, 10, 10}));
}

TEST(FormFloor, RisesBesideTheWallAsTheBallDoes) {
    const FormGround ground = wall();
    const ToolAssembly ball = ballMill(6);
    const FormFloor floor(ground, ball, kTol);
    // The end that is nearer counts.
    const double low_mm = floor.over(equalPieces({-2.1, 0}, {-2, 0}, 1)).front();
    const double gap_mm = 2 - kTol.guard_mm;
    EXPECT_NEAR(low_mm, 10 - (3 - std::sqrt(9 - gap_mm * gap_mm)), 1e-9);
}

TEST(FormFloor, KnowsWhichPiecesOfAWayLieOverTheWall) {
    const FormGround ground = wall();
    const ToolAssembly ball = ballMill(6);
    const FormFloor floor(ground, ball, kTol);
    const std::vector<double> over = floor.over(equalPieces({-10, 3}, {10, 3}, 5));
    ASSERT_EQ(over.size(), 5U);
    EXPECT_DOUBLE_EQ(over[0], 0);
    EXPECT_DOUBLE_EQ(over[2], 10);
    EXPECT_DOUBLE_EQ(over[4], 10);
}

TEST(FormFloor, KeepsTheHolderOffWhatStands) {
    const FormGround ground = wall();
    ToolAssembly ball = ballMill(6);
    ball.holder = {{40, 8, 30}};
    const FormFloor floor(ground, ball, kTol);
    EXPECT_DOUBLE_EQ(floor.over(equalPieces({-15, 0}, {-14, 0}, 1)).front(), 2);
    EXPECT_DOUBLE_EQ(floor.over(equalPieces({-30, 0}, {-29, 0}, 1)).front(), 0);
}

}  // namespace
}  // namespace stepmill::test
