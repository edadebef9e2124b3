// How the part is turned between two setups, in words.

#include <gtest/gtest.h>

#include "report/sheets/flip.h"
#include "stepmill/core/units.h"

namespace stepmill::report {
namespace {

Setup turned(const std::string& id, const Eigen::Matrix3d& rotation) {
    Setup setup;
    setup.id = id;
    setup.part_to_setup.linear() = rotation;
    return setup;
}

Eigen::Matrix3d about(const Vec3& axis, double degrees) {
    return Eigen::AngleAxisd(degrees * kPi / 180, axis).toRotationMatrix();
}

std::string wordsOf(const Eigen::Matrix3d& rotation) {
    return flipWords(turned("S1", about(Vec3::UnitZ(), 90)),
                     turned("S2", rotation * about(Vec3::UnitZ(), 90)));
}

TEST(FlipWords, TellHalfATurn) {
    EXPECT_EQ(
        wordsOf(about(Vec3::UnitX(), 180)),
        "Half a turn about X. The face that was down in S1 is on top, the one that was up is underneath.");
}

TEST(FlipWords, TellAQuarterTurnByWhereTheTopGoes) {
    EXPECT_EQ(
        wordsOf(about(Vec3::UnitX(), 90)),
        "A quarter turn about X (the top comes to the front). The face that was down in S1 is at the back, "
        "the one that was up is at the front.");
    EXPECT_EQ(
        wordsOf(about(Vec3::UnitY(), -90)),
        "A quarter turn about Y (the top goes to the left). The face that was down in S1 is at the right, "
        "the one that was up is at the left.");
}

TEST(FlipWords, KnowEveryWayABoxCanBeTurned) {
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 4; ++y)
            for (int z = 0; z < 4; ++z) {
                const std::string words =
                    wordsOf(about(Vec3::UnitZ(), 90 * z) * about(Vec3::UnitY(), 90 * y) *
                            about(Vec3::UnitX(), 90 * x));
                EXPECT_EQ(words.find("°"), std::string::npos) << words;
                EXPECT_NE(words.find("was down in S1"), std::string::npos) << words;
            }
}

TEST(FlipWords, TellAnAngleWhereThePartStandsAskew) {
    const std::string words = wordsOf(about(Vec3::UnitX(), 30));
    EXPECT_NE(words.find("30.00° about (1.0000, 0.0000, 0.0000)"), std::string::npos) << words;
    EXPECT_EQ(words.find("was down"), std::string::npos) << words;
}

TEST(TiltWords, TellHowFarTheToolLeansFromAnAxisOfTheDrawing) {
    auto setup = turned("S1", about(Vec3::UnitX(), 90));
    EXPECT_TRUE(isSquare(setup));
    setup = turned("S1", about(Vec3::UnitX(), 30));
    setup.axis = about(Vec3::UnitX(), -30) * Vec3::UnitZ();
    EXPECT_FALSE(isSquare(setup));
    EXPECT_EQ(tiltWords(setup), "30.00° off its +z");
    setup.axis = -Vec3(std::cos(degToRad(20)), std::sin(degToRad(20)), 0);
    EXPECT_EQ(tiltWords(setup), "20.00° off its -x");
}

}  // namespace
}  // namespace stepmill::report
