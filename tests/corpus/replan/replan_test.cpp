// A job planned again after a revision of its part: what is kept, what is told, what is refused.

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <BRepBuilderAPI_Transform.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <nlohmann/json.hpp>

#include "sample_parts.h"
#include "solids.h"
#include "stepmill/core/file.h"
#include "support/page_check.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

/// A plate with a pocket, a slot and holes.
struct Plate {
    double hole_x_mm = 65;
    double pocket_depth_mm = 6;
    double corner_mm = 4;
    bool island = false;
    bool second_pocket = false;
    bool slot = true;
    bool mirrored = false;  ///< left for right
};

std::string stepOf(const Plate& plate) {
    const double floor = 20 - plate.pocket_depth_mm;
    std::vector<TopoDS_Shape> removed{prism(rectangle(8, 8, 44, 36, plate.corner_mm), floor, 21),
                                      cylinder(plate.hole_x_mm, 15, 6, -1, 21), cylinder(12, 50, 5, -1, 21)};
    if (plate.slot) removed.push_back(box(52, 40, 12, 81, 52, 21));
    if (plate.second_pocket) removed.push_back(prism(rectangle(20, 42, 42, 56, 4), 17, 21));
    std::vector<TopoDS_Shape> added;
    TopoDS_Shape solid = assemble(box(0, 0, 0, 80, 60, 20), {}, removed);
    if (plate.island) solid = assemble(solid, {cylinder(26, 22, 8, floor, 20)}, {});
    if (plate.mirrored) {
        gp_Trsf mirror;
        mirror.SetMirror(gp_Ax2(gp_Pnt(40, 0, 0), gp::DX()));
        solid = BRepBuilderAPI_Transform(solid, mirror, Standard_True).Shape();
    }
    return sampleStepText({"plate", "a plate", solid});
}

/// Of each operation its lines in a program, from its comment to the next one's or the end, byte by byte but
/// for block numbers and for where it stands when its tool is changed: there the operation before ended.
std::map<std::string, std::vector<std::string>> linesByOperation(const std::string& program) {
    std::map<std::string, std::vector<std::string>> lines;
    std::string operation;
    bool changing = false;
    std::istringstream text(program);
    for (std::string line; std::getline(text, line);) {
        if (line.rfind("(S", 0) == 0 && line.find(" feature ") != std::string::npos)
            operation = line.substr(1, line.find(' ') - 1);
        const bool numbered = line.size() > 1 && line[0] == 'N';
        if (numbered) line = line.substr(line.find(' ') + 1);
        if (line.size() > 3 && line.substr(line.size() - 3) == " M6") changing = lines.size() > 1;
        const bool left_out = changing && line.rfind("G0 X", 0) == 0;
        if (left_out) changing = false;
        if (!operation.empty() && !left_out) lines[operation].push_back(line);
    }
    return lines;
}

