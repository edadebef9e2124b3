// HSMWorks, FreeCAD, LinuxCNC and CSV.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/crib/export_tools.h"
#include "unit/crib/crib_test_files.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::refusalOf;

std::string hsmLibrary(const std::string& tools) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<tool-library xmlns=\"http://www.hsmworks.com/xml/2004/cnc/tool-library\" version=\"14\">" +
           tools + "</tool-library>";
}

const std::string kHsmMill =
    "<tool type=\"flat end mill\" unit=\"inches\" id=\"1\"><description>Half inch &amp; long</description>"
    "<manufacturer>Maker</manufacturer><nc number=\"12\"/><coolant mode=\"flood\"/><material "
    "name=\"carbide\"/>"
    "<body diameter=\"0.5\" flute-length=\"1.25\" shoulder-length=\"1.25\" body-length=\"1.75\" "
    "overall-length=\"3\""
    " number-of-flutes=\"3\" shaft-diameter=\"0.5\"/>"
    "<holder><section diameter=\"1\" length=\"0\"/><section diameter=\"1.25\" length=\"0.5\"/>"
    "<section diameter=\"1.25\" length=\"1\"/></holder>"
    "<presets><preset name=\"Aluminium\"><parameter key=\"tool_spindleSpeed\" value=\"8000\"/>"
    "<parameter key=\"tool_feedCutting\" value=\"80\"/><parameter key=\"tool_feedPlunge\" "
    "value=\"20\"/></preset>"
    "</presets></tool>";

ForeignLibrary hsm(const std::string& text) {
    return hsmFromText(text, "lib.hsmlib", {});
}

TEST(Hsm, GivesAToolWithHolderAndCuttingData) {
    const ForeignLibrary library = hsm(hsmLibrary(kHsmMill));
    ASSERT_EQ(library.tools.size(), 1u);
    const ToolAssembly& mill = library.tools[0].tool;
    EXPECT_EQ(mill.description, "Half inch & long");
    EXPECT_EQ(mill.number, 12);
    EXPECT_DOUBLE_EQ(mill.diameter_mm, 12.7);
    EXPECT_DOUBLE_EQ(mill.stick_out_mm, 1.75 * 25.4);
    ASSERT_EQ(mill.holder.size(), 2u);
    EXPECT_DOUBLE_EQ(mill.holder[0].diameter_mm, 1.25 * 25.4);
    EXPECT_NEAR(mill.holder[1].top_mm, (1.75 + 1.5) * 25.4, 1e-9);
    EXPECT_DOUBLE_EQ(mill.cutting.at(0).feed_mm_per_min, 80 * 25.4);
    EXPECT_EQ(mill.cutting.at(0).material, "Aluminium");
}

TEST(Hsm, ReadsAnglesOfDrillsWholeAndOfChamferMillsHalf) {
    const ForeignLibrary library = hsm(hsmLibrary(
        "<tool type=\"drill\" unit=\"millimeters\"><body diameter=\"2.5\" taper-angle=\"118\"/></tool>"
        "<tool type=\"chamfer mill\" unit=\"millimeters\"><body diameter=\"6\" taper-angle=\"45\"/></tool>"
        "<tool type=\"counter sink\" unit=\"millimeters\"><body diameter=\"16\" tip-diameter=\"3.2\" "
        "taper-angle=\"90\"/></tool>"));
    EXPECT_DOUBLE_EQ(library.tools[0].tool.point_angle_deg, 118);
    EXPECT_DOUBLE_EQ(library.tools[1].tool.included_angle_deg, 90);
    EXPECT_TRUE(library.tools[2].tool.isCountersink());
    EXPECT_DOUBLE_EQ(library.tools[2].tool.included_angle_deg, 90);
    EXPECT_DOUBLE_EQ(library.tools[2].tool.tip_diameter_mm, 3.2);
}

TEST(Hsm, ReadsUtf16) {
    const std::string plain =
        hsmLibrary(kHsmMill).substr(std::string("<?xml version=\"1.0\" encoding=\"UTF-8\"?>").size());
    std::string wide("\xFF\xFE", 2);
    for (const char c : plain)
        wide += {c, '\0'};
    EXPECT_EQ(hsm(wide).tools.size(), 1u);
}

