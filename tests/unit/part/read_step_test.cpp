// readStep on files made from a sample part by editing its text.

#include <filesystem>
#include <regex>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/part/part.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;

// shoulder_block.step: 80 x 60 x 30 mm less 25 x 60 x 8 and 25 x 60 x 18.
constexpr double kBlockVolume_mm3 = 105000;

template <class Value, class Given>
ReadOptions with(Value ReadOptions::*member, Given value) {
    ReadOptions options;
    options.*member = value;
    return options;
}

class ReadStepTest : public ::testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "stepmill-read-XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
        text_ = readFile(fs::path(STEPMILL_SOURCE_DIR) / "step_parts" / "shoulder_block.step");
    }
    void TearDown() override { fs::remove_all(folder_); }

    /// Replaces the first `from` in the text; a test whose edit does nothing fails.
    void edit(const std::string& from, const std::string& to) {
        const std::size_t at = text_.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        text_.replace(at, from.size(), to);
    }

    std::vector<Part> read(const ReadOptions& options = {}) {
        writeFile(folder_ / "edited.step", text_);
        return readStep(folder_ / "edited.step", options);
    }

    std::optional<ErrorCode> refusal(const ReadOptions& options = {}) {
        try {
            read(options);
        } catch (const Error& error) {
            return error.code();
        }
        return std::nullopt;
    }

    static bool hasRemark(const Part& part, const std::string& text) {
        return std::any_of(part.remarks.begin(), part.remarks.end(),
                           [&](const Remark& remark) { return remark.text.find(text) != std::string::npos; });
    }

    static bool isDoubtful(const Part& part) {
        return std::any_of(part.remarks.begin(), part.remarks.end(),
                           [](const Remark& remark) { return remark.code == kInputDoubt; });
    }

    fs::path folder_;
    std::string text_;
};

TEST_F(ReadStepTest, ReadsUnitNameSchemaAndHash) {
    const std::vector<Part> parts = read();
    ASSERT_EQ(parts.size(), 1U);
    const Part& part = parts[0];
    EXPECT_EQ(part.file, "edited.step");
    EXPECT_EQ(part.sha256, sha256(text_));
    EXPECT_EQ(part.name, "shoulder_block");
    EXPECT_EQ(part.schema, "AP214");
    EXPECT_EQ(part.unit_in_file, "mm");
    EXPECT_EQ(part.count, 1);
    EXPECT_NEAR(part.volume_mm3, kBlockVolume_mm3, 1e-4);
    EXPECT_TRUE(part.remarks.empty());
}

TEST_F(ReadStepTest, TakesTheFilesNameWhereTheProductsIsMadeUp) {
    for (const char* name : {"Open CASCADE STEP translator 7.6 1", "=>[0:1:1:2]", ""}) {
        text_ = std::regex_replace(text_, std::regex("PRODUCT\\('[^']*','[^']*'"),
                                   fmt::format("PRODUCT('{0}','{0}'", name));
        EXPECT_EQ(read().at(0).name, "edited") << name;
    }
}

TEST_F(ReadStepTest, KeepsTheNamesOfFaces) {
    const Part part = read().at(0);
    std::map<std::string, int> names;
    for (const PartFace& face : part.faces)
        ++names[face.step_name];
    EXPECT_EQ(names["top"], 1);
    EXPECT_EQ(names["bottom"], 1);
    EXPECT_EQ(names["level z 22"], 1);
    EXPECT_EQ(names["level z 12"], 1);
    EXPECT_EQ(names.count(""), 0U);
}

TEST_F(ReadStepTest, ConvertsOtherUnitsToMillimetres) {
    edit("SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT(.CENTI.,.METRE.)");
    const Part part = read().at(0);
    EXPECT_EQ(part.unit_in_file, "cm");
    EXPECT_NEAR(part.bbox_mm.sizes().x(), 800, 1e-6);
    EXPECT_NEAR(part.volume_mm3, kBlockVolume_mm3 * 1e3, 1);
}

TEST_F(ReadStepTest, AUnitOptionOverridesTheFile) {
    const Part part = read(with(&ReadOptions::unit, "inch")).at(0);
    EXPECT_NEAR(part.bbox_mm.sizes().x(), 80 * 25.4, 1e-6);
    EXPECT_TRUE(hasRemark(part, "overridden"));
    EXPECT_EQ(part.faces.at(0).step_name.empty(), false);
    EXPECT_EQ(refusal(with(&ReadOptions::unit, "furlong")), ErrorCode::Usage);
}

