#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "stepmill/catalog/read_catalog.h"
#include "unit/catalog/catalog_test_files.h"

namespace stepmill {
namespace {

using nlohmann::json;
using test::goodLibrary;
using test::sample;
using test::thrownBy;

/// The message for a good library with one value changed (or, when null, taken away).
std::string messageWith(const std::string& pointer, const json& value) {
    json library = goodLibrary();
    const json::json_pointer place(pointer);
    if (value.is_null())
        library[place.parent_pointer()].erase(place.back());
    else
        library[place] = value;
    const Error error = thrownBy([&] { toolLibraryFromText(library.dump(), "tools.json"); });
    EXPECT_EQ(error.code(), ErrorCode::InvalidCatalog);
    return error.what();
}

std::string messageOfText(const std::string& text) {
    return thrownBy([&] { toolLibraryFromText(text, "tools.json"); }).what();
}

TEST(ToolErrors, AdaptiveCutsAreLightAndWithinTheFlutes) {
    json library = goodLibrary();
    const double diameter = library["tools"][0]["diameter"];
    const double flutes = library["tools"][0]["flute_length"];
    const auto with = [&](double step_over, double step_down) {
        return messageWith("/tools/0/cutting/0/adaptive",
                           json{{"step_over", step_over}, {"step_down", step_down}});
    };
    EXPECT_NE(with(0.6 * diameter, flutes).find("/adaptive/step_over: expected at most half the diameter"),
              std::string::npos);
    EXPECT_NE(with(0.1 * diameter, 2 * flutes).find("/adaptive/step_down: expected at most the flute length"),
              std::string::npos);
    EXPECT_NE(messageWith("/tools/0/cutting/0/adaptive", json{{"step_over", 1}}).find("step_down"),
              std::string::npos);
}

TEST(ToolErrors, NameFilePointerAndExpectation) {
    const Error error = thrownBy([] {
        json library = goodLibrary();
        library["tools"][1]["diameter"] = -6;
        toolLibraryFromText(library.dump(), "tools.json");
    });
    EXPECT_EQ(error.subject(), "tools.json#/tools/1/diameter");
    EXPECT_STREQ(error.what(),
                 "tools.json#/tools/1/diameter: expected a number from 0.0003 to 500, found -6");
}

TEST(ToolErrors, TellAMissingFieldWithWhatItShouldHold) {
    EXPECT_EQ(
        messageWith("/tools/1/flute_length", nullptr),
        "tools.json#/tools/1: expected the field \"flute_length\", a number from 0.0003 to 5000, found none");
}

TEST(ToolErrors, TellAPlungeDeeperThanTheFlutes) {
    EXPECT_EQ(messageWith("/tools/0/max_plunge", 30),
              "tools.json#/tools/0/max_plunge: expected no more than the flute length, 26, found 30");
}

TEST(ToolErrors, TellAWrongType) {
    EXPECT_EQ(messageWith("/tools/0/flute_length", {{"min", 20}, {"max", 26}}),
              "tools.json#/tools/0/flute_length: expected a number from 0.0003 to 5000, found an object");
    EXPECT_EQ(messageWith("/tools/0/number", 1.5),
              "tools.json#/tools/0/number: expected a whole number from 1 to 99999, found 1.5");
    EXPECT_EQ(messageWith("/tools/0/centre_cutting", "yes"),
              "tools.json#/tools/0/centre_cutting: expected true or false, found \"yes\"");
    EXPECT_EQ(messageWith("/tools/0/id", ""),
              "tools.json#/tools/0/id: expected a text of 1 to 100 characters, found \"\"");
}

TEST(ToolErrors, TellTheAllowedWords) {
    EXPECT_EQ(messageWith("/unit", "cm"), "tools.json#/unit: expected one of \"mm\", \"inch\", found \"cm\"");
    EXPECT_EQ(messageWith("/format", 2), "tools.json#/format: expected 1, found 2");
    EXPECT_EQ(messageWith("/tools/1/type", "broach"),
              "tools.json#/tools/1/type: expected one of \"flat\", \"ball\", \"bull\", \"drill\", \"face\", "
              "\"chamfer\", \"tap\", \"spot\", \"reamer\", \"boring\", \"countersink\", found \"broach\"");
}

TEST(ToolErrors, TellWhatAChamferMillMustSay) {
    json library = goodLibrary();
    json& mill = library["tools"][0];
    mill["type"] = "chamfer";
    mill.erase("corner_radius");
    const auto message = [&] { return messageOfText(library.dump()); };
    EXPECT_NE(message().find("expected the field \"tip_diameter\" of a chamfer mill"), std::string::npos)
        << message();
    mill["tip_diameter"] = mill["diameter"];
    mill["included_angle_deg"] = 90;
    EXPECT_NE(message().find("/tip_diameter: expected less than the diameter"), std::string::npos)
        << message();
    mill["tip_diameter"] = 0;
    const ToolAssembly read = toolLibraryFromText(library.dump(), "tools.json").tools[0];
    EXPECT_EQ(read.type, ToolType::Chamfer);
    EXPECT_EQ(read.included_angle_deg, 90);
    mill["type"] = "flat";
    EXPECT_NE(message().find("expected on a chamfer mill or countersink alone"), std::string::npos)
        << message();
}

TEST(ToolErrors, TellALibraryWithoutTools) {
    EXPECT_EQ(messageWith("/tools", json::array()),
              "tools.json#/tools: expected a list of 1 to 1000 items, found a list of 0");
}

TEST(ToolErrors, TellAnAngleOutOfRange) {
    const std::string expected =
        "tools.json#/tools/0/cutting/1/ramp_angle_deg: expected a number from 0.1 to 45, found ";
    EXPECT_EQ(messageWith("/tools/0/cutting/1/ramp_angle_deg", 46), expected + "46");
    EXPECT_EQ(messageWith("/tools/0/cutting/1/ramp_angle_deg", 0), expected + "0");
}

TEST(ToolErrors, CountTheOthersOfTheSameFile) {
    json library = goodLibrary();
    library["tools"][0]["diameter"] = 0;
    library["tools"][1]["diameter"] = "5";
    EXPECT_EQ(messageOfText(library.dump()),
              "tools.json#/tools/0/diameter: expected a number from 0.0003 to 500, found 0 (and 1 more in "
              "this file)");
}

TEST(ToolErrors, TellIdsAndNumbersUsedTwice) {
    EXPECT_EQ(messageWith("/tools/1/id", "B12"),
              "tools.json#/tools/1/id: expected a value no other tool has, found \"B12\" as in #/tools/0");
    EXPECT_EQ(messageWith("/tools/1/number", 7),
              "tools.json#/tools/1/number: expected a value no other tool has, found 7 as in #/tools/0");
}

TEST(ToolErrors, TellACornerRadiusThatDoesNotSuitTheType) {
    const std::string at = "tools.json#/tools/0/corner_radius: expected ";
    EXPECT_EQ(messageWith("/tools/0/corner_radius", 6.5),
              at + "a number greater than 0 and of at most half the diameter, 6, found 6.5");
    EXPECT_EQ(messageWith("/tools/0/type", "ball"), at + "half the diameter of a ball cutter, 6, found 1.5");
    EXPECT_EQ(messageWith("/tools/0/type", "flat"), at + "0 for a flat end mill, found 1.5");
    EXPECT_EQ(messageWith("/tools/0/corner_radius", nullptr),
              "tools.json#/tools/0: expected the field \"corner_radius\" of a bull-nose cutter, found none");
}

TEST(ToolErrors, TellFlutesLongerThanTheStickOut) {
    EXPECT_EQ(messageWith("/tools/1/flute_length", 51),
              "tools.json#/tools/1/flute_length: expected at most the stick-out, 50, found 51");
}

TEST(ToolErrors, TellAShankThatStartsInTheFlutesOrInTheHolder) {
    EXPECT_EQ(messageWith("/tools/0/shank/from", 25),
              "tools.json#/tools/0/shank/from: expected at least the flute length, 26, found 25");
    EXPECT_EQ(messageWith("/tools/0/shank/from", 44),
              "tools.json#/tools/0/shank/from: expected at most the stick-out, 43, found 44");
}

TEST(ToolErrors, TellHolderCylindersOutOfOrder) {
    EXPECT_EQ(messageWith("/tools/0/holder/1/bottom", 60),
              "tools.json#/tools/0/holder/1/bottom: expected at least the top of the cylinder below, 64, "
              "found 60");
    EXPECT_EQ(messageWith("/tools/0/holder/0/bottom", 40),
              "tools.json#/tools/0/holder/0/bottom: expected at least the stick-out, 43, found 40");
    EXPECT_EQ(messageWith("/tools/0/holder/1/top", 64),
              "tools.json#/tools/0/holder/1/top: expected more than the cylinder's bottom, 64, found 64");
}

TEST(ToolErrors, TellStepsLargerThanTheCutter) {
    EXPECT_EQ(messageWith("/tools/0/cutting/0/step_over", 12.1),
              "tools.json#/tools/0/cutting/0/step_over: expected at most the diameter, 12, found 12.1");
    EXPECT_EQ(messageWith("/tools/0/cutting/0/step_down", 27),
              "tools.json#/tools/0/cutting/0/step_down: expected at most the flute length, 26, found 27");
}

TEST(ToolErrors, TellAMillingCutterWithoutSteps) {
    EXPECT_EQ(
        messageWith("/tools/0/cutting/1/step_over", nullptr),
        "tools.json#/tools/0/cutting/1: expected the field \"step_over\" of a milling cutter, found none");
}

TEST(ToolErrors, TellAMaterialGivenTwice) {
    EXPECT_EQ(messageWith("/tools/0/cutting/1/material", "aluminium"),
              "tools.json#/tools/0/cutting/1/material: expected each material once (it is also in "
              "#/tools/0/cutting/0), found \"aluminium\"");
}

TEST(ToolErrors, TellLineAndColumnOfTextThatIsNotJson) {
    EXPECT_EQ(messageOfText("{\"format\": 1,\n  \"unit\": mm}")
                  .rfind("tools.json#: not JSON at line 2, column 11: ", 0),
              0U);
    EXPECT_EQ(messageOfText("").rfind("tools.json#: not JSON at line 1, column 1: ", 0), 0U);
}

TEST(ToolErrors, TellWhereANumberIsTooLargeForTheMachine) {
    EXPECT_EQ(messageOfText("{\"format\": 1,\n\"unit\": 1e999}"),
              "tools.json#: not JSON at line 2, column 9: number overflow parsing '1e999'");
}

TEST(ToolErrors, TellAFieldGivenTwice) {
    EXPECT_EQ(messageOfText(R"({"format": 1, "tools": [{}, {"id": "a", "id": "b"}]})"),
              "tools.json#/tools/1/id: expected each field once, found it twice");
}

TEST(ToolErrors, TellAFileThatIsNotThere) {
    EXPECT_EQ(thrownBy([] { readToolLibrary(sample("no_such_tools.json")); }).code(),
              ErrorCode::FileUnreadable);
    EXPECT_EQ(thrownBy([] { findLibraryErrors(sample("no_such_tools.json")); }).code(),
              ErrorCode::FileUnreadable);
}

/// A library file that lasts as long as the test.
class LibraryFile {
  public:
    explicit LibraryFile(const json& library)
        : path_(std::filesystem::temp_directory_path() /
                ("stepmill_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) +
                 ".json")) {
        std::ofstream(path_) << library.dump();
    }
    ~LibraryFile() { std::filesystem::remove(path_); }
    LibraryFile(const LibraryFile&) = delete;
    LibraryFile& operator=(const LibraryFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

TEST(LibraryFindings, ListEveryErrorOnceInTheFilesOrder) {
    json library = goodLibrary();
    library["tools"][0]["holder"][1]["top"] = "high";
    library["tools"][0]["diameter"] = -1;
    library["tools"][1].erase("cutting");
    const LibraryFile file(library);
    const std::vector<std::string> expected{
        "#/tools/0/diameter: expected a number from 0.0003 to 500, found -1",
        "#/tools/0/holder/1/top: expected a number from 0.0003 to 5000, found \"high\"",
        "#/tools/1: expected the field \"cutting\", a list of at most 100 items, found none"};
    EXPECT_EQ(findLibraryErrors(file.path()), expected);
}

TEST(LibraryFindings, PutItemsInTheOrderOfTheirNumbers) {
    json library = goodLibrary();
    for (int number = 10; number < 20; ++number) {
        library["tools"].push_back(library["tools"][1]);
        library["tools"].back()["number"] = number;
        library["tools"].back()["id"] = "D" + std::to_string(number);
    }
    library["tools"][2]["diameter"] = 0;
    library["tools"][10]["diameter"] = 0;
    const LibraryFile file(library);
    const std::vector<std::string> expected{
        "#/tools/2/diameter: expected a number from 0.0003 to 500, found 0",
        "#/tools/10/diameter: expected a number from 0.0003 to 500, found 0"};
    EXPECT_EQ(findLibraryErrors(file.path()), expected);
}

TEST(LibraryFindings, KeepDoubtsApartFromErrors) {
    json library = goodLibrary();
    library["tools"][0]["coating"] = "TiN";
    library["tools"][0]["holder"][1]["bottom"] = 70;
    library["tools"][1].erase("holder");
    library["tools"][1]["cutting"] = json::array();
    const LibraryFile file(library);
    std::vector<std::string> pointers;
    for (const CatalogFinding& finding : checkToolLibrary(file.path())) {
        EXPECT_TRUE(finding.doubt) << finding.pointer;
        pointers.push_back(finding.pointer);
    }
    const std::vector<std::string> expected{"#/tools/0/holder/1/bottom", "#/tools/1", "#/tools/1/cutting",
                                            "#/tools/0/coating"};
    EXPECT_EQ(pointers, expected);
    EXPECT_TRUE(findLibraryErrors(file.path()).empty());
    EXPECT_EQ(readToolLibrary(file.path()).tools.size(), 2U);
}

TEST(LibraryFindings, AreEmptyForAGoodLibrary) {
    const LibraryFile file(goodLibrary());
    EXPECT_TRUE(findLibraryErrors(file.path()).empty());
}

TEST(LibraryFindings, TellASlotDeeperThanTheFlutes) {
    json library = goodLibrary();
    library["tools"][0]["cutting"][0]["slot_step_down"] = 27;
    EXPECT_EQ(
        messageOfText(library.dump()),
        "tools.json#/tools/0/cutting/0/slot_step_down: expected at most the flute length, 26, found 27");
}

TEST(LibraryFindings, TellARatingNoSlotCanReach) {
    json library = goodLibrary();
    library["tools"][0]["cutting"][0]["rated_removal_cm3_per_min"] = 231;
    EXPECT_EQ(messageOfText(library.dump()),
              "tools.json#/tools/0/cutting/0/rated_removal_cm3_per_min: expected at most what a full slot at "
              "step-down and feed removes, 230.4, found 231");
    library["tools"][0]["cutting"][0]["rated_removal_cm3_per_min"] = 230.4;
    const ToolLibrary read = toolLibraryFromText(library.dump(), "tools.json");
    EXPECT_DOUBLE_EQ(ratedRemovalMm3PerMin(read.tools[0].cutting[0]), 230400);
}

TEST(ReadTools, WithoutARatingTakesWhatTheStepsRemove) {
    const ToolLibrary read = toolLibraryFromText(goodLibrary().dump(), "tools.json");
    EXPECT_DOUBLE_EQ(ratedRemovalMm3PerMin(read.tools[0].cutting[0]), 5.4 * 8 * 2400);
    EXPECT_DOUBLE_EQ(slotStepDownMm(read.tools[0], read.tools[0].cutting[0]), 6);
    EXPECT_DOUBLE_EQ(slotStepDownMm(read.tools[0], read.tools[0].cutting[1]), 5);
    EXPECT_EQ(read.tools[0].cutter_material, CutterMaterial::Carbide);
}

TEST(LibraryFindings, TellACutterOfAnUnknownMaterial) {
    json library = goodLibrary();
    library["tools"][0]["cutter_material"] = "wood";
    EXPECT_NE(messageOfText(library.dump()).find("#/tools/0/cutter_material"), std::string::npos);
}

}  // namespace
}  // namespace stepmill