TEST(Hsm, LooksAtNoEntityThatTheFileDeclares) {
    const std::string laughs =
        "<?xml version=\"1.0\"?><!DOCTYPE x [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">"
        "<!ENTITY f SYSTEM \"file:///etc/passwd\">]>"
        "<tool-library><tool type=\"drill\" unit=\"millimeters\"><description>&b;&f;</description>"
        "<body diameter=\"5\"/></tool></tool-library>";
    EXPECT_EQ(hsm(laughs).tools.at(0).tool.description, "&b;&f;");
}

TEST(Hsm, NamesPlaceAndExpectationOfWhatIsWrong) {
    EXPECT_NE(refusalOf([] { hsm("<tool-library><tool"); }).find("lib.hsmlib, byte"), std::string::npos);
    EXPECT_NE(refusalOf([] { hsm("<html/>"); }).find("expected <tool-library>, found <html>"),
              std::string::npos);
    EXPECT_NE(refusalOf([] {
                  hsm(hsmLibrary("<tool type=\"drill\" unit=\"ells\"/>"));
              }).find("lib.hsmlib, tool 1, @unit: expected 'millimeters' or 'inches', found 'ells'"),
              std::string::npos);
    EXPECT_NE(refusalOf([] {
                  hsm(hsmLibrary("<tool type=\"drill\" unit=\"inches\"><body diameter=\"wide\"/></tool>"));
              }).find("tool 1, body/@diameter: expected a number"),
              std::string::npos);
    EXPECT_NE(refusalOf([] {
                  hsm(hsmLibrary("<tool type=\"drill\" unit=\"inches\"/>"));
              }).find("expected a tool's diameter"),
              std::string::npos);
}

json goodBit() {
    return json::parse(
        R"({"version": 2, "name": "Six mill", "shape": "endmill.fcstd", "shape-type": "Endmill",
        "attribute": {}, "parameter": {"Diameter": "6,0000 mm", "CuttingEdgeHeight": "1/2 in", "Length": "50 mm",
        "ShankDiameter": "6.0 mm", "Flutes": "3", "Material": "HSS", "Stickout": "28 mm"}})");
}

ForeignTool bit(const json& from) {
    return freeCadBitFromText(from.dump(), "six.fctb", 3, {});
}

TEST(FreeCad, GivesABitWithItsUnits) {
    const ToolAssembly tool = bit(goodBit()).tool;
    EXPECT_EQ(tool.number, 3);
    EXPECT_EQ(tool.type, ToolType::Flat);
    EXPECT_DOUBLE_EQ(tool.diameter_mm, 6);
    EXPECT_DOUBLE_EQ(tool.flute_length_mm, 12.7);
    EXPECT_DOUBLE_EQ(tool.stick_out_mm, 28);
    EXPECT_EQ(tool.flutes, 3);
    EXPECT_EQ(tool.cutter_material, CutterMaterial::Hss);
}

TEST(FreeCad, ReadsTheShapeOfABitWithoutShapeType) {
    json from = goodBit();
    from.erase("shape-type");
    from["shape"] = "drill.fcstd";
    from["parameter"]["TipAngle"] = "119.0 °";
    EXPECT_EQ(bit(from).tool.type, ToolType::Drill);
    EXPECT_DOUBLE_EQ(bit(from).tool.point_angle_deg, 119);
    from["shape"] = "slittingsaw.fcstd";
    EXPECT_FALSE(bit(from).unfit.empty());
}

TEST(FreeCad, NamesPlaceAndExpectationOfWhatIsWrong) {
    json from = goodBit();
    from["parameter"]["Diameter"] = "6 parsec";
    EXPECT_NE(refusalOf([&] {
                  bit(from);
              }).find("six.fctb#/parameter/Diameter: expected a length in mm, cm, m or in"),
              std::string::npos);
    from["parameter"].erase("Diameter");
    EXPECT_NE(refusalOf([&] { bit(from); }).find("expected a tool's diameter"), std::string::npos);
    EXPECT_NE(refusalOf([] { freeCadBitFromText("[]", "six.fctb", 1, {}); }).find("a tool bit"),
              std::string::npos);
}

/// A folder of files that is gone after the test.
class FreeCadFolder : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ =
            fs::temp_directory_path() / (std::string("stepmill_freecad_") +
                                         ::testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    std::string refusal(const std::string& library) const {
        write("lib.fctl", library);
        return refusalOf([&] { readForeign(folder_ / "lib.fctl", CribFormat::FreeCad, {}); });
    }
    fs::path folder_;
};

