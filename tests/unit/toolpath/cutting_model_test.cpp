// Figures worked out by hand with the formulas of docs/algorithms/cutting-model.md.

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/toolpath/cutting_model.h"

namespace stepmill {
namespace {

/// A 12 mm cutter with three teeth in aluminium: 5.4 x 10 mm at 2160 mm/min and 9000 rpm.
CuttingFacts endMill12() {
    CuttingFacts facts;
    facts.diameter_mm = 12;
    facts.flutes = 3;
    facts.stick_out_mm = 43;
    facts.step_over_mm = 5.4;
    facts.step_down_mm = 10;
    facts.slot_step_down_mm = 6;
    facts.rated_removal_mm3_per_min = 5.4 * 10 * 2160;
    facts.feed_mm_per_min = 2160;
    facts.speed_rpm = 9000;
    facts.kc11_n_per_mm2 = 700;
    facts.mc = 0.25;
    facts.spindle_kw = 11;
    facts.efficiency = 0.85;
    return facts;
}

TEST(CuttingModel, FeedsTheStepOverAsTheLibrarySays) {
    const LimitedFeed found = CuttingModel(endMill12()).feedFor(5.4, 10);
    EXPECT_NEAR(found.feed_mm_per_min, 2160, 1e-6);
}

TEST(CuttingModel, FeedsAFullSlotAtTheRatedRemoval) {
    // 116640 mm3/min through 120 mm2.
    const LimitedFeed found = CuttingModel(endMill12()).feedFor(12, 10);
    EXPECT_NEAR(found.feed_mm_per_min, 972, 1e-6);
    EXPECT_EQ(found.limit, FeedLimit::Rated);
}

TEST(CuttingModel, SlowsADeepSlotWhereTheRatingWouldAllowMore) {
    CuttingFacts facts = endMill12();
    facts.rated_removal_mm3_per_min = 12 * 10 * 2160;
    const LimitedFeed found = CuttingModel(facts).feedFor(12, 10);
    EXPECT_NEAR(found.feed_mm_per_min, 2160 * 0.6, 1e-6);
    EXPECT_EQ(found.limit, FeedLimit::Slot);
    EXPECT_NEAR(CuttingModel(facts).feedFor(12, 6).feed_mm_per_min, 2160, 1e-6);
}

TEST(CuttingModel, FeedsThinCutsFasterUpToAFactor) {
    // sin phi: 2 sqrt(0.45 0.55) at the step-over, 2 sqrt(0.2 0.8) = 0.8 at 2.4 mm.
    const CuttingModel model(endMill12());
    EXPECT_NEAR(model.feedFor(2.4, 10).feed_mm_per_min, 2160 * 0.994987 / 0.8, 0.01);
    EXPECT_EQ(model.feedFor(2.4, 10).limit, FeedLimit::Chip);
    EXPECT_NEAR(model.feedFor(0.5, 10).feed_mm_per_min, 2160 * 1.5, 1e-9);
    EXPECT_NEAR(model.feedFor(0, 10).feed_mm_per_min, 2160 * 1.5, 1e-9);
}

TEST(CuttingModel, KeepsToTheMachinesFeed) {
    CuttingFacts facts = endMill12();
    facts.max_feed_mm_per_min = 2500;
    const LimitedFeed found = CuttingModel(facts).feedFor(0.5, 10);
    EXPECT_DOUBLE_EQ(found.feed_mm_per_min, 2500);
    EXPECT_EQ(found.limit, FeedLimit::Machine);
}

TEST(CuttingModel, TellsThePowerByKienzle) {
    // Mean chip 0.08 x 2 x 0.45 / acos(0.1) = 0.04896 mm: kc = 700 x 0.04896^-0.25 = 1488 N/mm2.
    EXPECT_NEAR(CuttingModel(endMill12()).powerKw(5.4, 10, 2160), 3.4034, 1e-3);
    // A full slot at 972 mm/min: mean chip 0.036 x 2 / pi = 0.02292 mm, kc = 1799 N/mm2.
    EXPECT_NEAR(CuttingModel(endMill12()).powerKw(12, 10, 972), 4.1146, 1e-3);
}

TEST(CuttingModel, FeedsNoFasterThanTheSpindleCanTurn) {
    CuttingFacts facts = endMill12();
    facts.spindle_kw = 2;
    const CuttingModel model(facts);
    const LimitedFeed found = model.feedFor(5.4, 10);
    EXPECT_EQ(found.limit, FeedLimit::Power);
    EXPECT_NEAR(model.powerKw(5.4, 10, found.feed_mm_per_min), 2, 1e-9);
    facts.by_torque = true;
    EXPECT_EQ(CuttingModel(facts).feedFor(5.4, 10).limit, FeedLimit::Torque);
}

TEST(CuttingModel, BendsTheToolByTheForceAtItsTip) {
    // 3.497 kW at the edge's 339.3 m/min are 618.5 N on a rod of 9.6 mm, 43 mm long, of carbide.
    EXPECT_NEAR(CuttingModel(endMill12()).deflectionMm(12, 10, 972), 0.06552, 1e-4);
    CuttingFacts facts = endMill12();
    facts.cutter_material = CutterMaterial::Hss;
    EXPECT_NEAR(CuttingModel(facts).deflectionMm(12, 10, 972), 0.06552 * 600 / 210, 1e-4);
}

TEST(CuttingModel, FeedsNoWiderOrDeeperCutFaster) {
    CuttingFacts facts = endMill12();
    facts.spindle_kw = 3;
    const CuttingModel model(facts);
    for (double width = 0.1; width < 12; width += 0.1)
        for (double depth = 0.5; depth < 10; depth += 0.5) {
            const double feed = model.feedFor(width, depth).feed_mm_per_min;
            EXPECT_LE(model.feedFor(width + 0.1, depth).feed_mm_per_min, feed + 1e-9) << width;
            EXPECT_LE(model.feedFor(width, depth + 0.5).feed_mm_per_min, feed + 1e-9) << depth;
            EXPECT_LE(width * depth * feed, facts.rated_removal_mm3_per_min * (1 + 1e-9));
            EXPECT_LE(model.powerKw(width, depth, feed), 3 + 1e-9);
        }
}

TEST(CuttingModel, DrivesCutsFasterNoFurtherThanItsThinnestChips) {
    CuttingFacts facts = endMill12();
    facts.pace = 1.2;
    const CuttingModel driven(facts);
    EXPECT_NEAR(driven.feedFor(5.4, 10).feed_mm_per_min, 1.2 * 2160, 1e-6);
    EXPECT_NEAR(driven.feedFor(12, 10).feed_mm_per_min, 1.2 * 972, 1e-6);
    EXPECT_NEAR(driven.feedFor(0.5, 10).feed_mm_per_min, 1.5 * 2160, 1e-6);
    EXPECT_EQ(driven.feedFor(0.5, 10).limit, FeedLimit::Chip);
    facts.pace = 1.5;
    EXPECT_NEAR(CuttingModel(facts).feedFor(2.4, 10).feed_mm_per_min, 1.5 * 2160, 1e-6);
}

TEST(CuttingModel, DrivesNoCutBeyondSpindleAndBending) {
    CuttingFacts facts = endMill12();
    facts.spindle_kw = 1.5;
    const LimitedFeed usual = CuttingModel(facts).feedFor(5.4, 10);
    ASSERT_EQ(usual.limit, FeedLimit::Power);
    facts.pace = 1.5;
    EXPECT_NEAR(CuttingModel(facts).feedFor(5.4, 10).feed_mm_per_min, usual.feed_mm_per_min, 1e-6);

    CuttingFacts slim = endMill12();
    slim.stick_out_mm = 50;
    slim.pace = 1.5;
    const CuttingModel bending(slim);
    const LimitedFeed held = bending.feedFor(5.4, 10);
    EXPECT_EQ(held.limit, FeedLimit::Bending);
    EXPECT_NEAR(bending.deflectionMm(5.4, 10, held.feed_mm_per_min), kMostDeflectionMm, 1e-9);
    slim.stick_out_mm = 88;
    EXPECT_NEAR(CuttingModel(slim).feedFor(5.4, 10).feed_mm_per_min, 2160, 1e-6) << "never slower than usual";
}

TEST(CuttingModel, IsNeverSlowerAtAFasterPaceNorFasterInAWiderCut) {
    for (const double stick_out_mm : {43.0, 50.0, 55.0, 120.0})
        for (const double kw : {0.5, 2.0, 11.0})
            for (double width_mm = 0.3; width_mm <= 12; width_mm += 0.45)
                for (double depth_mm = 0.5; depth_mm <= 20; depth_mm *= 1.6) {
                    CuttingFacts facts = endMill12();
                    facts.stick_out_mm = stick_out_mm;
                    facts.spindle_kw = kw;
                    double before = 0;
                    for (const double pace : {1.0, 1.05, 1.2, 1.4, 1.5}) {
                        facts.pace = pace;
                        const CuttingModel model(facts);
                        const double feed = model.feedFor(width_mm, depth_mm).feed_mm_per_min;
                        EXPECT_GE(feed, before * (1 - 1e-12));
                        EXPECT_LE(feed, kMostChipThinning * facts.feed_mm_per_min * (1 + 1e-12));
                        EXPECT_LE(model.powerKw(width_mm, depth_mm, feed), kw * (1 + 1e-9));
                        EXPECT_LE(model.feedFor(width_mm + 0.2, depth_mm).feed_mm_per_min,
                                  feed * (1 + 1e-12));
                        EXPECT_LE(model.feedFor(width_mm, depth_mm + 0.2).feed_mm_per_min,
                                  feed * (1 + 1e-12));
                        before = feed;
                    }
                }
}

TEST(CuttingFacts, AreTakenFromTheCatalog) {
    const ToolLibrary library = defaultToolLibrary();
    const ToolAssembly& tool = library.tool("EM12");
    const Machine machine = defaultMachine();
    const Material material = *defaultMaterials().find("aluminium");
    const auto facts = cuttingFacts(tool, *tool.cuttingFor("aluminium"), material, machine);
    ASSERT_TRUE(facts);
    EXPECT_DOUBLE_EQ(facts->slot_step_down_mm, 6);
    EXPECT_DOUBLE_EQ(facts->spindle_kw, 11);
    EXPECT_DOUBLE_EQ(facts->kc11_n_per_mm2, 700);
    Machine no_spindle = machine;
    no_spindle.spindle_curve.clear();
    EXPECT_FALSE(cuttingFacts(tool, *tool.cuttingFor("aluminium"), material, no_spindle));
}

}  // namespace
}  // namespace stepmill