class Replan : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.path() + "/" + name; }

    /// Revisions have the same name: programs name the file.
    std::string part(const std::string& revision, const Plate& plate) const {
        fs::create_directories(path(revision));
        const std::string file = path(revision) + "/plate.step";
        writeFile(file, stepOf(plate));
        return file;
    }

    static ProgramRun stepmill(Words words) {
        words.insert(words.begin(), stepmillBinary());
        return runProgram(words);
    }

    void plan(const Plate& plate = {}, Words more = {}) {
        Words words{"plan", part("a", plate), "-o", path("job")};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramRun run = stepmill(words);
        ASSERT_LE(run.exit_code, 1) << run.err;
    }

    /// Plans the job's part again and returns replan.json. Its programs are proven from the files, and the
    /// claim of the plan holds against the revised part.
    Json again(const std::string& part_file, Words more = {}) {
        Words words{"replan", path("job"), "--part", part_file, "-o", path("new")};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramRun run = stepmill(words);
        EXPECT_LE(run.exit_code, 1) << run.err;
        const ProgramRun proof = stepmill({"verify", path("new"), "--part", part_file});
        EXPECT_LE(proof.exit_code, 1) << proof.out << proof.err;
        Json change = Json::parse(readFile(path("new") + "/replan.json"));
        expectLinesKept(change["operations"]);
        return change;
    }

    /// Operations that are said to be kept stand in both programs with the same lines, others with other
    /// ones.
    void expectLinesKept(const Json& operations) const {
        for (const Json& one : operations) {
            if (one["before"].is_null() || one["after"].is_null()) continue;
            const std::string id = one["id"];
            const std::string program = "/" + one["setup"].get<std::string>() + ".ngc";
            const auto before = linesByOperation(readFile(path("job") + program));
            const auto after = linesByOperation(readFile(path("new") + program));
            ASSERT_EQ(before.count(id), 1U) << id;
            ASSERT_EQ(after.count(id), 1U) << id;
            EXPECT_EQ(before.at(id) == after.at(id), one["change"] == "kept") << id;
        }
    }

    static std::map<std::string, Json> byId(const Json& list) {
        std::map<std::string, Json> found;
        for (const Json& one : list)
            found[one["id"]] = one;
        return found;
    }

    static std::set<std::string> idsOf(const Json& list, const std::string& change) {
        std::set<std::string> ids;
        for (const Json& one : list)
            if (one["change"] == change) ids.insert(one["id"].get<std::string>());
        return ids;
    }

    /// Kept operations come in the order they had.
    static void expectOrderKept(const Json& operations) {
        std::map<std::string, int> last;
        for (const Json& one : operations) {
            if (one["before"].is_null() || one["after"].is_null()) continue;
            int& place = last[one["setup"]];
            EXPECT_LT(place, one["before"]["place"]) << one["id"];
            place = one["before"]["place"];
        }
    }

    /// The new plan is no worse than one made from scratch.
    void expectAsGoodAsAnew(const std::string& part_file) {
        const ProgramRun run = stepmill({"plan", part_file, "-o", path("scratch")});
        ASSERT_LE(run.exit_code, 1) << run.err;
        const Json anew = Json::parse(readFile(path("scratch") + "/plan.json"));
        const Json revised = Json::parse(readFile(path("new") + "/plan.json"));
        EXPECT_LE(revised["totals"]["time_s"].get<double>(), 1.02 * anew["totals"]["time_s"].get<double>());
        EXPECT_EQ(revised["volume_balance"]["planned_mm3"], anew["volume_balance"]["planned_mm3"]);
        EXPECT_EQ(revised["volume_balance"]["residual_mm3"], anew["volume_balance"]["residual_mm3"]);
    }

    TemporaryFolder folder_;
};

TEST_F(Replan, GivesTheSameBytesWhereNothingChanged) {
    plan();
    const Json change = again(part("b", {}));
    for (const Json& program : change["programs"]) {
        EXPECT_EQ(program["change"], "kept");
        EXPECT_TRUE(program["same_bytes"]);
    }
    for (const auto& entry : fs::directory_iterator(path("job"))) {
        const std::string name = entry.path().filename().string();
        if (name == "manifest.json") continue;
        EXPECT_EQ(readFile(entry.path()), readFile(path("new") + "/" + name)) << name;
    }
    EXPECT_EQ(idsOf(change["features"], "kept").size(), change["features"].size());
}

TEST_F(Replan, GivesTheSameProgramsWhereTheFileAloneIsAnother) {
    plan();
    const std::string revised = part("b", {});
    std::string text = stepOf({});
    text.insert(text.find("HEADER;"), "/* Revision B */\n");
    writeFile(revised, text);
    const Json change = again(revised);
    EXPECT_NE(change["part"]["before"]["sha256"], change["part"]["after"]["sha256"]);
    for (const Json& program : change["programs"]) {
        EXPECT_TRUE(program["same_bytes"]);
        const std::string file = "/" + program["setup"].get<std::string>() + ".ngc";
        EXPECT_EQ(readFile(path("job") + file), readFile(path("new") + file)) << file;
    }
    EXPECT_EQ(idsOf(change["features"], "kept").size(), change["features"].size());
}

TEST_F(Replan, PlansAMirroredPart) {
    plan();
    const std::string revised = part("b", {.mirrored = true});
    const Json change = again(revised);
    EXPECT_EQ(idsOf(change["features"], "new").size(), 0U);
    EXPECT_EQ(idsOf(change["features"], "dropped").size(), 0U);
    EXPECT_GE(idsOf(change["features"], "changed").size(), 3U);
    expectOrderKept(change["operations"]);
    expectAsGoodAsAnew(revised);
}

TEST_F(Replan, KeepsAllButAHoleThatMoved) {
    plan();
    const std::string revised = part("b", {.hole_x_mm = 60});
    const Json change = again(revised);
    const std::set<std::string> changed = idsOf(change["features"], "changed");
    EXPECT_EQ(idsOf(change["features"], "new").size(), 0U);
    EXPECT_EQ(idsOf(change["features"], "dropped").size(), 0U);
    ASSERT_GE(changed.size(), 1U);
    // Operations on ground that is the same keep every line.
    const std::map<std::string, Json> features = byId(change["features"]);
    for (const Json& operation : change["operations"]) {
        const Json& feature = features.at(operation["feature"]);
        const bool same = feature["more_mm2"] == 0 && feature["less_mm2"] == 0;
        EXPECT_EQ(operation["change"], same ? "kept" : "changed") << operation["id"];
    }
    expectOrderKept(change["operations"]);
    expectAsGoodAsAnew(revised);
}

