#include "stepmill/planar/wider_than.h"

#include <gtest/gtest.h>

#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

TEST(WiderThan, AStripIsAsWideAsItsShorterSide) {
    const Region strip = makeRectangle({0, 0}, {100, 0.5});
    EXPECT_TRUE(isWiderThan(strip, 0.49, kTol));
    EXPECT_FALSE(isWiderThan(strip, 0.51, kTol));
}

TEST(WiderThan, ARoomAtTheEndOfAStripCounts) {
    const Region room = unite(makeRectangle({0, 0}, {100, 0.1}), makeCircle({100, 0}, 1), kTol);
    EXPECT_TRUE(isWiderThan(room, 1.9, kTol)) << "its area over its perimeter is that of a strip";
    EXPECT_FALSE(isWiderThan(room, 2.1, kTol));
}

TEST(WiderThan, NothingIsNotWide) {
    EXPECT_FALSE(isWiderThan(Region{}, 0.1, kTol));
}

}  // namespace
}  // namespace stepmill
