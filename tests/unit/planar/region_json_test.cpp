#include "stepmill/planar/region_json.h"

#include <gtest/gtest.h>

#include "stepmill/core/error.h"
#include "stepmill/planar/region_text.h"

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

void expectComplaint(const std::string& text, const std::string& complaint) {
    try {
        regionFromJson(Json::parse(text), "pocket");
        FAIL() << "no error for: " << text;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::InvalidRegion);
        EXPECT_EQ(error.subject(), "pocket");
        EXPECT_NE(std::string(error.what()).find(complaint), std::string::npos) << error.what();
    }
}

TEST(RegionJson, SaysLinesArcsAndHoles) {
    const Region region = regionFromText(
        "loop 0 0  line 10 0  arc 10 2 centre 10 1 ccw  line 0 2  close\n"
        "circle 5 1 radius 0.5 cw\n",
        "slot");
    EXPECT_EQ(regionToJson(region).dump(),
              R"({"loops":[{"hole":false,"start":[0.0,0.0],"segments":[{"to":[10.0,0.0]},)"
              R"({"to":[10.0,2.0],"centre":[10.0,1.0],"ccw":true},{"to":[0.0,2.0]},{"to":[0.0,0.0]}]},)"
              R"({"hole":true,"start":[4.5,1.0],"segments":[{"to":[5.5,1.0],"centre":[5.0,1.0],"ccw":false},)"
              R"({"to":[4.5,1.0],"centre":[5.0,1.0],"ccw":false}]}]})");
}

TEST(RegionJson, RoundTripThroughTextIsExact) {
    const Arc arc{{0.1, -0.3}, 2, true};
    const Vec2 a = snapToGrid(Vec2(0.1 + 2 * std::cos(1.0), -0.3 + 2 * std::sin(1.0)));
    const Vec2 b = snapToGrid(Vec2(0.1 + 2 * std::cos(2.3), -0.3 + 2 * std::sin(2.3)));
    const Region region{{Loop{a, {{b, {{snapToGrid(arc.centre), 2, true}}}, {a, std::nullopt}}}}};
    const Region again = regionFromJson(Json::parse(regionToJson(region).dump()), "segment");
    EXPECT_EQ(toText(again), toText(region));
    ASSERT_EQ(again.loops.size(), 1u);
    EXPECT_EQ(again.loops[0].start, a);
    EXPECT_EQ(again.loops[0].segments[0].to, b);
    EXPECT_EQ(again.loops[0].segments[0].arc, region.loops[0].segments[0].arc);
}

TEST(RegionJson, EmptyRegionHasNoLoops) {
    EXPECT_EQ(regionToJson(Region{}).dump(), R"({"loops":[]})");
    EXPECT_TRUE(regionFromJson(Json::parse(R"({"loops":[]})"), "empty").empty());
}

TEST(RegionJson, ErrorsNameLoopAndExpectation) {
    expectComplaint("[]", "expected 'loops', a list");
    expectComplaint(R"({"loops": [{"segments": []}]})", "loop 0: expected 'start'");
    expectComplaint(R"({"loops": [{"start": [0], "segments": []}]})",
                    "loop 0: expected a point of two numbers");
    expectComplaint(R"({"loops": [{"start": [0, "x"], "segments": []}]})", "loop 0: expected a number");
    expectComplaint(R"({"loops": [{"start": [0, 1e9], "segments": []}]})", "a length of a kilometre at most");
    expectComplaint(R"({"loops": [{"start": [0, 0], "segments": [{"to": [1, 0], "centre": [0, 0]}]}]})",
                    "loop 0: expected 'ccw'");
    expectComplaint(
        R"({"loops": [{"start": [0, 0], "segments": [{"to": [0, 0], "centre": [0, 0], "ccw": true}]}]})",
        "loop 0: expected a positive radius");
}

}  // namespace
}  // namespace stepmill
