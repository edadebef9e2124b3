// What of the machine stands round the part: the column behind the spindle, the table below it.

#include <gtest/gtest.h>

#include <filesystem>

#include <nlohmann/json.hpp>

#include "stepmill/core/file.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string sourceFile(const std::string& name) {
    return (fs::path(STEPMILL_SOURCE_DIR) / name).string();
}

class MachineRoom : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return (fs::path(folder_.path()) / name).string(); }

    /// Plans a sample on the usual machine with some fields of its own.
    ProgramRun plan(const std::string& part, const Json& fields, std::vector<std::string> more = {}) const {
        Json machine = Json::parse(readFile(sourceFile("samples/machine_vmc.json")));
        machine.update(fields);
        writeFile(path("machine.json"), machine.dump());
        more.insert(more.begin(), {stepmillBinary(), "plan", sourceFile(part), "-o", path("job"), "--machine",
                                   path("machine.json")});
        return runProgram(more);
    }

    Json planned() const { return Json::parse(readFile(path("job/plan.json"))); }

    std::string warningOf(const std::string& code) const {
        const Json plan = planned();
        for (const Json& warning : plan["warnings"])
            if (warning["code"] == code) return warning["text"];
        return {};
    }

  private:
    TemporaryFolder folder_;
};

constexpr const char* kPart = "step_parts/rounded_pocket.step";

TEST_F(MachineRoom, OfAColumnFarBehindTakesNoProgram) {
    ASSERT_LE(plan(kPart, {{"column_behind_mm", 400}}).exit_code, 1);
    EXPECT_TRUE(fs::exists(path("job/S1.ngc")));
    EXPECT_EQ(warningOf("travel"), "");
    EXPECT_EQ(planned()["machine"]["column_behind_mm"], 400);
}

TEST_F(MachineRoom, OfAColumnTooNearTakesTheProgram) {
    ASSERT_EQ(plan(kPart, {{"column_behind_mm", 40}}).exit_code, 1);
    EXPECT_FALSE(fs::exists(path("job/S1.ngc")));
    EXPECT_NE(warningOf("travel").find("the machine's column stands 40 mm behind it"), std::string::npos)
        << warningOf("travel");
}

TEST_F(MachineRoom, OfAColumnIsProvenFromTheFiles) {
    ASSERT_LE(plan(kPart, {{"column_behind_mm", 400}}).exit_code, 1);
    Json nearer = planned();
    nearer["machine"]["column_behind_mm"] = 40;
    writeFile(path("job/plan.json"), nearer.dump());
    const ProgramRun run = runProgram({stepmillBinary(), "verify", path("job")});
    EXPECT_NE(run.exit_code, 0);
    EXPECT_NE((run.out + run.err).find("the column stands 40 mm behind it"), std::string::npos)
        << run.out << run.err;
}

TEST_F(MachineRoom, BelowALowPlateAsksForMoreUnderIt) {
    const auto plateOver = [&](double lowest_mm) {
        return plan(kPart, {{"gauge_over_table_mm", {lowest_mm, 620}}}, {"--hold", "plate"}).exit_code;
    };
    ASSERT_LE(plateOver(20), 1);
    EXPECT_EQ(warningOf("low-spindle"), "");
    ASSERT_LE(plateOver(200), 1);
    EXPECT_NE(warningOf("low-spindle").find("or more under the plate"), std::string::npos)
        << warningOf("low-spindle");
}

TEST_F(MachineRoom, OfAColumnIsNoGuess) {
    const ProgramRun run = plan(kPart, {{"column_behind_mm", 0}});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("column_behind_mm"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace stepmill::test