TEST_F(FreeCadFolder, GivesTheBitsThatALibraryNames) {
    write("six.fctb", goodBit().dump());
    write("lib.fctl", R"({"version": 1, "tools": [{"nr": 7, "path": "six.fctb"}]})");
    for (const fs::path& file : {folder_ / "lib.fctl", folder_}) {
        const ForeignLibrary library = readForeign(file, CribFormat::FreeCad, {});
        ASSERT_EQ(library.tools.size(), 1u);
        EXPECT_EQ(library.tools[0].tool.number, 7);
        EXPECT_EQ(library.tools[0].place, "six.fctb");
    }
}

TEST_F(FreeCadFolder, GivesEveryBitWithoutALibrary) {
    write("b.fctb", goodBit().dump());
    write("a.fctb", goodBit().dump());
    const ForeignLibrary library = readForeign(folder_, CribFormat::FreeCad, {});
    ASSERT_EQ(library.tools.size(), 2u);
    EXPECT_EQ(library.tools[0].place, "a.fctb");
}

TEST_F(FreeCadFolder, RefusesALibraryThatNamesFilesElsewhere) {
    for (const char* path : {"../../etc/passwd", "/etc/passwd", "..", "", "a\\\\b"})
        EXPECT_NE(refusal("{\"tools\": [{\"nr\": 1, \"path\": \"" + std::string(path) + "\"}]}")
                      .find("lib.fctl#/tools/0/path: expected the name of a .fctb file"),
                  std::string::npos)
            << path;
    EXPECT_NE(refusal(R"({"tools": [{"nr": 1, "path": "gone.fctb"}]})").find("a file beside the library"),
              std::string::npos);
}

TEST_F(FreeCadFolder, ReadsBackWhatWasWritten) {
    const ToolLibrary library = readToolLibrary(test::sample("shop_with_taps_tools.json"));
    for (const CribFile& file : freeCadFiles(library, "shop"))
        write(file.name, file.bytes);
    const ForeignLibrary again = readForeign(folder_ / "shop.fctl", CribFormat::FreeCad, {});
    ASSERT_EQ(again.tools.size(), library.tools.size());
    for (std::size_t i = 0; i < library.tools.size(); ++i) {
        const ToolAssembly& was = library.tools[i];
        const ToolAssembly& is = again.tools[i].tool;
        EXPECT_EQ(again.tools[i].unfit, "") << was.id;
        EXPECT_EQ(is.number, was.number);
        // FreeCAD has no face mills.
        EXPECT_EQ(is.type, was.type == ToolType::Face ? ToolType::Flat : was.type) << was.id;
        EXPECT_NEAR(is.diameter_mm, was.diameter_mm, 1e-6) << was.id;
        EXPECT_NEAR(is.flute_length_mm, was.flute_length_mm, 1e-6) << was.id;
        EXPECT_NEAR(is.stick_out_mm, was.stick_out_mm, 1e-6) << was.id;
        EXPECT_EQ(is.flutes, was.flutes) << was.id;
        if (was.type != ToolType::Face) {
            EXPECT_NEAR(is.corner_radius_mm, was.corner_radius_mm, 1e-6) << was.id;
        }
        EXPECT_NEAR(is.point_angle_deg, was.point_angle_deg, 1e-4) << was.id;
        EXPECT_EQ(is.thread ? is.thread->name : "", was.thread ? was.thread->name : "") << was.id;
    }
}

ForeignLibrary table(const std::string& text, const std::string& unit = "inch") {
    ForeignOptions options;
    options.unit = unit;
    return toolTableFromText(text, "tool.tbl", options);
}

TEST(ToolTable, GivesNumberDiameterAndTheTypeInTheRemark) {
    const ForeignLibrary library =
        table("; a remark\n\nT1 P1 D0.25 Z+0.5 ;1/4 end mill\nt2 p7 d.125 ;DRILL 1/8\r\nT3 P3 D.5\n");
    ASSERT_EQ(library.tools.size(), 3u);
    EXPECT_DOUBLE_EQ(library.tools[0].tool.diameter_mm, 6.35);
    EXPECT_EQ(library.tools[0].tool.type, ToolType::Flat);
    EXPECT_EQ(library.tools[1].tool.number, 2);
    EXPECT_EQ(library.tools[1].tool.type, ToolType::Drill);
    EXPECT_NE(library.tools[2].unfit.find("its type is not told"), std::string::npos);
}

