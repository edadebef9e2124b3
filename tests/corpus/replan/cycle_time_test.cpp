// Jobs planned again for a time: what is met, what is not and why, what is refused.

#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stepmill/core/file.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

const std::string kPart = std::string(STEPMILL_SOURCE_DIR) + "/step_parts/plate_with_holes.step";
const std::string kTools = std::string(STEPMILL_SOURCE_DIR) + "/samples/shop_metric_tools.json";

ProgramRun stepmill(Words words) {
    words.insert(words.begin(), stepmillBinary());
    return runProgram(words);
}

/// "2:05.250"
std::string clockWord(double seconds) {
    const long thousandths = std::lround(seconds * 1000);
    char word[40];
    std::snprintf(word, sizeof word, "%ld:%02ld.%03ld", thousandths / 60000, thousandths / 1000 % 60,
                  thousandths % 1000);
    return word;
}

class CycleTime : public testing::Test {
  protected:
    void SetUp() override {
        const ProgramRun run = stepmill({"plan", kPart, "--tools", kTools, "-o", path("job")});
        ASSERT_LE(run.exit_code, 1) << run.err;
        plan_exit_code_ = run.exit_code;
        usual_s_ = planOf("job")["totals"]["motion_time_s"];
    }

    std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
    Json planOf(const std::string& job) const { return Json::parse(readFile(path(job) + "/plan.json")); }

    ProgramRun again(Words more) const {
        Words words{"replan", path("job"), "--part", kPart, "--tools", kTools, "-o", path("new")};
        words.insert(words.end(), more.begin(), more.end());
        return stepmill(words);
    }

    /// Its programs hold by themselves and against part and library.
    void expectVerified() const {
        EXPECT_EQ(stepmill({"verify", path("new")}).exit_code, 0);
        const ProgramRun all = stepmill({"verify", path("new"), "--part", kPart, "--tools", kTools});
        EXPECT_EQ(all.exit_code, 0) << all.out << all.err;
    }

    TemporaryFolder folder_;
    double usual_s_ = 0;
    int plan_exit_code_ = 0;
};

TEST_F(CycleTime, IsMetLongerAndShorter) {
    for (const double factor : {1.3, 0.98}) {
        const double target_s = factor * usual_s_;
        const ProgramRun run = again({"--cycle-time", clockWord(target_s)});
        EXPECT_EQ(run.exit_code, plan_exit_code_) << run.err;
        const Json plan = planOf("new");
        EXPECT_NEAR(plan["totals"]["motion_time_s"], target_s, 0.01 * target_s);
        EXPECT_TRUE(plan["cycle_time"]["outcomes"][0]["met"]);
        EXPECT_EQ(Json::parse(readFile(path("new") + "/replan.json"))["cycle_time"], plan["cycle_time"]);
        expectVerified();
    }
}

TEST_F(CycleTime, SaysTheLeastWhereItCannotBeMet) {
    const ProgramRun run = again({"--cycle-time", "0:01"});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.err.find("cycle time not met: the part takes"), std::string::npos) << run.err;
    const Json outcome = planOf("new")["cycle_time"]["outcomes"][0];
    EXPECT_FALSE(outcome["met"]);
    EXPECT_LT(outcome["time_s"], usual_s_);
    EXPECT_FALSE(outcome["uses"].empty());
    expectVerified();
}

TEST_F(CycleTime, IsKeptByLaterReplansUntilItIsOff) {
    ASSERT_LE(again({"--cycle-time", clockWord(1.3 * usual_s_)}).exit_code, 1);
    const std::string kept = readFile(path("new") + "/plan.json");
    ASSERT_LE(
        stepmill({"replan", path("new"), "--part", kPart, "--tools", kTools, "-o", path("later")}).exit_code,
        1);
    EXPECT_EQ(readFile(path("later") + "/plan.json"), kept);
    ASSERT_LE(stepmill({"replan", path("new"), "--part", kPart, "--tools", kTools, "--cycle-time", "off",
                        "-o", path("off")})
                  .exit_code,
              1);
    EXPECT_EQ(readFile(path("off") + "/plan.json"), readFile(path("job") + "/plan.json"));
}

TEST_F(CycleTime, IsOfSetupsAndFeaturesToo) {
    const Json plan = planOf("job");
    const std::string setup = plan["setups"][0]["id"];
    const double setup_s = plan["setups"][0]["motion_time_s"];
    const std::string feature = plan["operations"][0]["feature"];
    double feature_s = 0;
    for (const Json& operation : plan["operations"])
        if (operation["feature"] == feature) feature_s += operation["motion_time_s"].get<double>();
    const ProgramRun run = again({"--cycle-time", setup + "=" + clockWord(1.2 * setup_s), "--cycle-time",
                                  feature + "=" + clockWord(1.1 * feature_s)});
    EXPECT_EQ(run.exit_code, plan_exit_code_) << run.err;
    EXPECT_NEAR(planOf("new")["setups"][0]["motion_time_s"], 1.2 * setup_s, 0.012 * setup_s);
    expectVerified();
}

TEST_F(CycleTime, RefusesWhatIsNoTime) {
    for (const char* word : {"", "0:00", "-1:00", "270", "4:3", "4:99", "4.5", "1000:00:00", "nan", "=4:30",
                             "S1=", "S9=1:00", "S1.F99=1:00", "s1=1:00", "4:30 "}) {
        const ProgramRun run = stepmill({"replan", path("job"), "--tools", kTools, "-o", path("new"),
                                         std::string("--cycle-time=") + word});
        EXPECT_EQ(run.exit_code, 2) << word;
        EXPECT_FALSE(fs::exists(path("new"))) << word;
    }
    const ProgramRun twice = again({"--cycle-time", "1:00", "--cycle-time", "2:00"});
    EXPECT_EQ(twice.exit_code, 2);
    EXPECT_NE(twice.err.find("expected one time for each"), std::string::npos) << twice.err;
}

}  // namespace
}  // namespace stepmill::test