TEST_F(Replan, CountsAnIslandAsLessGround) {
    plan();
    const std::string revised = part("b", {.island = true});
    const Json change = again(revised);
    double less_mm2 = 0;
    for (const Json& feature : change["features"])
        less_mm2 += feature["less_mm2"].get<double>();
    EXPECT_NEAR(less_mm2, 16 * M_PI, 0.01);
    expectOrderKept(change["operations"]);
    expectAsGoodAsAnew(revised);
}

TEST_F(Replan, SaysThatAPocketIsDeeper) {
    plan();
    const std::string revised = part("b", {.pocket_depth_mm = 7});
    const Json change = again(revised);
    int deeper = 0;
    for (const Json& feature : change["features"])
        for (const Json& cause : feature["causes"])
            deeper += cause == "depth" ? 1 : 0;
    EXPECT_GE(deeper, 1);
    EXPECT_EQ(idsOf(change["features"], "new").size(), 0U);
    EXPECT_GE(idsOf(change["operations"], "kept").size(), 2U);
    expectOrderKept(change["operations"]);
    expectAsGoodAsAnew(revised);
}

TEST_F(Replan, TakesASmallerCornerRadius) {
    plan();
    const std::string revised = part("b", {.corner_mm = 2});
    const Json change = again(revised);
    EXPECT_EQ(idsOf(change["features"], "new").size(), 0U);
    EXPECT_GE(idsOf(change["features"], "changed").size(), 1U);
    const auto& features = change["features"];
    // Others may change their tools with it, but not their ground.
    EXPECT_EQ(std::count_if(features.begin(), features.end(),
                            [](const Json& one) { return one["more_mm2"] != 0 || one["less_mm2"] != 0; }),
              1);
    expectOrderKept(change["operations"]);
    expectAsGoodAsAnew(revised);
}

TEST_F(Replan, NumbersNewFeaturesAndOperationsAfterTheOld) {
    plan();
    const Json before = Json::parse(readFile(path("job") + "/plan.json"));
    const std::string revised = part("b", {.second_pocket = true});
    const Json change = again(revised);
    const std::set<std::string> fresh = idsOf(change["features"], "new");
    EXPECT_EQ(fresh.size(), 1U);
    const std::map<std::string, Json> old_features = byId(before["features"]);
    const std::map<std::string, Json> old_operations = byId(before["operations"]);
    for (const std::string& id : fresh)
        EXPECT_EQ(old_features.count(id), 0U) << id;
    for (const std::string& id : idsOf(change["operations"], "new"))
        EXPECT_EQ(old_operations.count(id), 0U) << id;
    expectOrderKept(change["operations"]);
    expectAsGoodAsAnew(revised);
}

TEST_F(Replan, NamesWhatIsDroppedAndKeepsTheOtherNumbers) {
    plan();
    const Json change = again(part("b", {.slot = false}));
    EXPECT_EQ(idsOf(change["features"], "dropped").size(), 1U);
    EXPECT_GE(idsOf(change["features"], "kept").size(), 2U);
    expectOrderKept(change["operations"]);
}

TEST_F(Replan, OfAReplanKeepsNamesOnceMore) {
    plan();
    const std::string revised = part("b", {.second_pocket = true, .slot = false});
    again(revised);
    const ProgramRun run = stepmill({"replan", path("new"), "--part", revised, "-o", path("third")});
    ASSERT_LE(run.exit_code, 1) << run.err;
    EXPECT_EQ(readFile(path("new") + "/plan.json"), readFile(path("third") + "/plan.json"));
    for (const Json& program : Json::parse(readFile(path("third") + "/replan.json"))["programs"])
        EXPECT_TRUE(program["same_bytes"]);
}

TEST_F(Replan, KeepsTheWordsOfTheFirstCommandLine) {
    plan({}, {"--setup", "+z", "--stock-margin", "1,2,0", "--objective", "cost", "--scallop", "0",
              "--surrogates", "single", "--material", "steel"});
    const Json change = again(part("b", {}));
    EXPECT_TRUE(change["inputs"].empty()) << change["inputs"];
    EXPECT_EQ(readFile(path("job") + "/plan.json"), readFile(path("new") + "/plan.json"));
}

