#include "access/farthest_room.h"

#include <gtest/gtest.h>

#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"

using namespace stepmill;

namespace {

using test::kTol;
constexpr double kDiscMm = 0.04;
/// How near to each other the bounds come where all of an open side is equally far off, so that the number of
/// squares ends the search [mm].
constexpr double kAlongASideMm = 0.5;

TEST(FarthestRoom, OfASlotLiesInItsMiddle) {
    const Region slot = makeRectangle({-5, 0}, {5, 40});
    const Region block = subtract(makeRectangle({-40, 0}, {40, 60}), slot, kTol);
    const access::FarthestRoom room = access::farthestRoom(slot, block, kDiscMm);
    EXPECT_LE(room.reached_mm, 5);
    EXPECT_GE(room.most_mm, 5);
    EXPECT_LE(room.most_mm - room.reached_mm, 0.2);
}

TEST(FarthestRoom, OfAShoulderIsItsOpenSide) {
    const access::FarthestRoom room =
        access::farthestRoom(makeRectangle({0, 0}, {50, 4}), makeRectangle({0, 4}, {50, 30}), kDiscMm);
    EXPECT_LE(room.reached_mm, 4);
    EXPECT_GE(room.most_mm, 4);
    EXPECT_LE(room.most_mm - room.reached_mm, kAlongASideMm);
}

TEST(FarthestRoom, IsNoneWhereAllOfThePlaceStands) {
    const Region place = makeRectangle({0, 0}, {10, 10});
    const access::FarthestRoom room = access::farthestRoom(place, makeRectangle({-5, -5}, {15, 15}), kDiscMm);
    EXPECT_EQ(room.reached_mm, 0);
    EXPECT_LE(room.most_mm, kAlongASideMm);
    EXPECT_EQ(access::farthestRoom({}, place, kDiscMm).most_mm, 0);
}

}  // namespace
