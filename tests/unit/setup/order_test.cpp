// Other orders of setups than the usual one.

#include "setup/order.h"

#include <gtest/gtest.h>

namespace stepmill::test {
namespace {

using setup::SetupTraits;

/// Rests on the stock's own skin, so it may come first.
SetupTraits axisAlong(const Vec3& axis) {
    SetupTraits traits;
    traits.axis = axis;
    traits.seat_mm2 = 100;
    traits.seat_is_stock = true;
    return traits;
}

using Orders = std::vector<std::vector<int>>;

TEST(MachiningOrder, ByLeastStepsPutsAxesThatSpoilOthersWallsLast) {
    using setup::Reach;
    const std::vector<SetupTraits> traits{axisAlong(Vec3::UnitZ()), axisAlong(Vec3::UnitX())};
    // A journal that x finishes and z leaves steps on, and more that only z gets to.
    const std::vector<setup::SampleGroup> groups{{{Reach::Steps, Reach::Finished}, {5, 20}, 0.3, 1, 0.3},
                                                 {{Reach::Finished, Reach::None}, {5, 0}, 0.7, 1, 0.7}};
    EXPECT_EQ(setup::machiningOrder(groups, {0, 1}, traits), (std::vector<int>{0, 1}));
    EXPECT_EQ(setup::machiningOrder(groups, {0, 1}, traits, setup::OrderBy::LeastSteps),
              (std::vector<int>{1, 0}));
}

TEST(OtherOrders, TurnOppositeAxesRoundAndBeginWithTheSecond) {
    const std::vector<SetupTraits> traits{axisAlong(Vec3::UnitZ()), axisAlong(Vec3::UnitX()),
                                          axisAlong(-Vec3::UnitZ()), axisAlong(-Vec3::UnitX())};
    EXPECT_EQ(setup::otherOrders({0}, traits), Orders{});
    EXPECT_EQ(setup::otherOrders({0, 2}, traits), (Orders{{2, 0}}));
    EXPECT_EQ(setup::otherOrders({0, 1}, traits), (Orders{{1, 0}}));
    EXPECT_EQ(setup::otherOrders({0, 1, 2, 3}, traits), (Orders{{1, 0, 2, 3}, {2, 1, 0, 3}, {0, 3, 2, 1}}));
}

TEST(OtherOrders, KeepIndexedAxesAfterTheOthers) {
    std::vector<SetupTraits> traits{axisAlong(Vec3::UnitZ()), axisAlong(Vec3(0.6, 0, 0.8))};
    traits[1].indexed = true;
    EXPECT_EQ(setup::otherOrders({0, 1}, traits), Orders{});
}

TEST(OtherOrders, PutNoAxisBeforeItsSeatIsMachined) {
    std::vector<SetupTraits> traits{axisAlong(Vec3::UnitZ()), axisAlong(Vec3::UnitX())};
    traits[0].seat_is_stock = false;
    // Across the first its seat is a wall there; with nothing flat to rest on it is never ready.
    EXPECT_EQ(setup::otherOrders({0, 1}, traits), (Orders{{1, 0}}));
    traits[0].seat_mm2 = 0;
    EXPECT_EQ(setup::otherOrders({0, 1}, traits), Orders{});
}

}  // namespace
}  // namespace stepmill::test
