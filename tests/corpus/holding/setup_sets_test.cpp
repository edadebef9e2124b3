// Few setups where form cutters finish what these leave in steps, weighed with the time to set up.

#include <gtest/gtest.h>

#include <filesystem>

#include <nlohmann/json.hpp>

#include "stepmill/core/file.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A block with blends all round, which axes for its leaning walls finish too.
class SetupSets : public testing::Test {
  protected:
    void SetUp() override {
        if (!fs::exists(part_)) GTEST_SKIP() << part_ << " is not here";
    }

    std::string path(const std::string& name) const { return (fs::path(folder_.path()) / name).string(); }

    Json plan(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {stepmillBinary(), "plan", part_, "-o", path("job")});
        const ProgramRun run = runProgram(more);
        EXPECT_LE(run.exit_code, 1) << run.err;
        return Json::parse(readFile(path("job/plan.json")));
    }

    static double staysMm3(const Json& plan) {
        const Json& balance = plan["volume_balance"];
        return balance["residual_mm3"].get<double>() + balance["unreachable_mm3"].get<double>();
    }

    std::string part_ = (fs::path(STEPMILL_SOURCE_DIR) / "../shared/parts/machined/boxblend_03.stp").string();

  private:
    TemporaryFolder folder_;
};

TEST_F(SetupSets, AreAsFewAsFormCuttersCanDoWith) {
    const Json planned = plan();
    EXPECT_EQ(planned["setups"].size(), 1U);
    ASSERT_EQ(planned["setup_choices"].size(), 2U);
    EXPECT_EQ(planned["setup_choices"][0]["verdict"], "taken");
    EXPECT_EQ(planned["setup_choices"][0]["setup_s"], 1200);
    EXPECT_EQ(planned["setup_choices"][1]["axes"].size(), 3U);
    EXPECT_EQ(planned["setup_choices"][1]["verdict"], "can take no less");
    EXPECT_FALSE(planned["setup_choices"][1].contains("time_s"));
    const ProgramRun proof = runProgram({stepmillBinary(), "verify", path("job"), "--part", part_});
    EXPECT_NE(proof.out.find("operations are proven"), std::string::npos) << proof.out << proof.err;
}

TEST_F(SetupSets, AreAllPlannedWhereSettingUpHardlyCounts) {
    const Json planned = plan({"--quantity", "500"});
    EXPECT_EQ(planned["request"]["quantity"], 500);
    ASSERT_EQ(planned["setup_choices"].size(), 2U);
    for (const Json& choice : planned["setup_choices"])
        EXPECT_TRUE(choice.contains("time_s"));
    // What was turned down is no better.
    const Json& other = planned["setup_choices"][1];
    if (other["verdict"] == "takes longer")
        EXPECT_GE(other["time_s"].get<double>() + other["setup_s"].get<double>(),
                  planned["totals"]["motion_time_s"].get<double>());
    else
        EXPECT_GT(other["stays_mm3"].get<double>(), staysMm3(planned));
}

TEST_F(SetupSets, AreThoseOfFlatCuttersWithoutFormCutters) {
    const Json planned = plan({"--scallop", "0"});
    EXPECT_EQ(planned["setups"].size(), 3U);
    EXPECT_FALSE(planned.contains("setup_choices"));
}

}  // namespace
}  // namespace stepmill::test
