#include "catalog/json_layout.h"

#include <gtest/gtest.h>

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

TEST(JsonLayout, PutsOnOneLineWhatFits) {
    EXPECT_EQ(laidOut(Json{{"a", {1, 2.5, nullptr}}, {"b", {{"c", "d"}}}}),
              R"({"a":[1,2.5,null],"b":{"c":"d"}})");
    EXPECT_EQ(laidOut(Json::array()), "[]");
    EXPECT_EQ(laidOut(7), "7");
}

TEST(JsonLayout, GivesEveryFieldOfALongObjectItsLine) {
    const std::string word(60, 'x');
    EXPECT_EQ(laidOut(Json{{"one", word}, {"two", {{"deep", word}, {"deeper", word}}}}),
              "{\n \"one\": \"" + word + "\",\n \"two\": {\n  \"deep\": \"" + word + "\",\n  \"deeper\": \"" +
                  word + "\"\n }\n}");
}

TEST(JsonLayout, FillsLinesWithNumbersAndRows) {
    const Json numbers = std::vector<int>(100, 1000);
    const std::string text = laidOut(numbers);
    EXPECT_EQ(text.substr(0, 3), "[\n ");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 6) << "22 of five characters a line";
    const Json rows = std::vector<std::vector<int>>(30, {1000, 2000});
    EXPECT_EQ(laidOut(rows).find("\n [1000,2000],[1000,2000],"), 1u);
}

TEST(JsonLayout, SaysTheSameAsItsValue) {
    Json value;
    for (int i = 0; i < 40; ++i) {
        value["list"].push_back({{"words", std::vector<std::string>(i, "two words")}, {"number", i / 7.0}});
        value["rows"].push_back(std::vector<int>(i, i));
        value["mixed"].push_back(i % 2 == 0 ? Json(i) : Json{{"i", std::string(3 * i, 'i')}});
    }
    EXPECT_EQ(Json::parse(laidOut(value)), value);
}

TEST(JsonLayout, ReplacesBytesThatAreNoUtf8) {
    EXPECT_EQ(laidOut(Json{{"name\xff", "\xff"}}), "{\"name\xEF\xBF\xBD\":\"\xEF\xBF\xBD\"}");
}

}  // namespace
}  // namespace stepmill
