// The same small plan in every dialect.

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "support/drilled_plan.h"
#include "support/second_reader.h"
#include "support/text_file.h"

namespace stepmill::test {
namespace {

void expectGolden(const std::string& name, const PostOptions& options) {
    const Plan plan = drilledPlan();
    std::string text;
    for (const PostedProgram& program : post(jobOf(plan, plan.setups[0]), options))
        text += program.text;
    const std::filesystem::path golden =
        std::filesystem::path(STEPMILL_SOURCE_DIR) / "tests" / "golden" / "programs" / (name + ".txt");
    if (std::getenv("STEPMILL_REWRITE_GOLDEN") != nullptr) std::ofstream(golden) << text;
    EXPECT_EQ(text, slurp(golden)) << "if this is meant: make golden";
}

TEST(GoldenProgram, LinuxCnc) {
    expectGolden("linuxcnc", {Dialect::LinuxCnc});
}
TEST(GoldenProgram, LinuxCncInInches) {
    expectGolden("linuxcnc_inch", {Dialect::LinuxCnc, true});
}
TEST(GoldenProgram, Fanuc) {
    expectGolden("fanuc", {Dialect::Fanuc});
}
TEST(GoldenProgram, Grbl) {
    expectGolden("grbl", {Dialect::Grbl});
}
TEST(GoldenProgram, GrblByTool) {
    expectGolden("grbl_by_tool", {Dialect::Grbl, false, true});
}

TEST(GoldenProgram, LinuxCncTakesTheInchProgramToo) {
    STEPMILL_NEEDS_SECOND_READER();
    const Plan plan = drilledPlan();
    const Job job = jobOf(plan, plan.setups[0]);
    const SecondReader reader(post(job, {Dialect::LinuxCnc, true}).front().text, toolTable(job));
    EXPECT_EQ(reader.exit_code, 0) << reader.refusal;
    EXPECT_EQ(reader.count("PROGRAM_END("), 1);
}

}  // namespace
}  // namespace stepmill::test
