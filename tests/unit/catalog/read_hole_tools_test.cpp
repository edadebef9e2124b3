// Spot drills, reamers and boring heads in libraries, fits in hole tables.

#include <gtest/gtest.h>

#include "stepmill/catalog/hole_table.h"
#include "stepmill/catalog/read_catalog.h"
#include "unit/catalog/catalog_test_files.h"

namespace stepmill {
namespace {

using nlohmann::json;
using test::goodLibrary;
using test::thrownBy;

json libraryWith(json tool) {
    json library = goodLibrary();
    tool.update({{"id", "T"},
                 {"number", 40},
                 {"flute_length", 22},
                 {"stick_out", 60},
                 {"cutting", json::parse(R"([{"material": "steel", "feed": 500, "speed_rpm": 400}])")}});
    library["unit"] = "mm";
    library["tools"] = json::array({std::move(tool)});
    return library;
}

ToolAssembly read(json tool) {
    return toolLibraryFromText(libraryWith(std::move(tool)).dump(), "tools.json").tools.front();
}

std::string refusal(json tool) {
    const std::string text = libraryWith(std::move(tool)).dump();
    return thrownBy([&] { toolLibraryFromText(text, "tools.json"); }).what();
}

TEST(ReadHoleTools, ASpotDrillHasNinetyDegreesUnlessSaid) {
    const ToolAssembly spot = read({{"type", "spot"}, {"diameter", 8}});
    EXPECT_TRUE(spot.isSpot());
    EXPECT_EQ(spot.point_angle_deg, 90);
    EXPECT_EQ(read({{"type", "spot"}, {"diameter", 8}, {"point_angle_deg", 60}}).point_angle_deg, 60);
}

TEST(ReadHoleTools, BluntDrillsCentreThemselvesUnlessSaid) {
    EXPECT_FALSE(read({{"type", "drill"}, {"diameter", 8}}).self_centring);
    EXPECT_TRUE(read({{"type", "drill"}, {"diameter", 8}, {"point_angle_deg", 140}}).self_centring);
    EXPECT_TRUE(read({{"type", "drill"}, {"diameter", 8}, {"self_centring", true}}).self_centring);
    EXPECT_FALSE(
        read({{"type", "drill"}, {"diameter", 8}, {"point_angle_deg", 140}, {"self_centring", false}})
            .self_centring);
}

TEST(ReadHoleTools, WhatSizesHasALead) {
    EXPECT_NEAR(read({{"type", "reamer"}, {"diameter", 8}}).lead_mm, 0.8, 1e-12);
    EXPECT_EQ(read({{"type", "boring"}, {"diameter", 20}}).lead_mm, 0);
    EXPECT_EQ(read({{"type", "boring"}, {"diameter", 20}, {"lead", 0.4}}).lead_mm, 0.4);
    EXPECT_TRUE(read({{"type", "reamer"}, {"diameter", 8}}).isSizer());
}

TEST(ReadHoleTools, ACountersinkIsAConeThatNeedsNoStepOver) {
    const ToolAssembly sink =
        read({{"type", "countersink"}, {"diameter", 16}, {"tip_diameter", 3.2}, {"included_angle_deg", 82}});
    EXPECT_TRUE(sink.isCountersink() && sink.isForHoles() && sink.isForm() && sink.hasFlanks());
    EXPECT_EQ(sink.tip_diameter_mm, 3.2);
    EXPECT_EQ(sink.included_angle_deg, 82);
    EXPECT_NE(refusal({{"type", "countersink"}, {"diameter", 16}, {"included_angle_deg", 90}})
                  .find("expected the field \"tip_diameter\" of a countersink"),
              std::string::npos);
}

TEST(ReadHoleTools, FieldsOfOthersAreRefused) {
    EXPECT_EQ(refusal({{"type", "drill"}, {"diameter", 8}, {"point_angle_deg", 80}}),
              "tools.json#/tools/0/point_angle_deg: expected 90 degrees or more of a drill, found 80");
    EXPECT_EQ(refusal({{"type", "reamer"}, {"diameter", 8}, {"point_angle_deg", 118}}),
              "tools.json#/tools/0/point_angle_deg: expected on a drill or spot drill alone");
    EXPECT_EQ(refusal({{"type", "spot"}, {"diameter", 8}, {"self_centring", true}}),
              "tools.json#/tools/0/self_centring: expected on a drill alone");
    EXPECT_EQ(refusal({{"type", "drill"}, {"diameter", 8}, {"lead", 1}}),
              "tools.json#/tools/0/lead: expected on a reamer or boring head alone");
    EXPECT_EQ(refusal({{"type", "reamer"}, {"diameter", 8}, {"lead", 22}}),
              "tools.json#/tools/0/lead: expected less than the flute length, 22, found 22");
}

HoleTable tableOf(const std::string& entry) {
    return holeTableFromText(R"({"format": 1, "unit": "mm", "holes": [)" + entry + "]}", "holes.json");
}

TEST(ReadHoleTools, AHoleTableNamesFits) {
    const HoleTable table = tableOf(R"({"ids": ["H1"], "make": "ream", "fit": "H7"})");
    EXPECT_EQ(table.entries.front().make, HoleMaking::Ream);
    EXPECT_EQ(table.entries.front().fit->name, "H7");
    EXPECT_EQ(tableOf(R"({"ids": ["H1"], "make": "bore", "fit": "G6"})").entries.front().make,
              HoleMaking::Bore);
    const auto message = [](const std::string& entry) {
        return std::string(thrownBy([&] { tableOf(entry); }).what());
    };
    EXPECT_EQ(message(R"({"ids": ["H1"], "make": "ream"})"),
              "holes.json#/holes/0: expected the field \"fit\" of a hole to be reamed or bored, found none");
    EXPECT_EQ(message(R"({"ids": ["H1"], "make": "drill", "fit": "H7"})"),
              "holes.json#/holes/0/fit: expected with \"make\": \"ream\" or \"bore\" alone");
    EXPECT_NE(message(R"({"ids": ["H1"], "make": "ream", "fit": "P7"})").find("such as H7, found \"P7\""),
              std::string::npos);
}

}  // namespace
}  // namespace stepmill
