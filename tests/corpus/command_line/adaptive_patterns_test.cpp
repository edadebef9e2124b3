// Roughing at constant engagement, from the library's set to what `verify` says.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const std::string kSource = STEPMILL_SOURCE_DIR;
const std::string kTools = kSource + "/samples/shop_with_adaptive_tools.json";
const std::string kDeepPart = kSource + "/step_parts/bossed_pocket.step";

Json readJson(const fs::path& file) {
    return Json::parse(std::ifstream(file));
}

class AdaptivePatterns : public testing::Test {
  protected:
    fs::path file(const std::string& name) const { return fs::path(folder_.path()) / name; }

    Json plan(const std::vector<std::string>& options, const std::string& part = kDeepPart) const {
        std::vector<std::string> arguments{stepmillBinary(), "plan", part, "-o", file("job").string()};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramRun run = runProgram(arguments);
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return readJson(file("job") / "plan.json");
    }

    ProgramRun verify(const std::vector<std::string>& options = {}) const {
        std::vector<std::string> arguments{stepmillBinary(), "verify", file("job").string()};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return runProgram(arguments);
    }

    TemporaryFolder folder_;
};

int adaptiveOperations(const Json& plan) {
    return static_cast<int>(std::count_if(plan["operations"].begin(), plan["operations"].end(),
                                          [](const Json& one) { return one.contains("engagement_deg"); }));
}

TEST_F(AdaptivePatterns, AreTakenWhereTheLibraryHasASetAndTheyAreQuicker) {
    const Json usual = plan({});
    EXPECT_EQ(adaptiveOperations(usual), 0);
    const Json adaptive = plan({"--tools", kTools});
    EXPECT_GT(adaptiveOperations(adaptive), 0);
    EXPECT_LT(adaptive["totals"]["motion_time_s"], usual["totals"]["motion_time_s"]);
    const ProgramRun run = verify({"--part", kDeepPart, "--tools", kTools});
    EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
}

TEST_F(AdaptivePatterns, MakeNoPlanSlower) {
    // At the library's feeds one would be quicker here, at those of its entry it is not.
    const std::string pocket = kSource + "/step_parts/rounded_pocket.step";
    for (const char* material : {"steel", "aluminium"}) {
        const Json usual = plan({"--material", material}, pocket);
        const Json adaptive = plan({"--material", material, "--tools", kTools}, pocket);
        EXPECT_LE(adaptive["totals"]["motion_time_s"], usual["totals"]["motion_time_s"]) << material;
    }
}

TEST_F(AdaptivePatterns, AreNotTakenWhereOthersAreNamed) {
    const Json plan = this->plan({"--tools", kTools, "--patterns", "zigzag,one-way"});
    EXPECT_EQ(adaptiveOperations(plan), 0);
}

TEST_F(AdaptivePatterns, EngageNoMoreThanThePlanSays) {
    Json plan = this->plan({"--tools", kTools});
    for (Json& operation : plan["operations"])
        if (operation.contains("engagement_deg"))
            operation["engagement_deg"] = 0.9 * operation["engagement_deg"].get<double>();
    // Who edits a plan writes its manifest anew, or takes it away.
    fs::remove(file("job") / "manifest.json");
    std::ofstream(file("job") / "plan.json") << plan;
    const ProgramRun run = verify();
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE((run.out + run.err).find("degrees of the cutter's rim; planned are"), std::string::npos)
        << run.out << run.err;
}

TEST_F(AdaptivePatterns, RefusesNamesThatAreNone) {
    const ProgramRun run = runProgram(
        {stepmillBinary(), "plan", kDeepPart, "-o", file("job").string(), "--patterns", "zigzag,spiral"});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("\"spiral\""), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(file("job")));
}

}  // namespace
}  // namespace stepmill::test
