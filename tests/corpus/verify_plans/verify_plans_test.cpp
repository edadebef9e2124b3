// Every plan proves itself from its files, and a program that is spoilt does not.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "corpus/verify_plans/spoilt_program.h"
#include "support/expected_outcomes.h"
#include "support/told.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

void expectProven(const std::string& part, const Words& options) {
    const PlannedPart planned = plannedPart(part, options);
    ASSERT_LE(planned.run.exit_code, 1) << planned.run.err;
    const ProgramRun run = verify(planned.folder, {"--json", "--part", part});
    ASSERT_EQ(run.exit_code, planned.run.exit_code) << run.err << run.out;
    const Json proof = Json::parse(run.out);
    fmt::print("{} operations proven, {:.2f} s (plan {:.2f} s)\n", proof.at("operations").size(), run.cpu_s,
               planned.run.cpu_s);
    EXPECT_TRUE(proof.at("proven").get<bool>());
    EXPECT_TRUE(proof.at("failures").empty());
}

class VerifyPlan : public testing::TestWithParam<ExpectedOutcome> {
  protected:
    void SetUp() override { STEPMILL_NEEDS_PART(GetParam()); }
};

TEST_P(VerifyPlan, IsProven) {
    expectProven(GetParam().path, {});
}

using VerifyFinishing = VerifyPlan;

TEST_P(VerifyFinishing, IsProven) {
    expectProven(GetParam().path, kWithAllowance);
}

using VerifyDialects = VerifyPlan;

TEST_P(VerifyDialects, AreProven) {
    const PlannedPart planned = plannedPart(GetParam().path);
    ASSERT_LE(planned.run.exit_code, 1) << planned.run.err;
    for (const Words& how : {Words{"fanuc"}, Words{"grbl"}, Words{"fanuc", "--units", "inch"},
                             Words{"grbl", "--per", "tool"}, Words{"linuxcnc", "--units", "inch"}}) {
        SCOPED_TRACE(fmt::format("{}", fmt::join(how, " ")));
        const TemporaryFolder folder;
        const fs::path posted = fs::path(folder.path()) / "posted";
        Words words{stepmillBinary(), "post", planned.folder, "-o", posted, "--dialect"};
        words.insert(words.end(), how.begin(), how.end());
        const ProgramRun post = runProgram(words);
        EXPECT_EQ(post.exit_code, 0) << post.err;
        fs::copy_file(planned.folder / "plan.json", posted / "plan.json");
        EXPECT_EQ(verify(posted, {"--dialect", how.front()}).exit_code, planned.run.exit_code);
    }
}

const auto kPartName = [](const auto& row) { return testName(row.param); };
const std::vector<ExpectedOutcome> kSampleParts = expectedPlans({"step_parts"});
const std::vector<ExpectedOutcome> kRealParts = expectedPlans({"machined", "nist"});

INSTANTIATE_TEST_SUITE_P(SampleParts, VerifyPlan, testing::ValuesIn(kSampleParts), kPartName);
INSTANTIATE_TEST_SUITE_P(RealParts, VerifyPlan, testing::ValuesIn(kRealParts), kPartName);
INSTANTIATE_TEST_SUITE_P(Slow, VerifyPlan, testing::ValuesIn(slowPlans()), kPartName);
INSTANTIATE_TEST_SUITE_P(SampleParts, VerifyFinishing, testing::ValuesIn(withSlowProofs(kSampleParts, false)),
                         kPartName);
INSTANTIATE_TEST_SUITE_P(Slow, VerifyFinishing,
                         testing::ValuesIn(withSlowProofs(expectedOf("step_parts"), true)), kPartName);
INSTANTIATE_TEST_SUITE_P(RealParts, VerifyFinishing, testing::ValuesIn(kRealParts), kPartName);
INSTANTIATE_TEST_SUITE_P(SampleParts, VerifyDialects, testing::ValuesIn(withSlowProofs(kSampleParts, false)),
                         kPartName);
INSTANTIATE_TEST_SUITE_P(Slow, VerifyDialects,
                         testing::ValuesIn(withSlowProofs(expectedOf("step_parts"), true)), kPartName);

TEST(VerifyPlans, MovesAsShortAsALastDecimalAreNoPlunges) {
    // Walls moved in by so little have edges that short, which ramps run along.
    expectProven(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/die_cavity.step",
                 {"--finish-walls", "0.02"});
}

TEST_F(SpoiltProgram, IsProvenAsItWas) {
    EXPECT_EQ(verifySpoilt().exit_code, 0);
}

TEST_F(SpoiltProgram, ShowsAHundredthOfAMillimetreIntoTheWall) {
    double x = 0;
    const std::size_t line = wallLine(x, lines_.size());
    replace(line, fmt::format("X{:.4f}", x), fmt::format("X{:.4f}", x - 0.01));
    expectFails(line, "cuts into what must stay by 0.0");
}

