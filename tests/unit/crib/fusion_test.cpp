#include <gtest/gtest.h>

#include <zip.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/crib/export_tools.h"
#include "unit/crib/crib_test_files.h"

namespace stepmill {
namespace {

using nlohmann::json;
using test::fusion;
using test::goodFusion;
using test::refusalOf;

TEST(Fusion, GivesAToolWithHolderAndCuttingData) {
    const ForeignLibrary library = fusion(goodFusion());
    ASSERT_EQ(library.tools.size(), 2u);
    const ToolAssembly& mill = library.tools[0].tool;
    EXPECT_EQ(mill.type, ToolType::Flat);
    EXPECT_EQ(mill.number, 4);
    EXPECT_DOUBLE_EQ(mill.diameter_mm, 10);
    EXPECT_DOUBLE_EQ(mill.flute_length_mm, 24);
    EXPECT_DOUBLE_EQ(mill.stick_out_mm, 38);
    EXPECT_DOUBLE_EQ(mill.shank.bottom_mm, 26);
    EXPECT_EQ(mill.flutes, 3);
    ASSERT_EQ(mill.cutting.size(), 1u);
    EXPECT_EQ(mill.cutting[0].material, "aluminium");
    EXPECT_DOUBLE_EQ(mill.cutting[0].feed_mm_per_min, 1800);
    EXPECT_EQ(mill.cutting[0].coolant, Coolant::Mist);
}

TEST(Fusion, TakesAConeOfAHolderAsItsThickerEndAndSaysSo) {
    const ForeignTool tool = fusion(goodFusion()).tools[0];
    ASSERT_EQ(tool.tool.holder.size(), 2u);
    EXPECT_DOUBLE_EQ(tool.tool.holder[0].diameter_mm, 32);
    EXPECT_DOUBLE_EQ(tool.tool.holder[0].bottom_mm, 38);
    EXPECT_DOUBLE_EQ(tool.tool.holder[1].top_mm, 98);
    ASSERT_EQ(tool.notes.size(), 1u);
    EXPECT_NE(tool.notes[0].find("cones"), std::string::npos);
}

TEST(Fusion, ReadsInchesAndFeedsPerTurn) {
    const ToolAssembly drill = fusion(goodFusion()).tools[1].tool;
    EXPECT_DOUBLE_EQ(drill.diameter_mm, 6.35);
    EXPECT_DOUBLE_EQ(drill.point_angle_deg, 135);
    EXPECT_EQ(drill.cutter_material, CutterMaterial::Hss);
    EXPECT_NEAR(drill.cutting.at(0).feed_mm_per_min, 3000 * 0.004 * 25.4, 1e-9);
}

TEST(Fusion, HasNoToolOfATypeThatStepmillLacks) {
    json library = goodFusion();
    for (const char* type : {"thread mill", "tapered mill", "center drill", "holder", "turning general"}) {
        library["data"][0]["type"] = type;
        EXPECT_FALSE(fusion(library).tools[0].unfit.empty()) << type;
    }
}

TEST(Fusion, HasNoToolWhoseFlanksLean) {
    json library = goodFusion();
    library["data"][0]["geometry"]["TA"] = 3;
    EXPECT_NE(fusion(library).tools[0].unfit.find("3 degrees"), std::string::npos);
}

TEST(Fusion, NamesPlaceAndExpectationOfWhatIsWrong) {
    const auto refusal = [](const char* pointer, const json& value) {
        json library = goodFusion();
        library[json::json_pointer(pointer)] = value;
        return refusalOf([&] { fusion(library); });
    };
    EXPECT_NE(refusal("/data/0/geometry/DC", 0).find("lib.json#/data/0: expected a tool's diameter"),
              std::string::npos);
    EXPECT_NE(refusal("/data/0/geometry/DC", 9000).find("found 9000 mm"), std::string::npos);
    EXPECT_NE(refusal("/data/1/unit", "furlongs").find("lib.json#/data/1/unit: expected \"millimeters\""),
              std::string::npos);
    EXPECT_NE(refusal("/data/0/geometry/LCF", "long").find("#/data/0/geometry/LCF: expected a number"),
              std::string::npos);
    EXPECT_NE(refusal("/data/0/geometry/LCF", -1).find("a number of 0 or more"), std::string::npos);
    EXPECT_NE(refusal("/data", 3).find("#/data: expected a list"), std::string::npos);
    EXPECT_NE(refusalOf([] { fusion(json::object()); }).find("the list \"data\""), std::string::npos);
    EXPECT_NE(refusalOf([] { fusionFromText("{", "lib.json", {}); }).find("lib.json"), std::string::npos);
}

TEST(Fusion, LeavesOutToolsWithoutADiameterWhenAsked) {
    json library = goodFusion();
    library["data"][0]["geometry"].erase("DC");
    ForeignOptions options;
    options.leave_out = true;
    EXPECT_FALSE(fusion(library, options).tools[0].unfit.empty());
    EXPECT_TRUE(fusion(library, options).tools[1].unfit.empty());
}

TEST(Fusion, CallsMaterialsAsItIsTold) {
    ForeignOptions options;
    options.materials = {{"Rough", "6061"}};
    EXPECT_EQ(fusion(goodFusion(), options).tools[0].tool.cutting.at(0).material, "6061");
}

TEST(FusionExport, ReadsBackAsItWas) {
    for (const char* sample :
         {"shop_metric_tools.json", "shop_with_forms_tools.json", "shop_with_taps_tools.json",
          "shop_for_holes_tools.json", "dsouza2006_tools.json"}) {
        const ToolLibrary library = readToolLibrary(test::sample(sample));
        const ImportedLibrary again = importTools(fusionFromText(fusionJson(library), sample, {}), nullptr);
        EXPECT_TRUE(again.complete()) << importText(again);
        ASSERT_EQ(again.library.tools.size(), library.tools.size()) << sample;
        for (std::size_t i = 0; i < library.tools.size(); ++i)
            test::expectSameForFusion(library.tools[i], again.library.tools[i]);
    }
}

/// A zip of one file, as libzip packs it.
std::string zipOf(const std::string& name, const std::string& content, int times = 1) {
    zip_source_t* buffer = zip_source_buffer_create(nullptr, 0, 0, nullptr);
    zip_source_keep(buffer);
    zip_t* archive = zip_open_from_source(buffer, ZIP_TRUNCATE, nullptr);
    for (int i = 0; i < times; ++i)
        zip_file_add(archive, (std::to_string(i) + name).c_str(),
                     zip_source_buffer(archive, content.data(), content.size(), 0), ZIP_FL_ENC_UTF_8);
    zip_close(archive);
    zip_stat_t stat;
    zip_source_stat(buffer, &stat);
    std::string bytes(stat.size, '\0');
    zip_source_open(buffer);
    zip_source_read(buffer, bytes.data(), bytes.size());
    zip_source_close(buffer);
    zip_source_free(buffer);
    return bytes;
}

TEST(FusionZip, GivesTheLibraryInIt) {
    const std::string library = goodFusion().dump();
    EXPECT_EQ(jsonOfZip(zipOf("tools.json", library), "lib.tools", 1 << 20), library);
}

TEST(FusionZip, RefusesABomb) {
    const std::string bomb = zipOf("tools.json", std::string(50'000'000, ' '));
    EXPECT_LT(bomb.size(), 100'000u);
    EXPECT_NE(refusalOf([&] { jsonOfZip(bomb, "lib.tools", 1 << 29); }).find("zip bomb"), std::string::npos);
    EXPECT_NE(refusalOf([&] { jsonOfZip(bomb, "lib.tools", 1 << 19); }).find("--max-file-size"),
              std::string::npos);
}

TEST(FusionZip, RefusesWhatIsNoZipAndWhatHoldsNoLibrary) {
    EXPECT_NE(refusalOf([] {
                  jsonOfZip("PK nothing", "lib.tools", 1 << 20);
              }).find("lib.tools, zip: expected a zip"),
              std::string::npos);
    EXPECT_NE(refusalOf([] { jsonOfZip(zipOf("a.txt", "x"), "lib.tools", 1 << 20); }).find("one JSON file"),
              std::string::npos);
    EXPECT_NE(refusalOf([] { jsonOfZip(zipOf("a.json", "x", 2), "lib.tools", 1 << 20); }).find("found 2"),
              std::string::npos);
    std::string damaged = zipOf("tools.json", goodFusion().dump());
    for (std::size_t i = 60; i < 100; ++i)
        damaged[i] = static_cast<char>(damaged[i] ^ 0x5A);
    EXPECT_NE(refusalOf([&] { jsonOfZip(damaged, "lib.tools", 1 << 20); }).find("damaged"),
              std::string::npos);
}

}  // namespace
}  // namespace stepmill