TEST_F(ReadStepTest, AHugePartInMetresIsTakenWithADoubt) {
    edit("SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT($,.METRE.)");
    const Part part = read().at(0);
    EXPECT_EQ(part.unit_in_file, "m");
    EXPECT_TRUE(hasRemark(part, "--unit mm"));
    EXPECT_EQ(refusal(with(&ReadOptions::largest_mm, 50000)), ErrorCode::ImplausibleSize);
}

TEST_F(ReadStepTest, RefusesAPartTooSmallToMill) {
    EXPECT_EQ(refusal(with(&ReadOptions::smallest_mm, 31)), ErrorCode::ImplausibleSize);
    EXPECT_EQ(refusal(with(&ReadOptions::smallest_mm, 29)), std::nullopt);
}

TEST_F(ReadStepTest, RefusesASolidNumberTheFileDoesNotHave) {
    EXPECT_EQ(refusal(with(&ReadOptions::solid, 0)), std::nullopt);
    EXPECT_EQ(refusal(with(&ReadOptions::solid, 1)), ErrorCode::Usage);
    EXPECT_EQ(refusal(with(&ReadOptions::solid, -2)), ErrorCode::Usage);
}

TEST_F(ReadStepTest, AShellWithoutSolidIsNoSolid) {
    edit("ADVANCED_BREP_SHAPE_REPRESENTATION", "MANIFOLD_SURFACE_SHAPE_REPRESENTATION");
    const std::size_t at = text_.find("MANIFOLD_SOLID_BREP('',#");
    ASSERT_NE(at, std::string::npos);
    const std::size_t end = text_.find(')', at);
    const std::string shell = text_.substr(at + 23, end - at - 23);
    text_.replace(at, end - at + 1, "SHELL_BASED_SURFACE_MODEL('',(" + shell + "))");
    EXPECT_EQ(refusal(), ErrorCode::NoSolid);
}

TEST_F(ReadStepTest, ASolidWithAFaceLeftOutIsAnOpenShell) {
    const std::size_t at = text_.find("CLOSED_SHELL('',(#");
    ASSERT_NE(at, std::string::npos);
    const std::size_t first = text_.find('#', at);
    text_.erase(first, text_.find(',', first) - first + 1);
    EXPECT_EQ(refusal(), ErrorCode::OpenShell);
}

TEST_F(ReadStepTest, AVertexMovedOffItsEdgesIsRefused) {
    const std::size_t vertex = text_.find("VERTEX_POINT('',#");
    ASSERT_NE(vertex, std::string::npos);
    const std::string id = text_.substr(vertex + 16, text_.find(')', vertex) - vertex - 16);
    const std::size_t point = text_.find("\n" + id + " = CARTESIAN_POINT");
    ASSERT_NE(point, std::string::npos);
    const std::size_t numbers = text_.find(",(", point);
    const std::size_t end = text_.find(')', numbers);
    text_.replace(numbers, end - numbers, ",(1.,2.,3.");
    EXPECT_EQ(refusal(), ErrorCode::InvalidSolid);
}

TEST_F(ReadStepTest, AccountsForEveryFaceOfTheFile) {
    const Part part = read().at(0);
    ASSERT_NE(part.import, nullptr);
    EXPECT_EQ(part.import->shells_in_file, 1);
    EXPECT_EQ(part.import->faces_in_file, 10);
    EXPECT_EQ(part.import->built.faces, 10);
    EXPECT_EQ(part.import->healed.faces, 10);
    EXPECT_EQ(part.import->edges_in_file, part.import->healed.edges);
    EXPECT_EQ(part.import->kinds.at("ADVANCED_FACE"), 10);
    EXPECT_NEAR(part.import->built.volume_mm3, kBlockVolume_mm3, 1e-4);
    EXPECT_NE(importText(part).find("1 shells, 10 faces, 24 edges"), std::string::npos) << importText(part);
}

TEST_F(ReadStepTest, AVectorOfNoLengthIsDamageAndNoOtherPart) {
    const std::size_t vector = text_.find("VECTOR('',#");
    ASSERT_NE(vector, std::string::npos);
    const std::size_t magnitude = text_.find(",1.)", vector);
    text_.replace(magnitude, 4, ",0.)");
    EXPECT_EQ(refusal(), ErrorCode::StepDamaged);
}

