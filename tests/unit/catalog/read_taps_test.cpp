#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "unit/catalog/catalog_test_files.h"

namespace stepmill {
namespace {

using nlohmann::json;
using test::goodLibrary;
using test::thrownBy;

json libraryWithTap(const std::string& unit = "mm") {
    json library = goodLibrary();
    library["unit"] = unit;
    library["tools"] = json::parse(R"([
        {"id": "TAP M8", "number": 40, "type": "tap", "thread": "M8", "diameter": 8, "flute_length": 22,
         "stick_out": 60, "cutting": [{"material": "steel", "feed": 500, "speed_rpm": 400}]}])");
    return library;
}

std::string messageWith(const std::string& field, const json& value) {
    json library = libraryWithTap();
    if (value.is_null())
        library["tools"][0].erase(field);
    else
        library["tools"][0][field] = value;
    return thrownBy([&] { toolLibraryFromText(library.dump(), "tools.json"); }).what();
}

TEST(ReadTaps, ATapHasItsThreadAndALead) {
    const ToolLibrary library = toolLibraryFromText(libraryWithTap().dump(), "tools.json");
    const ToolAssembly& tap = library.tools.front();
    EXPECT_TRUE(tap.isTap());
    EXPECT_EQ(tap.thread->name, "M8x1.25");
    EXPECT_DOUBLE_EQ(tap.lead_mm, 4 * 1.25) << "a plug tap where nothing is said";
    EXPECT_EQ(tap.max_plunge_mm, 0);
    json bottoming = libraryWithTap();
    bottoming["tools"][0]["lead_threads"] = 2;
    EXPECT_DOUBLE_EQ(toolLibraryFromText(bottoming.dump(), "tools.json").tools.front().lead_mm, 2.5);
}

TEST(ReadTaps, AnInchLibraryRoundsTheDiameterAndTheThreadDoesNot) {
    json library = libraryWithTap("inch");
    json& tap = library["tools"][0];
    tap["thread"] = "5/16-18";
    tap["diameter"] = 0.3125;
    tap["flute_length"] = 0.9;
    tap["stick_out"] = 2.4;
    tap["cutting"][0]["feed"] = 22.222;
    const ToolAssembly read = toolLibraryFromText(library.dump(), "tools.json").tools.front();
    EXPECT_DOUBLE_EQ(read.diameter_mm, 25.4 * 5 / 16);
    EXPECT_DOUBLE_EQ(read.thread->pitch_mm, 25.4 / 18);
}

TEST(ReadTaps, WhatContradictsTheThreadIsRefused) {
    EXPECT_EQ(messageWith("thread", nullptr),
              "tools.json#/tools/0: expected the field \"thread\" of a tap, found none");
    EXPECT_EQ(messageWith("thread", "M8x7"),
              "tools.json#/tools/0/thread: expected a thread such as M8, M8x1 or 1/4-20 UNC, found \"M8x7\"");
    EXPECT_EQ(messageWith("diameter", 6.8),
              "tools.json#/tools/0/diameter: expected that of M8x1.25, 8, found 6.8");
    EXPECT_EQ(messageWith("flute_length", 4.5),
              "tools.json#/tools/0/flute_length: expected more than the tap's lead, 5, found 4.5");
    EXPECT_EQ(messageWith("cutting", {{{"material", "steel"}, {"feed", 480}, {"speed_rpm", 400}}}),
              "tools.json#/tools/0/cutting/0/feed: expected pitch x speed, 500, found 480");
    EXPECT_EQ(messageWith("point_angle_deg", 120),
              "tools.json#/tools/0/point_angle_deg: expected on a drill or spot drill alone");
}

TEST(ReadTaps, OtherToolsHaveNoThread) {
    json library = goodLibrary();
    library["tools"][1]["thread"] = "M6";
    EXPECT_STREQ(thrownBy([&] { toolLibraryFromText(library.dump(), "tools.json"); }).what(),
                 "tools.json#/tools/1/thread: expected on a tap alone");
}

}  // namespace
}  // namespace stepmill
