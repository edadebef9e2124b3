#include "stepmill/planar/region_text.h"

#include <gtest/gtest.h>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

void expectComplaint(const std::string& text, const std::string& complaint) {
    try {
        regionFromText(text, "pocket.txt");
        FAIL() << "no error for: " << text;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::InvalidRegion);
        EXPECT_EQ(error.subject(), "pocket.txt");
        EXPECT_NE(std::string(error.what()).find(complaint), std::string::npos) << error.what();
    }
}

TEST(RegionText, ReadsLoopsCirclesAndComments) {
    const Region region = regionFromText(
        "# slot with a hole\n"
        "\n"
        "loop 0 0  line 10 0  arc 10 2 centre 10 1 ccw  line 0 2  close  # open end left\n"
        "circle 5 1 radius 0.5 cw\n",
        "slot");
    ASSERT_EQ(region.loops.size(), 2u);
    EXPECT_NEAR(area(region), 20 + kPi / 2 - kPi / 4, 1e-9);
}

TEST(RegionText, RoundTripIsExact) {
    const std::string text =
        "loop 0 0  line 10.000001 0  arc 10.000001 2 centre 10.000001 1 ccw  line 0 2  close\n"
        "circle 5 1 radius 0.5 cw\n";
    EXPECT_EQ(toText(regionFromText(text, "slot")), text);
}

TEST(RegionText, KeepsARadiusThatTheRoundedEndDoesNotTell) {
    const Arc arc{{0, 0}, 2, true};
    const Vec2 a = snapToGrid(Vec2(2 * std::cos(1.0), 2 * std::sin(1.0)));
    const Vec2 b = snapToGrid(Vec2(2 * std::cos(2.3), 2 * std::sin(2.3)));
    const Region region{{Loop{a, {{b, arc}, {a, std::nullopt}}}}};
    const Region again = regionFromText(toText(region), "segment");
    ASSERT_EQ(again.loops.size(), 1u);
    EXPECT_EQ(again.loops[0].start, a);
    EXPECT_EQ(again.loops[0].segments[0].to, b);
    EXPECT_EQ(again.loops[0].segments[0].arc, arc);
}

TEST(RegionText, EmptyTextIsTheEmptyRegion) {
    EXPECT_TRUE(regionFromText("# nothing\n", "empty").empty());
    EXPECT_EQ(toText(Region{}), "");
}

TEST(RegionText, ErrorsNameLineAndExpectation) {
    expectComplaint("loop 0 0 line 1 0\n", "line 1: expected 'line', 'arc' or 'close', found the end");
    expectComplaint("\nloop 0 0 line 1 x close", "line 2: expected a number, found 'x'");
    expectComplaint("circle 0 0 radius -1 cw", "expected a positive radius, found '-1'");
    expectComplaint("circle 0 0 radius 1 left", "expected 'ccw' or 'cw', found 'left'");
    expectComplaint("square 0 0", "expected 'loop' or 'circle', found 'square'");
    expectComplaint("circle 0 0 radius 1 cw cw", "expected the end of the line");
    expectComplaint("circle nan 0 radius 1 cw", "expected a number, found 'nan'");
}

TEST(RegionText, RefusesLengthsTheGridCannotHold) {
    expectComplaint("loop 0 0 line 1e109 0 line 0 5 close",
                    "line 1: expected a length of a kilometre at most");
}

}  // namespace
}  // namespace stepmill
