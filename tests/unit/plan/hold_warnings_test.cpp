#include "plan/holding/hold_warnings.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace stepmill {
namespace {

/// A plan with one setup that cuts, held by a vise with so much material between its jaws.
Plan heldInVise(double solid_share) {
    PlannedSetup setup;
    setup.setup.id = "S1";
    setup.clamping.kind = HoldKind::Vise;
    setup.clamping.solid_share = solid_share;
    setup.operations.emplace_back();
    Plan plan;
    plan.setups.push_back(std::move(setup));
    return plan;
}

bool warnsOfHollow(const Plan& plan) {
    const std::vector<Warning> warnings = holdWarnings(plan);
    return std::any_of(warnings.begin(), warnings.end(), [](const Warning& warning) {
        return warning.code == "hollow-grip" && warning.subject == "S1";
    });
}

TEST(HoldWarnings, TellOfJawsOnWallsWithLittleBetweenThem) {
    EXPECT_TRUE(warnsOfHollow(heldInVise(0.53)));
    EXPECT_FALSE(warnsOfHollow(heldInVise(0.8)));
    Plan cuts_nothing = heldInVise(0.2);
    cuts_nothing.setups.front().operations.clear();
    EXPECT_FALSE(warnsOfHollow(cuts_nothing));
}

}  // namespace
}  // namespace stepmill
