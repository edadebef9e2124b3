#include <gtest/gtest.h>

#include <algorithm>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/catalog/write_catalog.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/crib/fill_tool.h"
#include "stepmill/crib/tool_squawks.h"
#include "unit/crib/crib_test_files.h"

namespace stepmill {
namespace {

using nlohmann::json;
using test::fusion;
using test::goodFusion;
using test::refusalOf;

bool anyHas(const std::vector<std::string>& lines, const std::string& words) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

/// A table in inches that says types and diameters alone.
ForeignLibrary bareTable() {
    ForeignOptions options;
    options.unit = "inch";
    return toolTableFromText("T1 P1 D0.25 ;end mill\nT2 P2 D0.125 ;drill\n", "tool.tbl", options);
}

TEST(ImportTools, GivesALibraryThatPlansRead) {
    const ImportedLibrary imported = importTools(fusion(goodFusion()), nullptr);
    EXPECT_TRUE(imported.complete());
    EXPECT_EQ(imported.library.unit, "mm");
    const ToolLibrary library =
        toolLibraryFromText(toolLibraryJson(imported.library, "test", imported.filled()), "shop.json");
    ASSERT_EQ(library.tools.size(), 2u);
    EXPECT_EQ(library.tools[0].id, "T4");
    EXPECT_EQ(library.tools[1].id, "DQ");
    EXPECT_NEAR(library.tools[1].diameter_mm, 6.35, 1e-9);
}

TEST(ImportTools, ListsWhatTheFileDoesNotSay) {
    const ImportedLibrary imported = importTools(fusion(goodFusion()), nullptr);
    EXPECT_FALSE(anyHas(imported.tools[0].gaps, "no holder"));
    EXPECT_TRUE(anyHas(imported.tools[0].gaps, "no tool life"));
    EXPECT_TRUE(anyHas(imported.tools[0].gaps, "centre"));
    EXPECT_TRUE(anyHas(imported.tools[1].gaps, "no holder"));
    EXPECT_TRUE(imported.filled().empty());
}

TEST(ImportTools, MakesUpNoLengths) {
    EXPECT_NE(refusalOf([] {
                  importTools(bareTable(), nullptr);
              }).find("does not say the flutes' length and the stick-out; --cutting-data FILE fills it"),
              std::string::npos);
}

TEST(ImportTools, FillsFromATableAndNamesItsSource) {
    const UsualValues usual = builtInUsualValues();
    const ImportedLibrary imported = importTools(bareTable(), &usual);
    EXPECT_EQ(imported.library.unit, "inch");
    ASSERT_EQ(imported.library.tools.size(), 2u);
    const FilledFields filled = imported.filled();
    ASSERT_TRUE(filled.contains("T1"));
    std::vector<std::string> fields;
    for (const FilledField& field : filled.at("T1")) {
        fields.push_back(field.field);
        EXPECT_FALSE(field.source.empty());
    }
    EXPECT_TRUE(anyHas(fields, "stick_out"));
    // A feed per tooth needs the number of teeth, which nobody told.
    EXPECT_TRUE(imported.library.tools[0].cutting.empty());
    EXPECT_EQ(imported.library.tools[1].cutting.size(), 2u);
    const std::string text = toolLibraryJson(imported.library, "", filled);
    EXPECT_EQ(filledFieldsIn(text).at("T1").size(), filled.at("T1").size());
    EXPECT_NO_THROW(toolLibraryFromText(text, "shop.json"));
}

TEST(ImportTools, FillsWhatAPresetLacksAndLeavesWhatItSays) {
    json library = goodFusion();
    library["data"][0]["start-values"]["presets"][0].erase("stepover");
    const ImportedLibrary bare = importTools(fusion(library), nullptr);
    EXPECT_TRUE(anyHas(bare.tools[0].gaps, "they have no step-over"));
    EXPECT_TRUE(bare.library.tools[0].cutting.empty());
    const UsualValues usual = builtInUsualValues();
    const ImportedLibrary filled = importTools(fusion(library), &usual);
    const CuttingData& data = filled.library.tools[0].cutting.at(0);
    EXPECT_EQ(data.material, "aluminium");
    EXPECT_DOUBLE_EQ(data.step_down_mm, 8);
    EXPECT_DOUBLE_EQ(data.step_over_mm, 4);
    EXPECT_DOUBLE_EQ(data.feed_mm_per_min, 1800);
}

TEST(ImportTools, GivesEachToolANumberAndANameOfItsOwn) {
    json library = goodFusion();
    library["data"].push_back(library["data"][0]);
    library["data"].push_back(library["data"][1]);
    library["data"][3]["post-process"]["number"] = 0;
    const ImportedLibrary imported = importTools(fusion(library), nullptr);
    ASSERT_EQ(imported.library.tools.size(), 4u);
    EXPECT_EQ(imported.library.tools[2].number, 1);
    EXPECT_TRUE(anyHas(imported.tools[2].notes, "T4 is another tool's"));
    EXPECT_EQ(imported.library.tools[3].id, "DQ (2)");
}

TEST(ImportTools, LeavesOutAToolThatBreaksARuleAndNamesIt) {
    json library = goodFusion();
    library["data"][0]["geometry"]["LCF"] = 50;  // longer than it stands out
    const ImportedLibrary imported = importTools(fusion(library), nullptr);
    EXPECT_FALSE(imported.complete());
    EXPECT_NE(imported.tools[0].left_out.find("flute_length"), std::string::npos);
    EXPECT_EQ(imported.library.tools.size(), 1u);
}

TEST(ImportTools, TakesHostileNamesAsWords) {
    json library = goodFusion();
    library["data"][0]["description"] = "\x1b[2Jred\nline\xe2\x80\xae" + std::string(5000, 'x');
    library["data"][0]["post-process"]["comment"] = "a\x07" + std::string(300, 'y');
    const ImportedLibrary imported = importTools(fusion(library), nullptr);
    const ToolAssembly& tool = imported.library.tools.at(0);
    EXPECT_LE(tool.id.size(), 100u);
    EXPECT_EQ(tool.description, plainLine(tool.description));
    EXPECT_NO_THROW(toolLibraryFromText(toolLibraryJson(imported.library, ""), "shop.json"));
}

TEST(UsualValues, AreRefusedWithTheirPlace) {
    EXPECT_NE(refusalOf([] {
                  usualValuesFromText(R"({"format": 1, "cutting": [{"material": "x", "types": ["flat"]}]})",
                                      "mine.json");
              }).find("mine.json#/cutting/0"),
              std::string::npos);
}

TEST(UsualValues, TakeTheFirstEntryThatFits) {
    const UsualValues usual = usualValuesFromText(
        R"({"format": 1, "assemblies": [
            {"types": ["flat"], "to_mm": 6, "stick_out_diameters": 9, "source": "small"},
            {"types": ["flat"], "from_mm": 6, "stick_out_diameters": 4, "source": "large",
             "holder": [{"diameter_mm": 40, "height_mm": 50}]}]})",
        "mine.json");
    ToolAssembly tool;
    tool.diameter_mm = 6;
    tool.flute_length_mm = 10;
    const std::vector<FilledField> filled = fillFrom(usual, tool);
    EXPECT_DOUBLE_EQ(tool.stick_out_mm, 24);
    ASSERT_EQ(tool.holder.size(), 1u);
    EXPECT_DOUBLE_EQ(tool.holder[0].bottom_mm, 24);
    ASSERT_EQ(filled.size(), 2u);
    EXPECT_EQ(filled[0].source, "large");
}

