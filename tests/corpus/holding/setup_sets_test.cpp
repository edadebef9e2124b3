// Few setups where form cutters finish what these leave in steps, weighed with the time to set up.

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include <nlohmann/json.hpp>

#include "stepmill/core/file.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Plans that leave as much differ by no more than this share of what is to be removed.
constexpr double kAlikeShare = 2e-4;

/// A block with blends all round, which axes for its leaning walls finish too.
class SetupSets : public testing::Test {
  protected:
    void SetUp() override {
        if (!fs::exists(part_)) GTEST_SKIP() << part_ << " is not here";
    }

    std::string path(const std::string& name) const { return (fs::path(folder_.path()) / name).string(); }

    Json plan(std::vector<std::string> more = {}) const { return planOf(part_, std::move(more)); }

    Json planOf(const std::string& part, std::vector<std::string> more) const {
        more.insert(more.begin(), {stepmillBinary(), "plan", part, "-o", path("job")});
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
    EXPECT_EQ(planned["setup_choices"][0]["setup_s"], 1200 + 60);
    EXPECT_EQ(planned["setup_choices"][1]["axes"].size(), 3U);
    EXPECT_EQ(planned["setup_choices"][1]["verdict"], "can take no less");
    EXPECT_FALSE(planned["setup_choices"][1].contains("time_s"));
    const ProgramRun proof = runProgram({stepmillBinary(), "verify", path("job"), "--part", part_});
    EXPECT_NE(proof.out.find("operations are proven"), std::string::npos) << proof.out << proof.err;
}

TEST_F(SetupSets, AreAllPlannedWhereSettingUpHardlyCounts) {
    const std::string part =
        (fs::path(STEPMILL_SOURCE_DIR) / "../shared/parts/machined/aagnet_test.step").string();
    const Json planned = planOf(part, {"--quantity", "500"});
    EXPECT_EQ(planned["request"]["quantity"], 500);
    const Json& choices = planned["setup_choices"];
    ASSERT_GE(choices.size(), 3U);
    for (std::size_t i = 1; i < choices.size(); ++i) {
        // What was turned down is no better.
        ASSERT_TRUE(choices[i].contains("time_s"));
        if (choices[i]["verdict"] == "takes longer") {
            EXPECT_GE(choices[i]["time_s"].get<double>() + choices[i]["setup_s"].get<double>(),
                      planned["totals"]["motion_time_s"].get<double>());
        } else if (choices[i]["verdict"] == "leaves more") {
            EXPECT_GT(choices[i]["stays_mm3"].get<double>(), staysMm3(planned));
        }
    }
}

TEST_F(SetupSets, AreThoseOfFlatCuttersWithoutFormCutters) {
    const Json planned = plan({"--scallop", "0"});
    // Walls in flat layers are far from the bound, so all sides and orders are planned: none leaves less by
    // more than what counts as leaving alike, or as much in less time.
    EXPECT_EQ(planned["setups"].size(), 4U);
    const Json& choices = planned["setup_choices"];
    ASSERT_GE(choices.size(), 4U);
    const double alike_mm3 = kAlikeShare * planned["volume_balance"]["stock_minus_part_mm3"].get<double>();
    for (std::size_t i = 1; i < choices.size(); ++i) {
        EXPECT_GE(choices[i]["stays_mm3"].get<double>(), choices[0]["stays_mm3"].get<double>() - alike_mm3);
        if (choices[i]["verdict"] != "leaves more") {
            EXPECT_EQ(choices[i]["verdict"], "takes longer");
            EXPECT_GE(choices[i]["time_s"].get<double>(), choices[0]["time_s"].get<double>());
        }
    }
    for (const Json& operation : planned["operations"])
        EXPECT_NE(operation["role"], "form");
}

// What is chosen against what could have been asked for ----------------------------------------------------

constexpr const char* kLot = "1000";

struct Weighed {
    std::vector<std::string> axes;
    double s = 0;  ///< with setting up
    double stays_mm3 = 0;
    double removed_mm3 = 0;
    int unheld = 0;  ///< setups that nothing is known to hold
};

std::string opposite(std::string axis) {
    axis.front() = axis.front() == '+' ? '-' : '+';
    return axis;
}

/// Of a part in a lot in which setting up hardly counts.
class ChosenSetups : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        if (!fs::exists(part_)) GTEST_SKIP() << part_ << " is not here";
    }

    /// Nothing where the part cannot be planned so.
    std::optional<Weighed> planned(std::vector<std::string> more) const {
        more.insert(more.begin(), {stepmillBinary(), "plan", part_, "--json", "--no-viewer", "--quantity",
                                   kLot, "-o", (fs::path(folder_.path()) / "job").string()});
        const ProgramRun run = runProgram(more);
        if (run.exit_code > 1) return std::nullopt;
        const Json plan = Json::parse(run.out);
        Weighed weighed;
        double setting_up_min = 0;
        for (const Json& setup : plan["setups"]) {
            weighed.axes.push_back(setup["axis_name"]);
            if (setup["operations"].empty()) continue;
            weighed.unheld += setup["clamping"].value("kind", "none") == "none" ? 1 : 0;
            setting_up_min += setup["indexed"].get<bool>() ? 40 : 20;
        }
        weighed.s = plan["totals"]["motion_time_s"].get<double>() + 60 * setting_up_min / std::stoi(kLot);
        const Json& balance = plan["volume_balance"];
        weighed.stays_mm3 = balance["residual_mm3"].get<double>() + balance["unreachable_mm3"].get<double>();
        weighed.removed_mm3 = balance["stock_minus_part_mm3"];
        return weighed;
    }

    std::string part_ = (fs::path(STEPMILL_SOURCE_DIR) / GetParam()).string();

  private:
    TemporaryFolder folder_;
};

TEST_P(ChosenSetups, AreBeatenByNoExclusionAndNoOrderOfOppositeOnes) {
    const std::optional<Weighed> chosen = planned({});
    ASSERT_TRUE(chosen);
    const std::vector<std::string>& axes = chosen->axes;
    std::vector<std::vector<std::string>> asked;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        asked.push_back({"--no-setup=" + axes[i]});
        for (std::size_t k = i + 1; k < axes.size(); ++k) {
            if (axes[k] != opposite(axes[i])) continue;
            std::vector<std::string> turned = axes;
            std::swap(turned[i], turned[k]);
            for (std::string& axis : turned)
                axis.insert(0, "--setup=");
            asked.push_back(turned);
        }
    }
    for (const std::vector<std::string>& options : asked) {
        const std::optional<Weighed> other = planned(options);
        if (!other || other->unheld > chosen->unheld) continue;
        if (other->stays_mm3 > chosen->stays_mm3 + kAlikeShare * chosen->removed_mm3) continue;
        EXPECT_GE(other->s, chosen->s) << options.front();
    }
}

INSTANTIATE_TEST_SUITE_P(Quick, ChosenSetups, testing::Values("step_parts/four_setups.step"));
INSTANTIATE_TEST_SUITE_P(Slow, ChosenSetups,
                         testing::Values("../shared/parts/machined/aagnet_test.step",
                                         "../shared/parts/machined/hole_model.stp",
                                         "../shared/parts/machined/gehause_rohteil.stp"));

}  // namespace
}  // namespace stepmill::test
