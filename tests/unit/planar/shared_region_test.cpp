#include "stepmill/planar/shared_region.h"

#include <gtest/gtest.h>

#include "stepmill/core/units.h"

namespace stepmill {
namespace {

TEST(SharedRegion, IsEmptyUntilARegionIsPutInIt) {
    SharedRegion shared;
    EXPECT_TRUE(shared.empty());
    shared = makeCircle(Vec2(0, 0), 5);
    EXPECT_FALSE(shared.empty());
    EXPECT_NEAR(area(shared), 25 * kPi, 1e-6);
}

TEST(SharedRegion, CopiesShareTheLoopsUntilOneIsReplaced) {
    const SharedRegion first = makeRectangle(Vec2(0, 0), Vec2(4, 2));
    SharedRegion second = first;
    EXPECT_EQ(first->loops.data(), second->loops.data());
    second = makeRectangle(Vec2(0, 0), Vec2(1, 1));
    EXPECT_DOUBLE_EQ(area(first), 8);
    EXPECT_DOUBLE_EQ(area(second), 1);
}

}  // namespace
}  // namespace stepmill
