#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "stepmill/catalog/json_schema.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

nlohmann::ordered_json manifestOf(const std::string& part_file) {
    return {{"format", 1},
            {"stepmill", {{"version", "0"}}},
            {"part", {{"file", part_file}, {"sha256", std::string(64, '0')}}},
            {"files", nlohmann::ordered_json::array()}};
}

TEST(FinishJson, EndsInALineEndAndReplacesWhatIsNoUtf8) {
    const std::string text = finishJson(SchemaName::Manifest, manifestOf("a\xff.step"));
    EXPECT_EQ(text.back(), '\n');
    EXPECT_NE(text.find("a\xEF\xBF\xBD.step"), std::string::npos) << text;
}

TEST(FinishJson, LetsNothingOutThatBreaksTheSchema) {
    nlohmann::ordered_json broken = manifestOf("a.step");
    broken["format"] = "one";
    try {
        finishJson(SchemaName::Manifest, broken);
        FAIL() << "the format is no number";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Internal);
        EXPECT_EQ(error.subject(), "manifest.json");
    }
}

}  // namespace
}  // namespace stepmill