TEST_F(SpoiltProgram, ShowsAnArcAboutAnotherCentre) {
    // Round the island, about a point as far off on the other side of the arc's ends.
    const std::size_t line = find(" J-", find(" G2 ", find("(S1.O2 ")));
    replace(line, " J-", " J");
    expectFails(line, "cuts into what must stay");
}

TEST_F(SpoiltProgram, ShowsARetractLeftOut) {
    // The first retract that is followed by a rapid across.
    std::size_t line = find(" G0 Z", find(" G1 "));
    while (lines_[line + 1].find(" G0 X") == std::string::npos)
        line = find(" G0 Z", line + 1);
    lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(line));
    // The rapid across now runs at the depth of the cut, into the wall.
    expectFails(line, "cuts into what must stay by ");
}

TEST_F(SpoiltProgram, ShowsAWayHomeLeftOut) {
    const std::vector<std::string> whole = lines_;
    const std::size_t change = find(" M6", find("(S1.O2 "));
    for (const std::size_t before : {change, lines_.size()}) {
        lines_ = whole;
        std::size_t home = before - 1;
        while (lines_[home].find("G53") == std::string::npos)
            --home;
        lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(home));
        std::size_t last = home - 1;
        while (lines_[last].find(" G0 Z") == std::string::npos)
            --last;
        expectFails(last, "not taken to the top of its travel");
    }
}

TEST_F(SpoiltProgram, ShowsAFeedThatIsTooHigh) {
    const std::size_t line = find(" G1 X");
    lines_[line] = lines_[line].substr(0, lines_[line].find(" F")) + " F9000.00";
    expectFails(line, "feeds at 9000.0 mm/min");
}

TEST_F(SpoiltProgram, ShowsARapidIntoMaterial) {
    const std::size_t line = find(" G0 Z2.5000");
    replace(line, "Z2.5000", "Z-3.0000");
    expectFails(line, "a rapid meets material");
}

TEST_F(SpoiltProgram, ShowsACutBelowTheFloor) {
    const std::size_t line = find("Z-12.0000", find(" G1 "));
    replace(line, "Z-12.0000", "Z-12.0100");
    expectFails(line, "the floor is at Z-12.0000");
}

TEST_F(SpoiltProgram, ShowsAPassLeftOut) {
    // The last operation's last cuts: what they clear, nothing else does.
    const std::size_t comment = find("(S1.O2 ");
    std::size_t last = lines_.size() - 1;
    while (lines_[last].find(" G1 ") == std::string::npos)
        --last;
    // The last one leaves the wall.
    lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(last - 1),
                 lines_.begin() + static_cast<std::ptrdiff_t>(last + 1));
    expectFails(comment, "that the plan does not name");
}

TEST_F(SpoiltProgram, ShowsAWrongSpeedAndAWrongTool) {
    const std::size_t comment = find("(S1.O2 ");
    const std::size_t speed = find(" M3", comment);
    const std::string spindle = lines_[speed];
    lines_[speed] = "S30000 M3";
    expectFails(find(" G1 ", comment), "runs at S30000");
    lines_[speed] = spindle;
    const std::size_t change = find(" M6", comment);
    lines_[change] = "T9 M6";
    expectFails(find("M8", comment) + 1, "runs with T9");
}

TEST_F(SpoiltProgram, ShowsAnOperationLeftOut) {
    const std::size_t first = find("(S1.O2 ");
    lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(first),
                 lines_.begin() + static_cast<std::ptrdiff_t>(find("M30") - 3));
    const ProgramRun run = verifySpoilt();
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(test::tells(run.out, {"S1.ngc", "S1.O2", "not have"}));
}

TEST_F(SpoiltProgram, IsRefusedWhereNoControllerOfOursWouldReadIt) {
    const std::size_t line = find(" G1 X");
    const std::string good = lines_[line];
    lines_[line] = "G1 X#5 F100";
    expectRefused(line, "expected a number after X");
    lines_[line] = "G92 X0";
    expectRefused(line, "G92 is not read");
    lines_[line] = good;
    fs::remove(dir_ / "S1.ngc");
    const ProgramRun run = verify(dir_);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("S1.ngc"), std::string::npos) << run.err;
}

TEST_F(SpoiltProgram, IsRefusedWithAPlanThatWasEdited) {
    std::ifstream file(dir_ / "plan.json");
    Json plan = Json::parse(file);
    plan["operations"][0]["tool"] = "EM99";
    std::ofstream(dir_ / "plan.json") << plan;
    const ProgramRun run = verify(dir_);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("plan.json#/operations/0/tool"), std::string::npos) << run.err;
}