TEST_F(ReadStepTest, AFaceTurnedOverIsADoubtOrRefused) {
    std::size_t face = text_.find("ADVANCED_FACE(");
    for (int faces = 0; face != std::string::npos; ++faces) {
        const std::string whole = text_;
        const std::size_t flag = text_.find(");", face) - 3;
        text_.replace(flag, 3, text_.substr(flag, 3) == ".T." ? ".F." : ".T.");
        try {
            EXPECT_TRUE(isDoubtful(read().at(0))) << "face " << faces;
        } catch (const Error& error) {
            EXPECT_TRUE(isInputError(error.code()));
        }
        text_ = whole;
        face = text_.find("ADVANCED_FACE(", face + 1);
    }
}

TEST_F(ReadStepTest, AByteOrderMarkIsNoObstacle) {
    text_ = "\xEF\xBB\xBF" + text_;
    EXPECT_NEAR(read().at(0).volume_mm3, kBlockVolume_mm3, 1e-4);
}

TEST_F(ReadStepTest, ATornLoopIsDamage) {
    const std::size_t edge = text_.find("ORIENTED_EDGE('',*,*,#");
    const std::size_t flag = text_.find(");", edge) - 3;
    text_.replace(flag, 3, text_.substr(flag, 3) == ".T." ? ".F." : ".T.");
    EXPECT_EQ(refusal(), ErrorCode::StepDamaged);
}

TEST_F(ReadStepTest, AShapeEntityWithAValueOfTheWrongKindIsDamage) {
    edit("= VECTOR('',#", "= DIRECTION('',#");
    EXPECT_EQ(refusal(), ErrorCode::StepDamaged);
}

TEST_F(ReadStepTest, AShapeEntityWithAValueLeftOutIsDamage) {
    edit("VERTEX_POINT('',#", "VERTEX_POINT(#");
    EXPECT_EQ(refusal(), ErrorCode::StepDamaged);
}

/// Whoever places something by it makes another part than the reader does.
TEST_F(ReadStepTest, APlacementThatScalesOrMirrorsIsRefused) {
    const std::string whole = text_;
    const auto with = [&](const std::string& axes_and_scale) {
        text_ = whole;
        text_.insert(text_.rfind("ENDSEC;"),
                     "#99990=CARTESIAN_POINT('',(0.,0.,0.));\n#99991=DIRECTION('',(-1.,0.,0.));\n"
                     "#99992=DIRECTION('',(0.,1.,0.));\n#99993=DIRECTION('',(0.,0.,1.));\n"
                     "#99994=CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',$,$,#99990,1.,$);\n");
        edit("$,$,#99990,1.,$", axes_and_scale);
        return refusal();
    };
    EXPECT_EQ(with("$,$,#99990,1.,$"), std::nullopt);
    EXPECT_EQ(with("$,$,#99990,2.,$"), ErrorCode::StepDamaged);
    EXPECT_EQ(with("#99991,#99992,#99990,1.,#99993"), ErrorCode::StepDamaged);
    EXPECT_EQ(with("#99992,#99991,#99990,1.,#99993"), std::nullopt);  // a quarter turn
}

TEST_F(ReadStepTest, AMissingFileIsUnreadable) {
    try {
        readStep(folder_ / "missing.step");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::FileUnreadable);
    }
}

TEST_F(ReadStepTest, ReadingTwiceGivesTheSameParts) {
    const Part first = read().at(0);
    const Part second = read().at(0);
    EXPECT_EQ(first.volume_mm3, second.volume_mm3);
    ASSERT_EQ(first.faces.size(), second.faces.size());
    for (std::size_t i = 0; i < first.faces.size(); ++i)
        EXPECT_EQ(first.faces[i].step_name, second.faces[i].step_name);
}

TEST_F(ReadStepTest, MeasuresTheShapeHoweverTheParametersRun) {
    text_ = readFile(fs::path(STEPMILL_SOURCE_DIR) / "step_parts" / "die_cavity.step");
    const double volume_mm3 = read().front().volume_mm3;
    // A control point moves along its own curve: the edge stays where it was, to 0.01 mm.
    edit("(21.541072862007,28.003724413505,25.)", "(21.541072862007,29.003724413505,25.)");
    EXPECT_NEAR(read().front().volume_mm3, volume_mm3, 1e-5 * volume_mm3);
}

}  // namespace
}  // namespace stepmill
