#include <gtest/gtest.h>

#include "stepmill/catalog/hole_table.h"
#include "stepmill/catalog/json_schema.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

std::string tableWith(const std::string& entry, const std::string& unit = "mm") {
    return R"({"format": 1, "unit": ")" + unit + R"(", "holes": [)" + entry + "]}";
}

/// The error's text, which begins with its subject; empty when the table is taken.
std::string refusal(const std::string& text) {
    try {
        holeTableFromText(text, "holes.json");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::InvalidCatalog);
        return error.what();
    }
    return {};
}

TEST(ReadHoleTable, TakesRangesIdsAndThreads) {
    const HoleTable table = holeTableFromText(
        tableWith(
            R"({"diameter": {"min": 6.7, "max": 6.9}, "make": "tap", "thread": "M8", "thread_depth": 12},
                     {"ids": ["H3", "S1.F2"], "make": "drill"}, {"depth": {"min": 0, "max": 3}, "make": "leave"})"),
        "holes.json");
    ASSERT_EQ(table.entries.size(), 3U);
    EXPECT_EQ(table.entries[0].thread->name, "M8x1.25");
    EXPECT_EQ(table.entries[0].thread_depth_mm, 12);
    EXPECT_TRUE(table.entries[0].diameter->holds(6.9));
    EXPECT_FALSE(table.entries[0].diameter->holds(6.91));
    EXPECT_EQ(table.entries[1].ids, (std::vector<std::string>{"H3", "S1.F2"}));
    EXPECT_EQ(table.entries[1].make, HoleMaking::Drill);
    EXPECT_EQ(table.entries[2].make, HoleMaking::Leave);
    EXPECT_EQ(table.entries[2].pointer, "#/holes/2");
    EXPECT_FALSE(table.sha256.empty());
}

TEST(ReadHoleTable, ConvertsInches) {
    const HoleTable table = holeTableFromText(
        tableWith(R"({"diameter": {"min": 0.2, "max": 0.202}, "make": "tap", "thread": "1/4-20",
                      "thread_depth": 0.5})",
                  "inch"),
        "holes.json");
    EXPECT_DOUBLE_EQ(table.entries[0].diameter->least_mm, 0.2 * 25.4);
    EXPECT_DOUBLE_EQ(table.entries[0].thread_depth_mm, 12.7);
}

TEST(ReadHoleTable, NamesThePlaceOfWhatIsWrongAndWhatWasExpected) {
    const std::string sized = R"("diameter": {"min": 5, "max": 6})";
    EXPECT_EQ(refusal(tableWith("{" + sized + R"(, "make": "tap", "thread": "M8x9"})")),
              "holes.json#/holes/0/thread: expected a thread such as M8, M8x1 or 1/4-20 UNC, found \"M8x9\"");
    EXPECT_EQ(refusal(tableWith("{" + sized + R"(, "make": "tap"})")),
              "holes.json#/holes/0: expected the field \"thread\" of a hole to be tapped, found none");
    EXPECT_EQ(refusal(tableWith("{" + sized + R"(, "make": "drill", "thread": "M6"})")),
              "holes.json#/holes/0/thread: expected with \"make\": \"tap\" alone");
    EXPECT_EQ(refusal(tableWith(R"({"make": "drill"})")),
              "holes.json#/holes/0: expected at least one of diameter, depth and ids, found none");
    EXPECT_EQ(refusal(tableWith(R"({"diameter": {"min": 6, "max": 5}, "make": "drill"})")),
              "holes.json#/holes/0/diameter/max: expected no less than min, 6, found 5");
    EXPECT_NE(refusal(tableWith(R"({"ids": ["F3"], "make": "drill"})")).find("holes.json#/holes/0/ids/0"),
              std::string::npos);
    EXPECT_NE(refusal(tableWith("{" + sized + R"(, "make": "glue"})")).find("holes.json#/holes/0/make"),
              std::string::npos);
    EXPECT_NE(refusal(R"({"format": 1, "unit": "mm", "holes": []})").find("holes.json#/holes"),
              std::string::npos);
    EXPECT_NE(refusal("{").find("holes.json"), std::string::npos);
}

TEST(ReadHoleTable, TheSchemaIsCompiledIn) {
    EXPECT_TRUE(schemaErrors(SchemaName::Holes,
                             tableWith(R"({"ids": ["H1"], "make": "leave", "note": "customer drills it"})"))
                    .empty());
    EXPECT_FALSE(schemaErrors(SchemaName::Holes, tableWith(R"({"ids": ["H1"]})")).empty());
}

}  // namespace
}  // namespace stepmill
