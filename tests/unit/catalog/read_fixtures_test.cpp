#include <gtest/gtest.h>

#include "stepmill/catalog/fixture.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

std::string fileWith(const std::string& fixture, const std::string& unit = "mm") {
    return R"({"format": 1, "unit": ")" + unit + R"(", "setups": [{"setup": "S1", "fixtures": [)" + fixture +
           "]}]}";
}

const std::string kClamp =
    R"({"name": "clamp", "outline": [[0, 0], [0, 2], [1, 2], [1, 0]], "bottom": 0, "top": 0.5})";

/// "subject: text" of the error the text is refused with; empty when it is taken.
std::string refusal(const std::string& text) {
    try {
        fixturesFromText(text, "clamps.json");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::InvalidCatalog);
        return error.subject() + ": " + error.what();
    }
    return {};
}

TEST(ReadFixtures, TakesOutlinesInEitherSenseAndConvertsInches) {
    const FixtureFile file = fixturesFromText(fileWith(kClamp, "inch"), "clamps.json");
    EXPECT_EQ(file.growth, kFixtureGrowth);
    ASSERT_EQ(file.setups.at("S1").size(), 1U);
    const Fixture& clamp = file.setups.at("S1").front();
    EXPECT_EQ(clamp.name, "clamp");
    EXPECT_NEAR(area(clamp.section), 2 * 25.4 * 25.4, 1e-3);
    EXPECT_DOUBLE_EQ(clamp.top_z_mm, 12.7);
}

TEST(ReadFixtures, NamesThePlaceOfWhatIsWrong) {
    EXPECT_NE(refusal(fileWith(R"({"name": "a", "outline": [[0, 0], [1, 0]], "bottom": 0, "top": 5})"))
                  .find("clamps.json#/setups/0/fixtures/0/outline"),
              std::string::npos);
    EXPECT_NE(
        refusal(fileWith(R"({"name": "a", "outline": [[0, 0], [1, 0], [1, 1]], "bottom": 5, "top": 5})"))
            .find("#/setups/0/fixtures/0/top: expected a top above the bottom (5), found 5"),
        std::string::npos);
    EXPECT_NE(
        refusal(
            fileWith(R"({"name": "a", "outline": [[0, 0], [4, 4], [4, 0], [0, 4]], "bottom": 0, "top": 5})"))
            .find("an outline that does not cross itself"),
        std::string::npos);
    EXPECT_NE(
        refusal(fileWith(R"({"name": "a", "outline": [[0, 0], [1e9, 0], [1, 1]], "bottom": 0, "top": 5})"))
            .find("#/setups/0/fixtures/0/outline/1/0: expected a number from -10000 to 10000, found"),
        std::string::npos);
    EXPECT_NE(refusal(R"({"format": 1, "unit": "mm", "setups": [{"setup": "S1", "fixtures": []},
                          {"setup": "S1", "fixtures": []}]})")
                  .find("#/setups/1/setup: expected every setup once"),
              std::string::npos);
}

}  // namespace
}  // namespace stepmill
