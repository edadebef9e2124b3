#include "stepmill/core/groups.h"

#include <gtest/gtest.h>

namespace stepmill {
namespace {

TEST(Groups, AreNamedByTheirLeastMember) {
    Groups groups(6);
    groups.join(5, 3);
    groups.join(3, 4);
    EXPECT_EQ(groups.of(4), 3U);
    EXPECT_EQ(groups.of(5), 3U);
    EXPECT_EQ(groups.of(2), 2U);
    groups.join(4, 1);
    EXPECT_EQ(groups.of(5), 1U);
    EXPECT_EQ(static_cast<const Groups&>(groups).of(3), 1U);
}

TEST(Groups, GrowByNumbersOnTheirOwn) {
    Groups groups;
    groups.grow(2);
    groups.join(0, 1);
    groups.grow(4);
    EXPECT_EQ(groups.of(1), 0U);
    EXPECT_EQ(groups.of(2), 2U);
    EXPECT_EQ(groups.of(3), 3U);
}

}  // namespace
}  // namespace stepmill
