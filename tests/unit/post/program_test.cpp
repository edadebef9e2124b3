#include <random>

#include <gtest/gtest.h>

#include "post/motion_writer.h"
#include "stepmill/core/error.h"
#include "support/sample_plan.h"
#include "unit/post/gcode_reader.h"

namespace stepmill::test {
namespace {

Program sampleProgram() {
    const Plan plan = samplePlan();
    return readProgram(program(plan, plan.setups[0]));
}

PathTotals sampleTotals() {
    const Plan plan = samplePlan();
    PathTotals totals;
    for (const Operation& operation : plan.setups[0].operations)
        totals += operation.path.totals;
    return totals;
}

TEST(Program, FeedsAsLongAsThePathsAre) {
    EXPECT_NEAR(sampleProgram().length(false), sampleTotals().cut_length_mm, 2e-3);
}

TEST(Program, FeedsAsLongInTimeAsThePathsDo) {
    double feed_s = 0;
    bool ramp = false;
    for (const Block& block : sampleProgram().blocks) {
        if (block.g != 0) feed_s += block.length() / block.feed * 60;
        ramp = ramp || block.feed == 900;
    }
    EXPECT_NEAR(feed_s, sampleTotals().feed_time_s, 1e-3);
    EXPECT_TRUE(ramp) << "the helix has its own feed";
}

TEST(Program, RapidsAsLongAsThePathsAreAndTheWaysFromHome) {
    const Program read = sampleProgram();
    // Over and down; the second tool starts where the first one has ended.
    const double way_in = read.blocks[0].length() + read.blocks[1].length();
    EXPECT_NEAR(read.length(true) - way_in, sampleTotals().air_length_mm, 2e-3);
}

TEST(Program, ArcCentresAgreeWithBothEnds) {
    int arcs = 0;
    for (const Block& block : sampleProgram().blocks) {
        if (block.g < 2) continue;
        ++arcs;
        EXPECT_NEAR(block.radiusAtStart(), block.radiusAtEnd(), 1e-3) << "N" << block.number;
    }
    EXPECT_EQ(arcs, 8);  // helix, circle and the 300 degree arc in halves, and the two quarters
}

TEST(Program, NoArcEndsWhereItStarts) {
    for (const Block& block : sampleProgram().blocks) {
        if (block.g < 2) continue;
        EXPECT_GT(std::hypot(block.to[0] - block.from[0], block.to[1] - block.from[1]), 1e-3);
    }
}

TEST(Program, CrossesAtHomeBeforeItComesDown) {
    const Program read = sampleProgram();
    ASSERT_GE(read.blocks.size(), 2U);
    EXPECT_EQ(read.blocks[0].g, 0);
    EXPECT_EQ(read.blocks[0].to[2], 0) << "no height said yet";
    EXPECT_NE(read.blocks[0].to[0], 0);
    EXPECT_EQ(read.blocks[1].g, 0);
    EXPECT_EQ(read.blocks[1].to[2], 5);
}

TEST(Program, ChangesToolsOncePerVisit) {
    int changes = 0;
    for (const std::string& line : sampleProgram().others)
        changes += line.find("M6") != std::string::npos ? 1 : 0;
    EXPECT_EQ(changes, 2);
}

TEST(Program, StartsMetricAndAbsoluteAndEndsWithM30) {
    const std::vector<std::string> others = sampleProgram().others;
    EXPECT_EQ(others.front(), "G21 G17 G40 G49 G80 G90 G94 G54");
    EXPECT_EQ(others.back(), "M30");
}

TEST(Program, NumbersItsMotionBlocksAndTheFirstOfEachOperation) {
    int before = 1;
    int left_out = 0;
    for (const Block& block : sampleProgram().blocks) {
        EXPECT_GT(block.number, before);
        left_out += block.number - before - 1;
        before = block.number;
    }
    EXPECT_EQ(left_out, 2) << "N1 and those of the second and third operation are no motions";
}

TEST(Program, IsPrintableAsciiWhateverThePartIsCalled) {
    const Plan plan = samplePlan();
    const std::string text = program(plan, plan.setups[0]);
    for (const char c : text)
        EXPECT_TRUE(c == '\n' || (c >= ' ' && c <= '~')) << static_cast<int>(c);
    EXPECT_NE(text.find("(Part Halter [links] ? 100  from part.step)"), std::string::npos) << text;
}

TEST(Program, RefusesADialectItDoesNotKnow) {
    Plan plan = samplePlan();
    plan.machine.dialect = "klartext";
    try {
        program(plan, plan.setups[0]);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Usage);
    }
}

TEST(Program, RefusesTwoToolsOfOneNumber) {
    Plan plan = samplePlan();
    plan.library.tools[1].number = plan.library.tools[0].number;
    EXPECT_THROW(program(plan, plan.setups[0]), Error);
}

TEST(ToolTable, ListsEachToolOnceInMillimetres) {
    const Plan plan = samplePlan();
    EXPECT_EQ(toolTable(jobOf(plan, plan.setups[0])), "T3 P3 Z0 D10.0000 ;EM10 \nT12 P12 Z0 D6.0000 ;EM6 \n");
}

TEST(MotionWriter, WritesAnArcTooFlatForTheDecimalsAsALine) {
    Toolpath path;
    path.feed_mm_per_min = 100;
    path.moves = {arcTo(0.1, 0, 0, Vec2(0.05, 1000), std::hypot(0.05, 1000), true)};
    std::string text;
    MotionWriter writer(text);
    writer.approach(Vec3(0, 0, 0), "", false);
    writer.write(path.start, fedMoves(path));
    EXPECT_EQ(readProgram(text).blocks.back().g, 1);
}

TEST(MotionWriter, DropsMovesShorterThanTheDecimals) {
    Toolpath path;
    path.feed_mm_per_min = 100;
    path.moves = {feedTo(0.00003, 0, 0), feedTo(1, 0, 0)};
    std::string text;
    MotionWriter writer(text);
    writer.approach(Vec3(0, 0, 0), "", false);
    writer.write(path.start, fedMoves(path));
    EXPECT_EQ(readProgram(text).blocks.size(), 3U);
}

TEST(MotionWriter, KeepsRandomArcsOfEverySizeTrue) {
    for (unsigned seed = 0; seed < 3000; ++seed) {
        std::mt19937 random(seed);
        const auto uniform = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
        const double radius = std::pow(10.0, uniform(-3.5, 3));
        const double sweep = std::pow(10.0, uniform(-5, 0)) * 6.283185;
        const double from = uniform(0, 6.28);
        const bool ccw = seed % 2 == 0;
        const Vec2 centre(uniform(-500, 500), uniform(-500, 500));
        const auto at = [&](double angle) {
            return Vec2(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
        };
        const Vec2 start = at(from);
        const Vec2 end = at(ccw ? from + sweep : from - sweep);
        Toolpath path;
        path.feed_mm_per_min = 100;
        path.start = Vec3(start.x(), start.y(), 0);
        path.moves = {arcTo(end.x(), end.y(), 0, centre, radius, ccw)};
        std::string text;
        MotionWriter writer(text);
        writer.approach(path.start, "", false);
        writer.write(path.start, fedMoves(path));
        double length = 0;
        for (const Block& block : readProgram(text).blocks) {
            if (block.g == 0) continue;
            length += block.length();
            if (block.g < 2) continue;
            ASSERT_NEAR(block.radiusAtStart(), block.radiusAtEnd(), 1e-3) << "seed " << seed;
            // Every point of the written arc lies near the true circle.
            ASSERT_LT(std::abs(block.radiusAtStart() - radius), 1e-3) << "seed " << seed;
        }
        ASSERT_NEAR(length, radius * sweep, 2e-3 + 1e-6 * radius) << "seed " << seed << "\n" << text;
    }
}

}  // namespace
}  // namespace stepmill::test
