// Holes nearly as deep as drills reach, and deeper; slots deeper than the stiff mills of their width.

#include <algorithm>

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/plan/books.h"
#include "stepmill/plan/plan.h"
#include "support/occt_solids.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

TopoDS_Shape plateWithHole(double diameter_mm, double thickness_mm) {
    const gp_Ax2 axis(gp_Pnt(30, 20, -1), gp::DZ());
    const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(axis, diameter_mm / 2, thickness_mm + 2).Shape();
    return test::cut(test::box(0, 0, 0, 60, 40, thickness_mm), hole);
}

Plan plannedInShop(const TopoDS_Shape& shape, bool in_parts = true) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.common_ground = in_parts;
    const ToolLibrary library =
        readToolLibrary(std::string(STEPMILL_SOURCE_DIR) + "/samples/shop_metric_tools.json");
    return planPart(test::part(shape), request, library, defaultMachine(), kTol);
}

std::vector<std::string> toolsInSetups(const Plan& plan) {
    std::vector<std::string> tools;
    for (const PlannedSetup& setup : plan.setups)
        for (const Operation& operation : setup.operations)
            tools.push_back(setup.setup.id + " " + operation.tool_id);
    return tools;
}

// Drill of 8: flutes of 50.

TEST(DeepHoles, FlutesThatJustComeThroughWillDo) {
    // The blank may be half a millimetre too high, the drill's point is 2.4 long: 0.1 mm short of coming out
    // as far as drills do.
    EXPECT_EQ(toolsInSetups(plannedInShop(plateWithHole(8, 46.7))), std::vector<std::string>{"S1 DR8"});
}

TEST(DeepHoles, AMillMakesWhatADrillDoesNotReach) {
    EXPECT_EQ(toolsInSetups(plannedInShop(plateWithHole(8, 48))),
              (std::vector<std::string>{"S1 DR8", "S1 EM6L"}));
}

TEST(DeepHoles, AreDrilledBeforeTheyAreMilledWider) {
    // From the full a mill of 4 takes twice as long.
    const gp_Ax2 axis(gp_Pnt(30, 8, -1), gp::DZ());
    const TopoDS_Shape two =
        test::cut(plateWithHole(5.5, 18), BRepPrimAPI_MakeCylinder(axis, 2.75, 20).Shape());
    EXPECT_EQ(toolsInSetups(plannedInShop(two, false)), (std::vector<std::string>{"S1 DR5", "S1 EM4L"}));
}

// Drill of 6: flutes of 34, and no longer mill is as narrow.

TEST(DeepHoles, AreDrilledFromBothSides) {
    const Plan plan = plannedInShop(plateWithHole(6, 33));
    EXPECT_EQ(toolsInSetups(plan), (std::vector<std::string>{"S1 DR6", "S2 DR6"}));
    EXPECT_TRUE(leavesNothing(plan.balance, false, kTol));
}

TEST(DeepHoles, AreDrilledFromBothSidesHoweverMuchElseIsRemoved) {
    const gp_Ax2 axis(gp_Pnt(30, 10, -1), gp::DZ());
    const TopoDS_Shape step =
        test::cut(test::box(0, 0, 0, 120, 100, 45), test::box(-1, 20, 20, 121, 101, 46));
    const Plan plan = plannedInShop(test::cut(step, BRepPrimAPI_MakeCylinder(axis, 3, 47).Shape()));
    const std::vector<std::string> tools = toolsInSetups(plan);
    EXPECT_EQ(
        std::count_if(tools.begin(), tools.end(), [](const auto& tool) { return tool.ends_with("DR6"); }), 2);
    EXPECT_TRUE(leavesNothing(plan.balance, false, kTol));
}

// A gap of 3 mm beside a rib in a pocket of 25 mm: mills of 3 and less are there, and all are too
// short: the holder stays a millimetre over the top.

