#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "unit/catalog/catalog_test_files.h"

namespace stepmill {
namespace {

using nlohmann::json;
using test::goodLibrary;
using test::thrownBy;

json rangedLibrary(double min, double max) {
    json library = goodLibrary();
    library["tools"][0]["stick_out"] = {{"min", min}, {"max", max}};
    return library;
}

std::string messageOf(const json& library) {
    const Error error = thrownBy([&] { toolLibraryFromText(library.dump(), "tools.json"); });
    EXPECT_EQ(error.code(), ErrorCode::InvalidCatalog);
    return error.what();
}

TEST(StickOutRange, IsReadWithTheToolAtItsLongest) {
    const ToolAssembly tool = toolLibraryFromText(rangedLibrary(30, 43).dump(), "tools.json").tools[0];
    ASSERT_TRUE(tool.stick_out_range);
    EXPECT_DOUBLE_EQ(tool.stick_out_range->shortest_mm, 30);
    EXPECT_DOUBLE_EQ(tool.stick_out_range->longest_mm, 43);
    EXPECT_DOUBLE_EQ(tool.stick_out_mm, 43);
    EXPECT_DOUBLE_EQ(tool.shank.top_mm, 43);
    EXPECT_DOUBLE_EQ(tool.holder[0].bottom_mm, 43);
}

TEST(StickOutRange, IsInTheLibrarysUnit) {
    json library = rangedLibrary(30, 43);
    library["unit"] = "inch";
    EXPECT_DOUBLE_EQ(toolLibraryFromText(library.dump(), "tools.json").tools[0].stick_out_range->shortest_mm,
                     30 * 25.4);
}

TEST(StickOutRange, OfOneLengthIsNone) {
    EXPECT_FALSE(toolLibraryFromText(goodLibrary().dump(), "tools.json").tools[0].stick_out_range);
}

TEST(StickOutRange, TellsALongestBelowTheShortest) {
    EXPECT_NE(messageOf(rangedLibrary(43, 30))
                  .find("tools.json#/tools/0/stick_out/max: expected at least the shortest, 43, found 30.0"),
              std::string::npos);
}

TEST(StickOutRange, TellsFlutesInTheHolderAtTheShortest) {
    EXPECT_EQ(
        messageOf(rangedLibrary(20, 43)),
        "tools.json#/tools/0/flute_length: expected at most the stick-out, 20, found 26 (and 1 more in this "
        "file)");
}

TEST(StickOutRange, TellsAMissingEnd) {
    json library = goodLibrary();
    library["tools"][0]["stick_out"] = {{"min", 30}};
    EXPECT_EQ(messageOf(library),
              "tools.json#/tools/0/stick_out: expected the field \"max\", a number from 0.0003 to 5000, "
              "found none");
}

}  // namespace
}  // namespace stepmill
