#include <gtest/gtest.h>

#include "stepmill/core/units.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill::test {
namespace {

/// 1000 mm/s2, rapids at 30 m/min, corners cut by a hundredth.
Machine quickMill() {
    Machine machine;
    machine.rapid_mm_per_min = 30000;
    machine.acceleration_mm_per_s2 = 1000;
    machine.junction_deviation_mm = 0.01;
    return machine;
}

/// Feeds at 6000 mm/min, 100 mm/s, from the origin.
Toolpath pathAlong(const std::vector<Vec3>& points, double feed_mm_per_min = 6000) {
    Toolpath path;
    path.feed_mm_per_min = feed_mm_per_min;
    for (const Vec3& to : points)
        path.moves.push_back({MoveKind::Feed, to, std::nullopt, false});
    return path;
}

TEST(MotionTime, OfALongLineIsATrapezoid) {
    // 0.1 s and 5 mm up, 90 mm at 100 mm/s, 0.1 s and 5 mm down.
    EXPECT_NEAR(motionTimeS(pathAlong({Vec3(100, 0, 0)}), quickMill()), 1.1, 1e-12);
}

TEST(MotionTime, OfAShortLineIsATriangle) {
    EXPECT_NEAR(motionTimeS(pathAlong({Vec3(4, 0, 0)}), quickMill()), 2 * std::sqrt(4.0 / 1000), 1e-12);
}

TEST(MotionTime, StraightOnNeedsNoStop) {
    EXPECT_NEAR(motionTimeS(pathAlong({Vec3(30, 0, 0), Vec3(100, 0, 0)}), quickMill()), 1.1, 1e-12);
    EXPECT_NEAR(motionTimeS(pathAlong({Vec3(30, 0, 0), Vec3(30, 0, 0), Vec3(100, 0, 0)}), quickMill()), 1.1,
                1e-12);
}

TEST(MotionTime, TurningBackIsAStop) {
    EXPECT_NEAR(motionTimeS(pathAlong({Vec3(100, 0, 0), Vec3(0, 0, 0)}), quickMill()), 2.2, 1e-9);
}

TEST(MotionTime, ARightAngleIsPassedAtTheJunctionSpeed) {
    // v^2 = a d s / (1 - s) with s = sin 45 degrees.
    const double s = std::sqrt(0.5);
    const double corner = std::sqrt(1000 * 0.01 * s / (1 - s));
    EXPECT_NEAR(corner, 4.9135, 1e-4);
    const double ramps_mm = (2 * 100.0 * 100 - corner * corner) / 2000;
    const double leg_s = (100 + 100 - corner) / 1000 + (100 - ramps_mm) / 100;
    const double found = motionTimeS(pathAlong({Vec3(100, 0, 0), Vec3(100, 100, 0)}), quickMill());
    EXPECT_NEAR(found, 2 * leg_s, 1e-12);
    EXPECT_LT(found, 2.2);
}

TEST(MotionTime, ALargerDeviationIsQuickerRoundCorners) {
    Machine machine = quickMill();
    const Toolpath path = pathAlong({Vec3(10, 0, 0), Vec3(10, 10, 0), Vec3(20, 10, 0), Vec3(20, 20, 0)});
    const double fine_s = motionTimeS(path, machine);
    machine.junction_deviation_mm = 0.1;
    EXPECT_LT(motionTimeS(path, machine), fine_s);
}

TEST(MotionTime, ACircleIsHeldToItsRadius) {
    // At 12 m/min a circle of 10 mm would need 4000 mm/s2; at 1000 the speed is 100 mm/s. Two halves join
    // without a corner.
    Toolpath path;
    path.start = Vec3(10, 0, 0);
    path.feed_mm_per_min = 12000;
    const Arc arc{Vec2(0, 0), 10, true};
    path.moves.push_back({MoveKind::Feed, Vec3(-10, 0, 0), arc, false});
    path.moves.push_back({MoveKind::Feed, Vec3(10, 0, 0), arc, false});
    EXPECT_NEAR(motionTimeS(path, quickMill()), 2 * kPi * 10 / 100 + 0.1, 1e-9);
}

TEST(MotionTime, ManyShortChordsAreOneLine) {
    std::vector<Vec3> points;
    for (int i = 1; i <= 100; ++i)
        points.emplace_back(i, 0, 0);
    EXPECT_NEAR(motionTimeS(pathAlong(points), quickMill()), 1.1, 1e-9);
}

TEST(MotionTime, StandsBesideThePlainTimeAndIsNeverLess) {
    Toolpath path = pathAlong({Vec3(3, 0, 0), Vec3(3, 5, 0), Vec3(0, 5, -2)});
    path.moves.push_back({MoveKind::Rapid, Vec3(40, 40, 5), std::nullopt, false});
    const PathTotals totals = measure(path, quickMill());
    EXPECT_GT(totals.motion_time_s, totals.time_s());
    Machine stiff = quickMill();
    stiff.acceleration_mm_per_s2 = 1e12;
    EXPECT_NEAR(measure(path, stiff).motion_time_s, totals.time_s(), 1e-5);
    stiff.acceleration_mm_per_s2 = 0;
    EXPECT_DOUBLE_EQ(measure(path, stiff).motion_time_s, totals.time_s());
}

TEST(MotionTime, OfNothingIsNothing) {
    EXPECT_EQ(motionTimeS(Toolpath{}, quickMill()), 0);
}

}  // namespace
}  // namespace stepmill::test
