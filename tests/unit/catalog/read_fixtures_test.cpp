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

TEST(ReadFixtures, TakesTheShopsViseAndBlanks) {
    const FixtureFile file = fixturesFromText(
        R"({"format": 1, "unit": "inch", "setups": [], "plate": 0.5,
            "vise": {"opening": 6, "parallels": [1.5, 0.5], "grip": 0.25},
            "blank": {"side": 0.1, "sizes": [2, 1]}})",
        "shop.json");
    EXPECT_DOUBLE_EQ(file.vise.opening_mm, 152.4);
    EXPECT_EQ(file.vise.parallels_mm, (std::vector<double>{12.7, 1.5 * 25.4}));
    EXPECT_DOUBLE_EQ(file.vise.grip_mm, 6.35);
    EXPECT_DOUBLE_EQ(file.vise.jaw_height_mm, Vise{}.jaw_height_mm);
    EXPECT_DOUBLE_EQ(file.plate_mm, 12.7);
    EXPECT_DOUBLE_EQ(file.blank.side_mm, 2.54);
    EXPECT_EQ(file.blank.sizes_mm, (std::vector<double>{25.4, 50.8}));
}

TEST(ReadFixtures, HasAnOrdinaryViseWhereTheShopSaysNothing) {
    const FixtureFile file = fixturesFromText(R"({"format": 1, "unit": "mm", "setups": []})", "shop.json");
    EXPECT_EQ(file.vise, Vise{});
    EXPECT_EQ(file.blank, BlankRule{});
    EXPECT_EQ(file.plate_mm, kPlateThicknessMm);
}

TEST(ReadFixtures, RefusesAViseThatCannotBe) {
    const auto with = [](const std::string& vise) {
        return R"({"format": 1, "unit": "mm", "setups": [], "vise": {)" + vise + "}}";
    };
    EXPECT_NE(
        refusal(with(R"("grip": 41)")).find("#/vise/grip: expected no more than the jaws' height, 40 mm"),
        std::string::npos);
    EXPECT_NE(refusal(with(R"("opening": 0)")).find("#/vise/opening"), std::string::npos);
    EXPECT_NE(refusal(with(R"("jaws": 2)")).find("#/vise"), std::string::npos);
}

}  // namespace
}  // namespace stepmill