TEST_F(SpoiltProgram, ShowsAHolderThatWouldTouch) {
    // The same program with the tool set 8 mm out of its holder, in a pocket 12 mm deep.
    std::ifstream file(dir_ / "plan.json");
    Json plan = Json::parse(file);
    Json& tool = plan["tools"][0];
    ASSERT_FALSE(tool["holder"].empty());
    tool["holder"][0]["bottom_mm"] = tool["stick_out_mm"] = 8;
    std::ofstream(dir_ / "plan.json") << plan;
    const ProgramRun run = verify(dir_);
    EXPECT_EQ(run.exit_code, 2) << run.out;
    EXPECT_TRUE(test::tells(run.out, {"7 mm over the tip", "with 1 mm of clearance", "into material"}));
}

TEST_F(SpoiltProgram, ShowsAClampInTheWay) {
    std::ifstream file(dir_ / "plan.json");
    Json plan = Json::parse(file);
    Json clamp = {{"name", "clamp"}, {"bottom_z_mm", 0}, {"top_z_mm", 20}};
    clamp["section"] = plan["features"][0]["bands"][0]["target"];
    plan["setups"][0]["fixtures"].push_back(clamp);
    std::ofstream(dir_ / "plan.json") << plan;
    const ProgramRun run = verify(dir_);
    EXPECT_EQ(run.exit_code, 2) << run.out;
    EXPECT_NE(run.out.find("cuts into what must stay"), std::string::npos) << run.out;
}

TEST_F(SpoiltProgram, ShowsEverySettingThatIsMissingOrAnother) {
    const std::vector<std::string> whole = lines_;
    const std::size_t change = find(" M6", find("(S1.O2 "));
    const std::size_t cut = find(" G1 X", change);
    const std::size_t up = find(" G0 Z5", cut);
    const std::string tool = lines_[change].substr(0, lines_[change].find(' '));
    struct Slip {
        std::size_t line;
        std::string by;  ///< in its place, or before it when it ends with a line end
    };
    const std::size_t safe = find("G21 G17");
    const std::size_t modes = find("G17 G40", change);
    for (const Slip& slip : std::vector<Slip>{{change, tool},
                                              {find("G43", change), ""},
                                              {find("G43", change), "G43 H99"},
                                              {find("G43", change) + 1, "G49\n"},
                                              {safe, "G17 G40 G49 G80 G90 G94 G54"},
                                              {safe, "G21 G17 G49 G80 G90 G94 G54"},
                                              {modes, "G17 G40 G80 G90 G94 G55"},
                                              {modes, "G17 G40 G80 G91 G94 G54"},
                                              {modes, "G18 G40 G80 G90 G94 G54"},
                                              {modes, "G17 G40 G80 G90 G93 G54"},
                                              {find("G64"), "G64 P0"},
                                              {find("G64"), "G64"},
                                              {find("G64"), "G64 P0.05"},
                                              {find(" G0 Z", change), "G0 Z-50\n"},
                                              {cut + 1, "M6\n"},
                                              {cut + 1, "G28 X0 Y0 Z-12\n"},
                                              {cut + 1, "G4 P0 X90 Y70\n"},
                                              {cut + 1, "S500\n"},
                                              {cut + 1, "M5\n"},
                                              {cut + 1, "M9\n"},
                                              {cut + 1, "M4\n"},
                                              {cut + 1, "%\n"},
                                              {cut + 1, "G55\n"},
                                              {cut + 1, "M30\n"},
                                              {up + 1, "G0 X2000\n"},
                                              {up + 1, "T99\n"}}) {
        lines_ = whole;
        if (slip.by.ends_with('\n')) {
            lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(slip.line),
                          slip.by.substr(0, slip.by.size() - 1));
        } else {
            lines_[slip.line] = slip.by;
        }
        const ProgramRun run = verifySpoilt();
        EXPECT_TRUE(run.exit_code == 2 || run.exit_code == 3) << slip.line + 1 << ": " << slip.by;
        EXPECT_NE((run.out + run.err).find("S1.ngc, line "), std::string::npos) << run.out << run.err;
    }
}

TEST_F(SpoiltProgram, TakesHarmlessEdits) {
    const std::vector<std::string> whole = lines_;
    // G94 asks for a word F of the next feed.
    std::size_t up = find(" G0 Z5", find(" G1 X"));
    while (lines_[find(" G1 ", up)].find(" F") == std::string::npos)
        up = find(" G0 Z5", up + 1);
    for (const char* line : {"G53 G0 Z0", "G28 Z40", "M1", "M0", "G4 P0.5", "G0 Z40", "(a comment)",
                             "; G0 Z-50", "N1", "G64 P0.01", "g90 g17", "G94", "G61", "G0Z40.0", ""}) {
        lines_ = whole;
        lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(up) + 1, line);
        const ProgramRun run = verifySpoilt();
        EXPECT_EQ(run.exit_code, 0) << line << ": " << run.out << run.err;
    }
}

