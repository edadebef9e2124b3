// The same small plan in every dialect.

#include <gtest/gtest.h>

#include "support/drilled_plan.h"
#include "support/golden.h"
#include "support/second_reader.h"
#include "support/tapped_plan.h"

namespace stepmill::test {
namespace {

void expectProgram(const std::string& name, const PostOptions& options, const Plan& plan = drilledPlan()) {
    std::string text;
    for (const PostedProgram& program : post(jobOf(plan, plan.setups[0]), options))
        text += program.text;
    expectGolden("programs/" + name + ".txt", text);
}

TEST(GoldenProgram, LinuxCnc) {
    expectProgram("linuxcnc", {Dialect::LinuxCnc});
}
TEST(GoldenProgram, LinuxCncInInches) {
    expectProgram("linuxcnc_inch", {Dialect::LinuxCnc, true});
}
TEST(GoldenProgram, Fanuc) {
    expectProgram("fanuc", {Dialect::Fanuc});
}
TEST(GoldenProgram, Grbl) {
    expectProgram("grbl", {Dialect::Grbl});
}
TEST(GoldenProgram, GrblByTool) {
    expectProgram("grbl_by_tool", {Dialect::Grbl, false, true});
}

TEST(GoldenProgram, ThreadsOnLinuxCnc) {
    expectProgram("linuxcnc_tapped", {Dialect::LinuxCnc}, tappedPlan());
}
TEST(GoldenProgram, ThreadsOnFanuc) {
    expectProgram("fanuc_tapped", {Dialect::Fanuc}, tappedPlan());
}
TEST(GoldenProgram, ThreadsOnFanucInInches) {
    expectProgram("fanuc_tapped_inch", {Dialect::Fanuc, true}, tappedPlan());
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