TEST(ToolTable, AsksForTheUnit) {
    const Error error = test::thrownBy([] { table("T1 P1 D1 ;drill", ""); });
    EXPECT_EQ(error.code(), ErrorCode::Usage);
    EXPECT_EQ(error.subject(), "--unit");
}

TEST(ToolTable, NamesPlaceAndExpectationOfWhatIsWrong) {
    EXPECT_NE(refusalOf([] {
                  table("T1 P1 D1 ;drill\nT2 Dx ;drill\n");
              }).find("tool.tbl, line 2: expected a letter and a number such as T1, found 'Dx'"),
              std::string::npos);
    EXPECT_NE(refusalOf([] { table("P1 D1 ;drill"); }).find("expected a tool's number T"), std::string::npos);
    EXPECT_NE(refusalOf([] { table("T1.5 D1 ;drill"); }).find("a whole tool number"), std::string::npos);
    EXPECT_NE(refusalOf([] { table("T1 P1 ;end mill"); }).find("line 1: expected a tool's diameter"),
              std::string::npos);
}

class ToolTableOf : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Samples, ToolTableOf,
                         testing::Values("shop_with_forms_tools.json", "shop_for_holes_tools.json"));

TEST_P(ToolTableOf, ReadsBackWhatWasWritten) {
    const ToolLibrary library = readToolLibrary(test::sample(GetParam()));
    const ForeignLibrary again = table(linuxCncTable(library), "mm");
    ASSERT_EQ(again.tools.size(), library.tools.size());
    for (const ForeignTool& tool : again.tools) {
        const auto was = std::find_if(library.tools.begin(), library.tools.end(),
                                      [&](const ToolAssembly& t) { return t.number == tool.tool.number; });
        ASSERT_NE(was, library.tools.end());
        EXPECT_EQ(tool.tool.type, was->type);
        EXPECT_NEAR(tool.tool.diameter_mm, was->diameter_mm, 1e-6);
    }
}

ForeignLibrary csv(const std::string& text, const std::map<std::string, std::string>& columns = {}) {
    ForeignOptions options;
    options.columns = columns;
    return csvFromText(text, "tools.csv", options);
}

TEST(CsvTools, ReadsColumnsByTheirOwnNames) {
    const ForeignLibrary library =
        csv("Nr,Kind,Dia,unit,holder,material,feed,speed_rpm,Shelf\n"
            "5,end mill,12,mm,42x21 46x45,steel,600,1800,A7\n",
            {{"number", "Nr"}, {"type", "Kind"}, {"diameter", "Dia"}});
    const ToolAssembly& tool = library.tools.at(0).tool;
    EXPECT_EQ(tool.number, 5);
    EXPECT_DOUBLE_EQ(tool.diameter_mm, 12);
    ASSERT_EQ(tool.holder.size(), 2u);
    EXPECT_DOUBLE_EQ(tool.holder[1].top_mm, 66);
    EXPECT_EQ(tool.cutting.at(0).material, "steel");
    ASSERT_EQ(library.notes.size(), 1u);
    EXPECT_EQ(library.notes[0], "columns left aside: Shelf");
}

TEST(CsvTools, NamesPlaceAndExpectationOfWhatIsWrong) {
    EXPECT_NE(refusalOf([] { csv("type,diameter\nend mill,5\n"); }).find("--unit: expected mm or inch"),
              std::string::npos);
    EXPECT_NE(refusalOf([] { csv("a,b\n1,2\n"); }).find("tools.csv, line 1: expected columns"),
              std::string::npos);
    EXPECT_NE(refusalOf([] {
                  csv("type,diameter,unit\nend mill,5q,mm\n");
              }).find("line 2, diameter: expected a number of 0 or more, found '5q'"),
              std::string::npos);
    EXPECT_NE(refusalOf([] { csv("type,diameter,unit\nend mill,,mm\n"); }).find("expected a tool's diameter"),
              std::string::npos);
    EXPECT_NE(refusalOf([] {
                  csv("type,diameter\n", {{"width", "b"}});
              }).find("--column: expected one of"),
              std::string::npos);
    EXPECT_NE(refusalOf([] {
                  csv("type,diameter\n", {{"number", "No"}});
              }).find("a column that tools.csv has"),
              std::string::npos);
}

}  // namespace
}  // namespace stepmill
