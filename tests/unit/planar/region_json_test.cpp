#include "stepmill/planar/region_json.h"

#include <gtest/gtest.h>

#include "stepmill/core/error.h"
#include "stepmill/planar/region_text.h"

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

void expectComplaint(const std::string& text, const std::string& complaint) {
    try {
        loopFromJson(Json::parse(text), "pocket");
        FAIL() << "no error for: " << text;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::InvalidRegion);
        EXPECT_EQ(error.subject(), "pocket");
        EXPECT_NE(std::string(error.what()).find(complaint), std::string::npos) << error.what();
    }
}

TEST(LoopJson, SaysLinesAndArcsFromWhereTheLastOneEnded) {
    const Region region = regionFromText(
        "loop 0 0  line 10 0  arc 10 2 centre 10 1 ccw  line 0 2  close\n"
        "circle 5 1 radius 0.5 cw\n",
        "slot");
    EXPECT_EQ(loopToJson(region.loops[0]).dump(),
              "[[0,0],[10000000,0],[0,2000000,0,1000000,1],[-10000000,0],[0,-2000000]]");
    EXPECT_EQ(loopToJson(region.loops[1]).dump(),
              "[[4500000,1000000],[1000000,0,500000,0,-1],[-1000000,0,-500000,0,-1]]");
}

TEST(LoopJson, RoundTripThroughTextIsExact) {
    const Arc arc{{0.1, -0.3}, 2, true};
    const Vec2 a = snapToGrid(Vec2(0.1 + 2 * std::cos(1.0), -0.3 + 2 * std::sin(1.0)));
    const Vec2 b = snapToGrid(Vec2(0.1 + 2 * std::cos(2.3), -0.3 + 2 * std::sin(2.3)));
    const Loop loop{a, {{b, {{snapToGrid(arc.centre), 2, true}}}, {a, std::nullopt}}};
    const Loop again = loopFromJson(Json::parse(loopToJson(loop).dump()), "segment");
    EXPECT_EQ(again.start, a);
    ASSERT_EQ(again.segments.size(), 2u);
    EXPECT_EQ(again.segments[0].to, b);
    EXPECT_EQ(again.segments[0].arc, loop.segments[0].arc);
    EXPECT_EQ(again.segments[1].to, a);
}

TEST(LoopJson, RoundTripIsExactFarFromTheOrigin) {
    const Region region =
        makePolygon({{999999.999999, -999999.999999}, {123456.654321, 0.3}, {-0.000001, 0.1}});
    const Loop& loop = region.loops.front();
    const Loop again = loopFromJson(Json::parse(loopToJson(loop).dump()), "triangle");
    EXPECT_EQ(again.start, loop.start);
    for (std::size_t i = 0; i < loop.segments.size(); ++i)
        EXPECT_EQ(again.segments[i].to, loop.segments[i].to) << i;
}

TEST(LoopJson, ErrorsNameTheLoopAndWhatWasExpected) {
    expectComplaint("{}", "expected a start and segments");
    expectComplaint("[]", "expected a start and segments");
    expectComplaint("[[0, 0], 7]", "expected lists of numbers");
    expectComplaint("[[0], [1, 2]]", "expected a start of two numbers");
    expectComplaint(R"([[0, "x"], [1, 2]])", "expected a number");
    expectComplaint("[[0, 0.5], [1, 2]]", "expected whole nanometres");
    expectComplaint("[[0, 1e13], [1, 2]]", "expected a length of a kilometre at most");
    expectComplaint("[[0, 9e11], [0, 9e11]]", "expected a length of a kilometre at most");
    expectComplaint("[[0, 0], [1, 2, 3]]", "expected a line of two numbers or an arc of five or six");
    expectComplaint("[[0, 0], [1, 0, 5, 5, 2]]", "expected a turn of 1 or -1");
    expectComplaint("[[0, 0], [5, 0, 5, 0, 1]]", "expected a positive radius");
}

TEST(RegionTables, HoldEveryLoopAndEveryRegionOnce) {
    const Region small = makeRectangle({0, 0}, {1, 1});
    const Region large = makeRectangle({5, 5}, {9, 9});
    Region both = small;
    both.loops.push_back(large.loops.front());
    RegionTables tables;
    EXPECT_EQ(tables.add(both), 0u);
    EXPECT_EQ(tables.add(large), 1u);
    EXPECT_EQ(tables.add(Region{}), 2u);
    EXPECT_EQ(tables.add(both), 0u);
    EXPECT_EQ(tables.regions().dump(), "[[0,1],[1],[]]");
    ASSERT_EQ(tables.loops().size(), 2u);
    EXPECT_EQ(tables.loops()[1], loopToJson(large.loops.front()));
}

}  // namespace
}  // namespace stepmill
