#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/file.h"
#include "stepmill/core/units.h"
#include "unit/catalog/catalog_test_files.h"

namespace stepmill {
namespace {

using nlohmann::json;
using test::goodLibrary;
using test::sample;

ToolLibrary read(const json& library) {
    return toolLibraryFromText(library.dump(), "tools.json");
}

TEST(ReadTools, GivesEveryFieldOfATool) {
    const ToolAssembly tool = read(goodLibrary()).tools.at(0);
    EXPECT_EQ(tool.id, "B12");
    EXPECT_EQ(tool.number, 7);
    EXPECT_EQ(tool.type, ToolType::Bull);
    EXPECT_DOUBLE_EQ(tool.diameter_mm, 12);
    EXPECT_DOUBLE_EQ(tool.radius_mm(), 6);
    EXPECT_DOUBLE_EQ(tool.corner_radius_mm, 1.5);
    EXPECT_DOUBLE_EQ(tool.flute_length_mm, 26);
    EXPECT_EQ(tool.flutes, 4);
    EXPECT_TRUE(tool.centre_cutting);
    EXPECT_DOUBLE_EQ(tool.stick_out_mm, 43);
    EXPECT_DOUBLE_EQ(tool.shank.diameter_mm, 11.5);
    EXPECT_DOUBLE_EQ(tool.shank.bottom_mm, 28);
    EXPECT_DOUBLE_EQ(tool.shank.top_mm, 43);
    ASSERT_EQ(tool.holder.size(), 2U);
    EXPECT_DOUBLE_EQ(tool.holder[1].diameter_mm, 46);
    EXPECT_DOUBLE_EQ(tool.holder[1].bottom_mm, 64);
    EXPECT_DOUBLE_EQ(tool.holder[1].top_mm, 109);
    EXPECT_DOUBLE_EQ(tool.price, 58.5);
    EXPECT_DOUBLE_EQ(tool.life_min, 120);
    EXPECT_EQ(tool.description, "bull nose");
    EXPECT_EQ(tool.vendor, "Maker");
    EXPECT_EQ(tool.product_id, "X-1");
}

TEST(ReadTools, GivesEveryFieldOfTheCuttingData) {
    const ToolLibrary library = read(goodLibrary());
    const CuttingData* data = library.tool("B12").cuttingFor("steel");
    ASSERT_NE(data, nullptr);
    EXPECT_DOUBLE_EQ(data->step_over_mm, 4.8);
    EXPECT_DOUBLE_EQ(data->step_down_mm, 5);
    EXPECT_DOUBLE_EQ(data->feed_mm_per_min, 640);
    EXPECT_DOUBLE_EQ(data->plunge_feed_mm_per_min, 130);
    EXPECT_DOUBLE_EQ(data->ramp_angle_deg, 2);
    EXPECT_DOUBLE_EQ(data->speed_rpm, 3200);
}

TEST(ReadTools, LeavesZeroWhereAnOptionalFieldIsNotGiven) {
    const ToolAssembly tool = read(goodLibrary()).tool("D5");
    EXPECT_EQ(tool.flutes, 0);
    EXPECT_EQ(tool.corner_radius_mm, 0);
    EXPECT_EQ(tool.price, 0);
    EXPECT_EQ(tool.cutting.at(0).step_over_mm, 0);
    EXPECT_EQ(tool.cutting.at(0).step_down_mm, 0);
    EXPECT_EQ(tool.cutting.at(0).ramp_angle_deg, 0);
}

TEST(ReadTools, TakesAStraightShankWhenNoneIsGiven) {
    const ToolAssembly tool = read(goodLibrary()).tool("D5");
    EXPECT_DOUBLE_EQ(tool.shank.diameter_mm, 5);
    EXPECT_DOUBLE_EQ(tool.shank.bottom_mm, 32);
    EXPECT_DOUBLE_EQ(tool.shank.top_mm, 50);
}

TEST(ReadTools, AMillPlungesHalfItsDiameterUpToSixMillimetresUnlessTheLibrarySays) {
    ToolAssembly mill;
    mill.centre_cutting = true;
    mill.diameter_mm = 6;
    EXPECT_DOUBLE_EQ(usualPlungeMm(mill), 3);
    mill.diameter_mm = 6.1;
    EXPECT_DOUBLE_EQ(usualPlungeMm(mill), 0);
    mill = {};
    mill.diameter_mm = 4;
    EXPECT_DOUBLE_EQ(usualPlungeMm(mill), 0) << "no edges at its centre";
    json library = goodLibrary();
    EXPECT_DOUBLE_EQ(read(library).tool("B12").max_plunge_mm, 0);
    library["tools"][0]["max_plunge"] = 2.5;
    EXPECT_DOUBLE_EQ(read(library).tool("B12").max_plunge_mm, 2.5);
}

TEST(ReadTools, LetsOnlyDrillsCutAtTheCentreUnlessTold) {
    json library = goodLibrary();
    library["tools"][0].erase("centre_cutting");
    EXPECT_FALSE(read(library).tool("B12").centre_cutting);
    EXPECT_TRUE(read(library).tool("D5").centre_cutting);
}

TEST(ReadTools, GivesABallHalfItsDiameterAsCornerRadius) {
    json library = goodLibrary();
    library["tools"][0]["type"] = "ball";
    library["tools"][0].erase("corner_radius");
    EXPECT_DOUBLE_EQ(read(library).tool("B12").corner_radius_mm, 6);
}

TEST(ReadTools, KnowsEveryToolType) {
    for (const ToolType type :
         {ToolType::Flat, ToolType::Ball, ToolType::Bull, ToolType::Drill, ToolType::Face}) {
        json library = goodLibrary();
        library["tools"][0]["type"] = toString(type);
        if (type != ToolType::Bull) library["tools"][0].erase("corner_radius");
        EXPECT_EQ(read(library).tool("B12").type, type) << toString(type);
    }
}

TEST(ReadTools, KeepsTheOrderOfTheFile) {
    const ToolLibrary library = read(goodLibrary());
    ASSERT_EQ(library.tools.size(), 2U);
    EXPECT_EQ(library.tools[0].id, "B12");
    EXPECT_EQ(library.tools[1].id, "D5");
}

TEST(ReadTools, ConvertsInchLengthsAndFeedsButNotSpeedsAndAngles) {
    json inch = goodLibrary();
    inch["unit"] = "inch";
    const ToolLibrary library = read(inch);
    const ToolAssembly& tool = library.tool("B12");
    EXPECT_EQ(library.unit, "inch");
    EXPECT_DOUBLE_EQ(tool.diameter_mm, 12 * 25.4);
    EXPECT_DOUBLE_EQ(tool.corner_radius_mm, 1.5 * 25.4);
    EXPECT_DOUBLE_EQ(tool.flute_length_mm, 26 * 25.4);
    EXPECT_DOUBLE_EQ(tool.stick_out_mm, 43 * 25.4);
    EXPECT_DOUBLE_EQ(tool.shank.diameter_mm, 11.5 * 25.4);
    EXPECT_DOUBLE_EQ(tool.shank.bottom_mm, 28 * 25.4);
    EXPECT_DOUBLE_EQ(tool.holder[0].top_mm, 64 * 25.4);
    EXPECT_DOUBLE_EQ(tool.cutting[0].step_over_mm, 5.4 * 25.4);
    EXPECT_DOUBLE_EQ(tool.cutting[0].step_down_mm, 8 * 25.4);
    EXPECT_DOUBLE_EQ(tool.cutting[0].feed_mm_per_min, 2400 * 25.4);
    EXPECT_DOUBLE_EQ(tool.cutting[0].plunge_feed_mm_per_min, 700 * 25.4);
    EXPECT_DOUBLE_EQ(tool.cutting[0].ramp_angle_deg, 3);
    EXPECT_DOUBLE_EQ(tool.cutting[0].speed_rpm, 8500);
    EXPECT_DOUBLE_EQ(tool.life_min, 120);
}

TEST(ReadTools, ReportsUnknownFieldsWhereverTheyStand) {
    json library = goodLibrary();
    library["colour"] = "red";
    library["tools"][1]["coating/type"] = "TiAlN";
    library["tools"][0]["cutting"][1]["air"] = {{"kind", "blast"}};
    library["tools"][0]["holder"][0]["name"] = "ER25";
    const std::vector<std::string> expected{"#/colour", "#/tools/0/cutting/1/air", "#/tools/0/holder/0/name",
                                            "#/tools/1/coating~1type"};
    EXPECT_EQ(read(library).unknown_fields, expected);
}

TEST(ReadTools, TakesCoolantAndDwellOrTheirDefaults) {
    json library = goodLibrary();
    library["tools"][0]["cutting"][1]["coolant"] = "mist";
    library["tools"][0]["cutting"][1]["dwell_s"] = 0.5;
    const ToolLibrary tools = read(library);
    EXPECT_EQ(tools.tools[0].cutting[0].coolant, Coolant::Flood);
    EXPECT_EQ(tools.tools[0].cutting[0].dwell_s, 0);
    EXPECT_EQ(tools.tools[0].cutting[1].coolant, Coolant::Mist);
    EXPECT_EQ(tools.tools[0].cutting[1].dwell_s, 0.5);
}

TEST(ReadTools, NamesFileAndDigestOfTheFile) {
    const ToolLibrary library = readToolLibrary(sample("shop_metric_tools.json"));
    EXPECT_EQ(library.file, "shop_metric_tools.json");
    EXPECT_EQ(library.sha256, sha256(readFile(sample("shop_metric_tools.json"))));
}

TEST(ReadTools, ListsMaterialsSortedAndOnce) {
    EXPECT_EQ(read(goodLibrary()).materials(), (std::vector<std::string>{"aluminium", "steel"}));
}

TEST(ReadTools, FindsNoCuttingDataForAnUnknownMaterial) {
    EXPECT_EQ(read(goodLibrary()).tool("D5").cuttingFor("aluminium"), nullptr);
}

TEST(ReadTools, ThrowsWhenAskedForAToolItDoesNotHave) {
    const ToolLibrary library = read(goodLibrary());
    EXPECT_EQ(test::thrownBy([&] { (void)library.tool("nope"); }).code(), ErrorCode::Internal);
}

TEST(SampleTools, AreFreeOfErrorsAndDoubts) {
    for (const char* name : {"shop_metric_tools.json", "shop_with_taps_tools.json", "dsouza2006_tools.json"})
        for (const CatalogFinding& finding : checkToolLibrary(sample(name)))
            ADD_FAILURE() << name << finding.pointer << ": " << finding.text;
}

TEST(SampleTools, HoldThePapersTables) {
    const ToolLibrary library = readToolLibrary(sample("dsouza2006_tools.json"));
    ASSERT_EQ(library.tools.size(), 8U);
    const ToolAssembly& t5 = library.tool("t5");
    EXPECT_NEAR(t5.diameter_mm, inchToMm(0.375), 1e-12);
    EXPECT_NEAR(t5.stick_out_mm, inchToMm(0.5), 1e-12);
    EXPECT_NEAR(t5.holder.at(0).diameter_mm, inchToMm(0.6), 1e-12);
    EXPECT_NEAR(t5.holder.at(0).bottom_mm, inchToMm(0.5), 1e-12);
    EXPECT_NEAR(t5.holder.at(0).top_mm, inchToMm(0.7), 1e-12);
    EXPECT_NEAR(t5.holder.at(1).diameter_mm, inchToMm(0.8), 1e-12);
    EXPECT_NEAR(t5.holder.at(1).bottom_mm, inchToMm(0.7), 1e-12);
    EXPECT_NEAR(t5.holder.at(1).top_mm, inchToMm(1.15), 1e-12);
    const CuttingData& data = t5.cutting.at(0);
    EXPECT_EQ(data.material, "aluminium");
    EXPECT_NEAR(data.step_over_mm, inchToMm(0.1875), 1e-12);
    EXPECT_NEAR(data.step_down_mm, inchToMm(0.18), 1e-12);
    EXPECT_NEAR(data.feed_mm_per_min, inchToMm(21), 1e-9);
    EXPECT_NEAR(data.speed_rpm, 5092, 0);
}

TEST(SampleTools, OfTheShopCutBothMaterialsWithAtMostHalfTheirDiameter) {
    for (const ToolAssembly& tool : readToolLibrary(sample("shop_metric_tools.json")).tools) {
        for (const char* material : {"aluminium", "steel"}) {
            const CuttingData* data = tool.cuttingFor(material);
            ASSERT_NE(data, nullptr) << tool.id << " in " << material;
            EXPECT_LE(data->step_over_mm, tool.diameter_mm / 2) << tool.id;
            EXPECT_LE(data->speed_rpm, defaultMachine().max_speed_rpm) << tool.id;
            EXPECT_LE(data->feed_mm_per_min, defaultMachine().max_feed_mm_per_min) << tool.id;
            EXPECT_GT(data->plunge_feed_mm_per_min, 0) << tool.id;
            if (!tool.isDrill()) {
                EXPECT_GT(data->ramp_angle_deg, 0) << tool.id;
            }
        }
        EXPECT_GE(tool.holder.size(), 2U) << tool.id;
    }
}

TEST(ToolLibraryGuide, ShowsAnExampleThatReads) {
    const std::string guide =
        readFile(std::filesystem::path(STEPMILL_SOURCE_DIR) / "docs" / "tool-library.md");
    const std::string opening = "```json\n";
    const std::size_t begin = guide.find(opening) + opening.size();
    const std::string example = guide.substr(begin, guide.find("```", begin) - begin);
    const ToolLibrary library = toolLibraryFromText(example, "tool-library.md");
    EXPECT_EQ(library.tool("EM12").shank.bottom_mm, 30);
    EXPECT_TRUE(library.unknown_fields.empty());
}

TEST(DefaultCatalog, IsTheSampleLibraryAndMachine) {
    const ToolLibrary built_in = defaultToolLibrary();
    const ToolLibrary from_file = readToolLibrary(sample("shop_metric_tools.json"));
    EXPECT_EQ(built_in.sha256, from_file.sha256);
    EXPECT_EQ(built_in.file, from_file.file);
    EXPECT_EQ(built_in.tools.size(), from_file.tools.size());
    EXPECT_EQ(defaultMachine().name, readMachine(sample("machine_vmc.json")).name);
}

TEST(DefaultCatalog, FitsTheMachinesMagazine) {
    EXPECT_LE(defaultToolLibrary().tools.size(), static_cast<std::size_t>(defaultMachine().magazine_size));
}

TEST(ReadTools, TakesASecondSetForConstantEngagement) {
    json library = goodLibrary();
    json& data = library["tools"][0]["cutting"][0];
    data["adaptive"] = {{"step_over", 1.5}, {"step_down", 8}, {"feed", 1700}, {"speed_rpm", 9500}};
    const ToolLibrary with_set = read(library);
    const auto& adaptive = with_set.tools[0].cutting[0].adaptive;
    ASSERT_TRUE(adaptive);
    EXPECT_DOUBLE_EQ(adaptive->step_over_mm, 1.5);
    EXPECT_DOUBLE_EQ(adaptive->step_down_mm, 8);
    EXPECT_DOUBLE_EQ(adaptive->feed_mm_per_min, 1700);
    EXPECT_DOUBLE_EQ(adaptive->speed_rpm, 9500);
    EXPECT_EQ(adaptive->lift_mm, 0);
    EXPECT_TRUE(with_set.unknown_fields.empty());
    data.erase("adaptive");
    EXPECT_FALSE(read(library).tools[0].cutting[0].adaptive);
}

}  // namespace
}  // namespace stepmill
