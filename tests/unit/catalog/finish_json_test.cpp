#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "stepmill/catalog/json_schema.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

nlohmann::ordered_json manifestOf(const std::string& part_file) {
    return {{"part", {{"file", part_file}, {"sha256", std::string(64, '0')}}},
            {"files", nlohmann::ordered_json::array()}};
}

TEST(FinishJson, BeginsWithFormatAndVersionAndKeepsTheContentsOrder) {
    const auto json = nlohmann::ordered_json::parse(finishJson(SchemaName::Manifest, manifestOf("a.step")));
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items())
        keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"format", "stepmill", "part", "files"}));
    EXPECT_EQ(json["format"], 1);
    EXPECT_FALSE(json["stepmill"]["version"].get<std::string>().empty());
}

TEST(FinishJson, EndsInALineEndAndReplacesWhatIsNoUtf8) {
    const std::string text = finishJson(SchemaName::Manifest, manifestOf("a\xff.step"));
    EXPECT_EQ(text.back(), '\n');
    EXPECT_NE(text.find("a\xEF\xBF\xBD.step"), std::string::npos) << text;
}

TEST(FinishJson, LetsNothingOutThatBreaksTheSchema) {
    nlohmann::ordered_json broken = manifestOf("a.step");
    broken["part"] = "a.step";
    try {
        finishJson(SchemaName::Manifest, broken);
        FAIL() << "the part is no object";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Internal);
        EXPECT_EQ(error.subject(), "manifest.json");
    }
}

}  // namespace
}  // namespace stepmill
