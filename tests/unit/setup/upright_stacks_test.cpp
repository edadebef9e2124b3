#include "setup/upright_stacks.h"

#include <gtest/gtest.h>

using namespace stepmill;

namespace {
const Tolerances kTol;
}

TEST(UprightStacks, MakeAShaftAndARingOfAPocketInAPocket) {
    const std::vector<Prism> nested = {{makeRectangle(Vec2(0, 0), Vec2(40, 20)), 0, -5},
                                       {makeRectangle(Vec2(0, 0), Vec2(20, 20)), -5, -12},
                                       {makeCircle(Vec2(10, 10), 4), -12, -20}};
    const std::vector<Prism> stacks = setup::uprightStacks(nested, kTol);
    ASSERT_EQ(stacks.size(), 3U);
    EXPECT_NEAR(volumeOf(stacks), volumeOf(nested), 1e-6);
    for (const Prism& prism : stacks)
        EXPECT_EQ(prism.top_z_mm, 0);
}

TEST(UprightStacks, LeaveAlonePrismsThatReachBeyondTheOneAbove) {
    const std::vector<Prism> prisms = {{makeRectangle(Vec2(0, 0), Vec2(20, 20)), 0, -5},
                                       {makeRectangle(Vec2(10, 0), Vec2(30, 20)), -5, -12}};
    const std::vector<Prism> stacks = setup::uprightStacks(prisms, kTol);
    ASSERT_EQ(stacks.size(), 2U);
    EXPECT_EQ(stacks[0].top_z_mm, -5);
    EXPECT_NEAR(volumeOf(stacks), volumeOf(prisms), 1e-9);
}
