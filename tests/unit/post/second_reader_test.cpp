#include <gtest/gtest.h>

#include "support/sample_plan.h"
#include "support/second_reader.h"
#include "unit/post/gcode_reader.h"

namespace stepmill::test {
namespace {

TEST(SecondReader, AcceptsTheProgramAndSeesEveryMotion) {
    STEPMILL_NEEDS_SECOND_READER();
    const Plan plan = samplePlan();
    const std::string text = program(plan, plan.setups[0]);
    const SecondReader reader(text, toolTable(jobOf(plan, plan.setups[0])));
    ASSERT_EQ(reader.exit_code, 0) << reader.refusal << text;
    const Program read = readProgram(text);
    int lines = 0;
    int arcs = 0;
    int rapids = 0;
    for (const Block& block : read.blocks)
        ++(block.g == 0 ? rapids : block.g == 1 ? lines : arcs);
    // Home before and after both changes, and at the end.
    EXPECT_EQ(reader.count("STRAIGHT_TRAVERSE("), rapids + 5);
    EXPECT_EQ(reader.count("STRAIGHT_FEED("), lines);
    EXPECT_EQ(reader.count("ARC_FEED("), arcs);
    EXPECT_EQ(reader.count("CHANGE_TOOL("), 2);
    EXPECT_EQ(reader.count("PROGRAM_END("), 1);
}

TEST(SecondReader, RefusesAToolTheTableLacks) {
    STEPMILL_NEEDS_SECOND_READER();
    const Plan plan = samplePlan();
    const SecondReader reader(program(plan, plan.setups[0]), "T3 P3 Z0 D10 ;EM10\n");
    EXPECT_NE(reader.exit_code, 0);
}

}  // namespace
}  // namespace stepmill::test