TEST(DeepGaps, AskForLongerMillsNotForNarrowerOnes) {
    TopoDS_Shape shape = test::cut(test::box(0, 0, 0, 60, 40, 30), test::box(16, 10, 5, 34, 20, 26));
    shape = test::cut(shape, test::box(10, 10, 5, 3, 20, 26));
    const Plan plan = plannedInShop(test::cut(shape, test::box(10, 10, 5, 10, 3, 26)));
    const auto deep = std::find_if(plan.warnings.begin(), plan.warnings.end(), [](const Warning& warning) {
        return warning.text.find("too deep; needs an end mill of 3 mm with a stick-out of 26 mm") !=
               std::string::npos;
    });
    EXPECT_NE(deep, plan.warnings.end());
}

// Of 4 mm one mill is 16 mm long and another, which takes twice as long, 22.

TEST(DeepSlots, AreCutAsFarDownAsTheStiffMillGetsBeforeTheLongOneFollows) {
    const Plan plan =
        plannedInShop(test::cut(test::box(0, 0, 0, 60, 40, 30), test::box(-1, 18, 10, 62, 4, 21)));
    EXPECT_EQ(toolsInSetups(plan), (std::vector<std::string>{"S1 EM4", "S1 EM4L"}));
    EXPECT_TRUE(leavesNothing(plan.balance, false, kTol));
    ASSERT_EQ(plan.setups.front().features.size(), 2U);
    const Feature& above = plan.setups.front().features[0].feature;
    const Feature& below = plan.setups.front().features[1].feature;
    EXPECT_EQ(above.ground_of, std::vector<std::string>{below.id});
    EXPECT_LT(above.depth_mm(), 16) << "clear of the shank on a blank that is too high";
    EXPECT_GT(above.depth_mm(), 14);
    EXPECT_DOUBLE_EQ(above.floor_z_mm, below.top_z_mm);
}

TEST(DeepSlots, AreCutByOneMillWhereThatIsLongEnough) {
    const Plan plan =
        plannedInShop(test::cut(test::box(0, 0, 0, 60, 40, 30), test::box(-1, 18, 16, 62, 4, 15)));
    EXPECT_EQ(toolsInSetups(plan), std::vector<std::string>{"S1 EM4"});
}

// A pocket for wide mills, 30 mm deep, and a channel of 7 mm from it.

TEST(DeepSlots, KeepWhatWideMillsReachAllTheWayDown) {
    const TopoDS_Shape pocket = test::cut(test::box(0, 0, 0, 160, 80, 45), test::box(5, 5, 15, 45, 70, 31));
    const Plan plan = plannedInShop(test::cut(pocket, test::box(49, 30, 15, 100, 7, 31)));
    EXPECT_TRUE(std::any_of(plan.setups.front().features.begin(), plan.setups.front().features.end(),
                            [](const PlannedFeature& planned) {
                                return planned.feature.ground_of.size() == 1 &&
                                       planned.feature.depth_mm() > 29;
                            }));
}

// 60 mm wide: in the lower of its two bands the holder of the mill of 25 would meet the walls at the floor,
// and a face mill goes down to it in 2 mm steps.

TEST(DeepSlots, AreCutInPartsInEveryBand) {
    const Plan plan =
        plannedInShop(test::cut(test::box(0, 0, 0, 40, 80, 80), test::box(-1, 10, 10, 42, 60, 71)));
    EXPECT_EQ(toolsInSetups(plan), (std::vector<std::string>{"S1 EM25", "S1 EM25", "S1 FM50"}));
    EXPECT_TRUE(leavesNothing(plan.balance, false, kTol));
}

// Of 35 mm no drill is there, and all mills but slender ones are too short.

TEST(DeepHoles, AreMilledAsFarDownAsWideMillsGet) {
    const Plan plan = plannedInShop(plateWithHole(35, 70));
    const std::vector<std::string> tools = toolsInSetups(plan);
    EXPECT_GT(tools.size(), 1U);
    EXPECT_TRUE(std::any_of(tools.begin(), tools.end(), [](const std::string& tool) {
        return tool.ends_with("EM25") || tool.ends_with("EM20") || tool.ends_with("EM16");
    }));
}

}  // namespace
}  // namespace stepmill
