// What drills are worth: in the table of a part, and to those who buy.

#include <gtest/gtest.h>

#include "stepmill/sequence/advice/purchase.h"
#include "stepmill/sequence/advice/ranking.h"
#include "support/hole_tool_makers.h"
#include "support/sample_feature.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

TEST(DrillRows, TellWhichHolesADrillMakesAndWhichItStarts) {
    const std::vector<Feature> features{holeOf(8, 10, true), holeOf(8, 10, false), holeOf(20, 10, true),
                                        makePocket(makeRectangle(Vec2(0, 0), Vec2(30, 30)), 5)};
    const auto rows = drillTable(features, makeLibrary({makeDrill(8), makeDrill(6.3), makeMill(6)}),
                                 makeMachine(), inAluminium(), kTol);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].makes, 1);
    EXPECT_EQ(rows[0].makes_room_in, 2);
    EXPECT_GT(rows[0].time_min, 0);
    EXPECT_GT(rows[0].volume_cm3, 0.5);
    EXPECT_EQ(rows[1].makes, 0);
    EXPECT_EQ(rows[1].makes_room_in, 3);
}

TEST(WhatToBuy, NamesADrillForABoreWiderThanTheLibrarysAndTheHolesItServes) {
    ToolAssembly drill = makeDrill(14);
    drill.cutting.front().feed_mm_per_min = drill.cutting.front().plunge_feed_mm_per_min = 1000;
    const PurchaseAdvice advice = whatToBuy(holeOf(20, 30, true), makeLibrary({drill, makeMill(6, 600, 3)}),
                                            makeMachine(), inAluminium(), kTol);
    ASSERT_TRUE(advice.best);
    EXPECT_EQ(advice.best->holes, 1);
    EXPECT_GT(advice.best->saved_s, 0);
}

}  // namespace
}  // namespace stepmill::test