TEST(WriteCatalog, ReadsBackAsItWas) {
    for (const char* sample :
         {"shop_metric_tools.json", "shop_with_forms_tools.json", "shop_with_taps_tools.json",
          "shop_for_holes_tools.json", "dsouza2006_tools.json", "common_pocket_tools.json"}) {
        const ToolLibrary library = readToolLibrary(test::sample(sample));
        const std::string text = toolLibraryJson(library, "");
        const ToolLibrary again = toolLibraryFromText(text, library.file);
        EXPECT_EQ(toolLibraryJson(again, ""), text) << sample;
        ASSERT_EQ(again.tools.size(), library.tools.size());
        for (std::size_t i = 0; i < library.tools.size(); ++i) {
            test::expectSameForFusion(library.tools[i], again.tools[i]);
            EXPECT_EQ(again.tools[i].life_min, library.tools[i].life_min);
            EXPECT_EQ(again.tools[i].self_centring, library.tools[i].self_centring);
            EXPECT_NEAR(again.tools[i].lead_mm, library.tools[i].lead_mm, 1e-6);
            EXPECT_NEAR(again.tools[i].max_plunge_mm, library.tools[i].max_plunge_mm, 1e-6);
            EXPECT_EQ(again.tools[i].stick_out_range.has_value(),
                      library.tools[i].stick_out_range.has_value());
        }
    }
}

TEST(ToolSquawks, AreGradedTheMostFirst) {
    const ImportedLibrary imported = importTools(fusion(goodFusion()), nullptr);
    const std::vector<ToolSquawk> squawks = toolSquawks(imported.library, imported.filled());
    ASSERT_FALSE(squawks.empty());
    EXPECT_EQ(squawks.front().grade, SquawkGrade::Danger);
    EXPECT_EQ(squawks.front().tool, "DQ");
    EXPECT_TRUE(std::is_sorted(squawks.begin(), squawks.end(),
                               [](const ToolSquawk& a, const ToolSquawk& b) { return a.grade < b.grade; }));
}

TEST(ToolSquawks, WarnOfLengthsThatNoOneMeasured) {
    const ToolLibrary library = defaultToolLibrary();
    const auto dangers = [&](const FilledFields& filled) {
        const std::vector<ToolSquawk> squawks = toolSquawks(library, filled);
        return std::count_if(squawks.begin(), squawks.end(),
                             [](const ToolSquawk& s) { return s.grade == SquawkGrade::Danger; });
    };
    EXPECT_EQ(dangers({}), 0);
    EXPECT_EQ(dangers({{"EM20", {{"stick_out", "a table"}}}}), 1);
}

TEST(ToolSquawks, AskAfterFeedsThatAreTypingErrors) {
    ToolLibrary library = defaultToolLibrary();
    library.tools.resize(2);
    library.tools[1].cutting[0].feed_mm_per_min *= 100;
    const std::vector<ToolSquawk> squawks = toolSquawks(library, {});
    EXPECT_TRUE(std::any_of(squawks.begin(), squawks.end(), [](const ToolSquawk& squawk) {
        return squawk.text.find("typing error") != std::string::npos;
    }));
}

}  // namespace
}  // namespace stepmill
