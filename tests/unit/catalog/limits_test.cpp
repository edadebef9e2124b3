// Numbers, texts and lists at and beyond their limits.

#include <gtest/gtest.h>

#include "catalog/schema_check.h"
#include "stepmill/catalog/fixture.h"
#include "stepmill/catalog/read_catalog.h"
#include "support/told.h"
#include "unit/catalog/catalog_test_files.h"

namespace stepmill {
namespace {

using nlohmann::json;
using test::goodLibrary;
using test::thrownBy;

json withValue(json document, const std::string& pointer, const json& value) {
    document[json::json_pointer(pointer)] = value;
    return document;
}

std::string refusal(const json& library) {
    const Error error = thrownBy([&] { toolLibraryFromText(library.dump(), "tools.json"); });
    EXPECT_EQ(error.code(), ErrorCode::InvalidCatalog);
    return error.what();
}

TEST(Limits, AWholeNumberIsReadWholeOrNotAtAll) {
    EXPECT_NE(refusal(withValue(goodLibrary(), "/tools/0/number", 4294967297)).find("from 1 to 99999"),
              std::string::npos);
    EXPECT_NE(
        refusal(withValue(goodLibrary(), "/tools/0/number", 18446744073709551615U)).find("from 1 to 99999"),
        std::string::npos);
    EXPECT_NE(refusal(withValue(goodLibrary(), "/tools/0/number", 5.0)).find("a whole number"),
              std::string::npos);
    EXPECT_EQ(
        toolLibraryFromText(withValue(goodLibrary(), "/tools/0/number", 99999).dump(), "t").tools[0].number,
        99999);
}

TEST(Limits, OfLengthsAndFeedsAreInMillimetresWhateverTheUnit) {
    json library = goodLibrary();
    library["tools"].erase(1);
    library["tools"][0]["cutting"][0]["step_down"] = 0.0005;
    EXPECT_NE(refusal(library).find("cutting/0/step_down: expected 0.001 to 1000 mm, found"),
              std::string::npos);
    library["tools"][0]["cutting"][0]["step_down"] = 0.002;
    EXPECT_NO_THROW(toolLibraryFromText(library.dump(), "tools.json"));
    library["tools"][0]["cutting"][0]["feed"] = 0.5;
    EXPECT_NE(refusal(library).find("feed: expected 1 to 100000 mm/min, found 0.5"), std::string::npos);
}

TEST(Limits, ASpindleThatStandsIsRefused) {
    EXPECT_NE(refusal(withValue(goodLibrary(), "/tools/0/cutting/0/speed_rpm", 0.4)).find("from 1 to 200000"),
              std::string::npos);
}

TEST(Limits, ALifeIsNotGivenOrLongEnoughToCut) {
    EXPECT_NO_THROW(toolLibraryFromText(withValue(goodLibrary(), "/tools/0/life_min", 0).dump(), "t"));
    EXPECT_NE(refusal(withValue(goodLibrary(), "/tools/0/life_min", 1e-300)).find("at least 0.1 minutes"),
              std::string::npos);
}

TEST(Limits, PassesAreNotThinnerThanAThousandthOfTheDiameter) {
    EXPECT_NE(
        refusal(withValue(goodLibrary(), "/tools/0/cutting/0/step_over", 0.002)).find("of the diameter"),
        std::string::npos);
}

TEST(Limits, TextsAndListsHaveALength) {
    EXPECT_TRUE(test::tells(refusal(withValue(goodLibrary(), "/tools/0/id", std::string(5000000, 'x'))),
                            {"#/tools/0/id", "1 to 100", "characters"}));
    json many = goodLibrary();
    for (int i = 0; i < 1000; ++i)
        many["tools"].push_back(many["tools"][0]);
    EXPECT_TRUE(test::tells(refusal(many), {"#/tools", "1 to 1000", "1002"}));
}

TEST(Limits, CharactersAreCountedNotBytes) {
    std::string name;
    for (int i = 0; i < 100; ++i)
        name += "Ø";
    EXPECT_NO_THROW(toolLibraryFromText(withValue(goodLibrary(), "/tools/0/id", name).dump(), "t"));
}

TEST(Limits, ALongSetupNameEndsNoRun) {
    const std::string name = "S1" + std::string(200000, '0');
    const std::string text =
        R"({"format": 1, "unit": "mm", "setups": [{"setup": ")" + name + R"(", "fixtures": []}]})";
    EXPECT_EQ(thrownBy([&] { fixturesFromText(text, "clamps.json"); }).code(), ErrorCode::InvalidCatalog);
}

void expectBounded(const json& schema, const std::string& pointer) {
    if (schema.is_array())
        for (std::size_t i = 0; i < schema.size(); ++i)
            expectBounded(schema[i], pointer + "/" + std::to_string(i));
    if (!schema.is_object()) return;
    if (schema.contains("pattern") && schema["pattern"].is_string()) {
        // std::regex goes as deep as it repeats.
        EXPECT_EQ(schema["pattern"].get<std::string>().find_first_of("*+"), std::string::npos) << pointer;
    }
    const json type = schema.value("type", json());
    const auto is = [&type](const char* name) {
        return type == name || (type.is_array() && std::find(type.begin(), type.end(), name) != type.end());
    };
    if (is("number") || is("integer")) {
        EXPECT_TRUE(schema.contains("minimum") || schema.contains("exclusiveMinimum")) << pointer;
        EXPECT_TRUE(schema.contains("maximum") || schema.contains("exclusiveMaximum")) << pointer;
    }
    for (const auto& [name, value] : schema.items())
        expectBounded(value, pointer + "/" + name);
}

TEST(Limits, EveryNumberOfAnInputHasASmallestAndALargestValue) {
    for (const SchemaName name :
         {SchemaName::Tools, SchemaName::Machine, SchemaName::Fixtures, SchemaName::Plan})
        expectBounded(schemaJson(name), std::to_string(static_cast<int>(name)) + "#");
}

TEST(Limits, NoPatternRepeatsWithoutBound) {
    for (const SchemaName name : {SchemaName::Inspect, SchemaName::Rank, SchemaName::Verify})
        for (const std::string pattern : {"]*", "]+", ")*", ")+"})
            EXPECT_EQ(schemaText(name).find(pattern), std::string::npos) << static_cast<int>(name) << pattern;
}

}  // namespace
}  // namespace stepmill