TEST_F(Replan, FindsThePartBesideTheJobAndTakesAnotherMaterial) {
    plan();
    fs::copy_file(path("a") + "/plate.step", path("plate.step"));
    const ProgramRun run = stepmill({"replan", path("job"), "--material", "steel", "--diff", "--json"});
    ASSERT_LE(run.exit_code, 1) << run.err;
    const Json change = Json::parse(run.out);
    ASSERT_EQ(change["inputs"].size(), 1U);
    EXPECT_EQ(change["inputs"][0]["what"], "material");
    EXPECT_GT(change["totals"]["after"]["time_s"], change["totals"]["before"]["time_s"]);
    EXPECT_FALSE(fs::exists(path("job-replan")));
}

TEST_F(Replan, TellsOperationsByFeaturesAndTimesWhereNoProgramIsWritten) {
    std::string machine = readFile(fs::path(STEPMILL_SOURCE_DIR) / "samples/machine_vmc.json");
    const std::string travel = "[760, 410, 510]";
    const auto place = machine.find(travel);
    ASSERT_NE(place, std::string::npos);
    machine.replace(place, travel.size(), "[40, 40, 510]");
    writeFile(path("short.json"), machine);
    plan({}, {"--machine", path("short.json")});
    ASSERT_FALSE(fs::exists(path("job") + "/S1.ngc"));
    const std::string revised = part("b", {.hole_x_mm = 60});
    const ProgramRun run = stepmill({"replan", path("job"), "--part", revised, "--diff", "--json"});
    ASSERT_LE(run.exit_code, 1) << run.err;
    const Json change = Json::parse(run.out);
    const std::map<std::string, Json> features = byId(change["features"]);
    for (const Json& operation : change["operations"]) {
        const bool same = features.at(operation["feature"])["change"] == "kept" &&
                          operation["before"]["time_s"] == operation["after"]["time_s"];
        EXPECT_EQ(operation["change"], same ? "kept" : "changed") << operation["id"];
    }
    EXPECT_GE(idsOf(change["operations"], "changed").size(), 1U);
    EXPECT_GE(idsOf(change["operations"], "kept").size(), 1U);
    ASSERT_EQ(change["programs"].size(), 1U);
    EXPECT_EQ(change["programs"][0]["change"], "changed");
    EXPECT_EQ(change["programs"][0]["lines_after"], 0);
}

TEST_F(Replan, PrintsTheDifferenceAndWritesNothing) {
    plan();
    const ProgramRun run =
        stepmill({"replan", path("job"), "--part", part("b", {.hole_x_mm = 60}), "--diff"});
    ASSERT_LE(run.exit_code, 1) << run.err;
    EXPECT_NE(run.out.find("part: plate.step instead of plate.step, with other contents"), std::string::npos)
        << run.out;
    EXPECT_NE(run.out.find("mm2 more and"), std::string::npos) << run.out;
    EXPECT_FALSE(fs::exists(path("job-replan")));
}

TEST_F(Replan, ReplacesTheJobItselfWhereAsked) {
    plan();
    const ProgramRun run = stepmill(
        {"replan", path("job"), "--part", part("b", {.hole_x_mm = 60}), "-o", path("job"), "--no-viewer"});
    ASSERT_LE(run.exit_code, 1) << run.err;
    const std::string page = readFile(path("job") + "/replan.html");
    expectSoundPage(page, "replan.html");
    EXPECT_NE(page.find("Planned again: plate.step"), std::string::npos);
    EXPECT_LE(stepmill({"verify", path("job")}).exit_code, 1);
}

TEST_F(Replan, RefusesWhatIsNoJobAndNamesTheFileItLacks) {
    plan();
    const auto refused = [](const Words& words, const std::string& told) {
        const ProgramRun run = stepmill(words);
        EXPECT_EQ(run.exit_code, 2) << run.out;
        EXPECT_NE(run.err.find(told), std::string::npos) << run.err;
    };
    refused({"replan", path("none"), "--diff"}, "plan.json");
    refused({"replan", path("a"), "--diff"}, "plan.json");
    refused({"replan", path("job"), "--diff"}, "--part");
    refused({"replan", path("job"), "--part", path("none.step"), "--diff"}, "none.step");
    refused({"replan", path("job"), "--part", part("b", {}), "--material", "cheese", "--diff"}, "cheese");
    refused({"replan", path("job"), "--part", part("b", {}), "--tools", path("none.json")}, "none.json");
    EXPECT_FALSE(fs::exists(path("job-replan")));
    writeFile(path("job") + "/plan.json", "{}");
    refused({"replan", path("job"), "--part", part("b", {}), "--diff"}, "plan.json");
}

}  // namespace
}  // namespace stepmill::test
