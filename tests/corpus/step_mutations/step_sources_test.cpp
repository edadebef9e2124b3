// Single-token damage to STEP files that are no part: a fixture's solid, a drawing's curves. Every edit ends
// in a plan, or in a refusal that names the file; never in a bug, and nothing is half-written.
//
// STEPMILL_SOURCE_MUTATIONS sets the number of edits of each (default 40).

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <BRep_Builder.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <gp_Circ.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Compound.hxx>

#include "mutate_step.h"
#include "stepmill/core/file.h"
#include "stepmill/core/supervise.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;

constexpr int kDefaultSourceEdits = 40;
constexpr double kWriteLimit_s = 60;
constexpr const char* kTimeout = "60";

const fs::path kPart = fs::path(STEPMILL_SOURCE_DIR) / "step_parts" / "rounded_pocket.step";

int numberOfEdits() {
    const char* text = std::getenv("STEPMILL_SOURCE_MUTATIONS");
    return text ? std::atoi(text) : kDefaultSourceEdits;
}

/// A plate of 60 x 40 mm and a round pocket in it, each a sketch of its name; the writer numbers them.
void writeCurves(const fs::path& file) {
    STEPControl_Writer writer;
    const auto add = [&](const char* name, const TopoDS_Shape& shape) {
        TopoDS_Compound sketch;
        BRep_Builder builder;
        builder.MakeCompound(sketch);
        builder.Add(sketch, shape);
        Interface_Static::SetCVal("write.step.product.name", name);
        writer.Transfer(sketch, STEPControl_AsIs);
    };
    BRepBuilderAPI_MakePolygon outline(gp_Pnt(0, 0, 0), gp_Pnt(60, 0, 0), gp_Pnt(60, 40, 0), gp_Pnt(0, 40, 0),
                                       true);
    add("OUT", outline.Wire());
    add("P", BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(30, 20, 0), gp::DZ()), 9)).Edge());
    writer.Write(file.c_str());
}

class StepSources : public testing::Test {
  protected:
    fs::path path(const std::string& name) const { return fs::path(folder_.path()) / name; }

    /// Runs the program on every edit of the text, put in the place of `file`.
    void expectSound(const std::string& text, const fs::path& file, const std::vector<std::string>& words,
                     const fs::path& out) const {
        const std::vector<EditSpot> spots = editSpots(text);
        int refused = 0;
        for (int seed = 1; seed <= numberOfEdits(); ++seed) {
            const EditedStep edited =
                editStep(text, spots, static_cast<EditKind>(seed % 3), static_cast<std::uint64_t>(seed));
            SCOPED_TRACE(edited.edit);
            writeFile(file, edited.text);
            fs::remove_all(out);
            const ProgramRun run = runProgram(words);
            EXPECT_GE(run.exit_code, 0) << "died of a signal";
            EXPECT_LE(run.exit_code, 2) << run.err;
            if (run.exit_code != 2) continue;
            ++refused;
            EXPECT_NE(run.err.find(file.filename().string()), std::string::npos) << run.err;
            EXPECT_FALSE(fs::exists(out)) << "half-written";
        }
        fmt::print("{} edits, {} refused\n", numberOfEdits(), refused);
    }

  private:
    TemporaryFolder folder_;
};

TEST_F(StepSources, OfFixturesAreTakenOrRefusedByName) {
    writeFile(path("clamps.json"),
              R"({"format": 1, "unit": "mm", "setups": [{"setup": "S1", "fixtures": [], "solids": [)"
              R"({"name": "clamp", "file": "clamp.step", "up": "+z", "turn": 0, "at": [200, 0, -10]}]}]})");
    expectSound(readFile(fs::path(STEPMILL_SOURCE_DIR) / "step_parts" / "shoulder_block.step"),
                path("clamp.step"),
                {stepmillBinary(), "plan", kPart.string(), "-o", path("job").string(), "--fixtures",
                 path("clamps.json").string(), "--timeout", kTimeout},
                path("job"));
}

TEST_F(StepSources, OfCurvesAreTakenOrRefusedByName) {
    const fs::path file = path("curves.step");
    // In a child: a process that has run OCCT must not fork.
    const Supervised written = runSupervised(
        [&](StageBoard&) {
            writeCurves(file);
            return 0;
        },
        kWriteLimit_s);
    ASSERT_EQ(written.exit_code, 0);
    const std::vector<std::string> words{
        stepmillBinary(), "plan",  file.string(), "--outline",          "OUT 1",     "--thickness", "10",
        "--depth",        "P 2=4", "-o",          path("job").string(), "--timeout", kTimeout};
    const std::string text = readFile(file);
    const ProgramRun whole = runProgram(words);
    ASSERT_LE(whole.exit_code, 1) << whole.err;
    expectSound(text, file, words, path("job"));
}

}  // namespace
}  // namespace stepmill::test