/// The same with finishing passes.
class SpoiltFinishing : public SpoiltProgram {
  protected:
    Words options() const override {
        Words words = kWithTwoTools;
        words.insert(words.end(), kWithAllowance.begin(), kWithAllowance.end());
        return words;
    }
};

TEST_F(SpoiltFinishing, IsProvenAsItWas) {
    EXPECT_EQ(verifySpoilt().exit_code, 0);
}

TEST_F(SpoiltFinishing, ShowsRoughingThatCutsIntoTheAllowance) {
    double x = 0;
    const std::size_t line = wallLine(x, find("(S1.O2 "));
    replace(line, fmt::format("X{:.4f}", x), fmt::format("X{:.4f}", x - 0.1));
    expectFails(line, "cuts into the finishing allowance or what must stay by 0.09");
}

TEST_F(SpoiltFinishing, ShowsAPassAlongTheWallsThatIsNotRun) {
    const std::size_t comment = find(" finish walls");
    for (std::size_t i = lines_.size() - 1; i > comment; --i) {
        const bool fed = lines_[i].find(" X") != std::string::npos;
        if (fed && lines_[i].find(" G0 ") == std::string::npos)
            lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    expectFails(comment, "that the plan does not name");
}

TEST_F(SpoiltFinishing, ShowsAPlanThatForgetsTheFloor) {
    // Neither plan nor program has a finishing operation: roughing's allowance would stay.
    std::ifstream file(dir_ / "plan.json");
    Json plan = Json::parse(file);
    const std::set<std::string> finish = [&] {
        std::set<std::string> ids;
        for (const Json& operation : plan["operations"])
            if (operation["role"] == "finish") ids.insert(operation["id"]);
        return ids;
    }();
    ASSERT_FALSE(finish.empty());
    const auto is_finish = [&](const Json& id) { return finish.count(id.get<std::string>()) > 0; };
    Json kept = Json::array();
    for (const Json& operation : plan["operations"])
        if (!is_finish(operation["id"])) kept.push_back(operation);
    plan["operations"] = kept;
    Json ids = Json::array();
    for (const Json& id : plan["setups"][0]["operations"])
        if (!is_finish(id)) ids.push_back(id);
    plan["setups"][0]["operations"] = ids;
    std::ofstream(dir_ / "plan.json") << plan;
    // In the program their comments and motions go; changes of the tool for what follows stay.
    bool finishing = false;
    std::erase_if(lines_, [&](const std::string& line) {
        const std::size_t comment = line.find("(S1.O");
        if (comment != std::string::npos)
            finishing = finish.count(line.substr(comment + 1, line.find(' ', comment) - comment - 1)) > 0;
        const bool moves = line.find(" X") != std::string::npos || line.find(" Y") != std::string::npos ||
                           line.find(" Z") != std::string::npos;
        return finishing && (moves || comment != std::string::npos);
    });
    const ProgramRun run = verifySpoilt();
    EXPECT_NE(run.exit_code, 0) << run.out;
    EXPECT_NE((run.out + run.err).find("that the plan does not name"), std::string::npos)
        << run.out << run.err;
}

TEST_F(SpoiltFinishing, ShowsAFloorThatIsNotFinished) {
    const std::size_t comment = find("(S1.O2 ");
    const std::size_t end = find("(S1.O3 ");
    for (std::size_t i = comment; i < end; ++i)
        if (const std::size_t z = lines_[i].find("Z-12.0000"); z != std::string::npos)
            lines_[i].replace(z, 9, "Z-11.9000");
    const ProgramRun run = verifySpoilt();
    EXPECT_EQ(run.exit_code, 2) << run.out;
    EXPECT_NE(run.out.find("that the plan does not name"), std::string::npos) << run.out;
}

TEST_F(SpoiltProgram, ShowsCutsDeeperThanPlanned) {
    // The same program against a plan that wanted smaller depths of cut.
    std::ifstream file(dir_ / "plan.json");
    Json plan = Json::parse(file);
    plan["operations"][1]["step_down_mm"] = 3;
    std::ofstream(dir_ / "plan.json") << plan;
    const ProgramRun run = verify(dir_);
    EXPECT_EQ(run.exit_code, 2) << run.out;
    EXPECT_TRUE(test::tells(run.out, {"S1.O2", "more than", "3 mm"}));
}

TEST_F(SpoiltProgram, IsNotPosted) {
    replace(find(" G0 Z2.5000"), "Z2.5000", "Z-3.0000");
    verifySpoilt();
    const ProgramRun run = runProgram({stepmillBinary(), "post", dir_.string(), "--dialect", "fanuc"});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_FALSE(fs::exists(dir_ / "S1.nc"));
}

}  // namespace
}  // namespace stepmill::test
