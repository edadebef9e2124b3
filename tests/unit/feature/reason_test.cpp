#include <gtest/gtest.h>

#include "stepmill/feature/reason.h"

namespace stepmill {
namespace {

TEST(StayReason, OfEveryKindIsReadBackFromItsWords) {
    for (int kind = 0; kind < static_cast<int>(Reason::Unknown); ++kind) {
        const StayReason plain{static_cast<Reason>(kind), {}};
        EXPECT_FALSE(toString(plain).empty()) << kind;
        EXPECT_EQ(stayReasonFrom(toString(plain)), plain) << toString(plain);
    }
}

TEST(StayReason, KeepsItsDetail) {
    EXPECT_EQ(toString(StayReason{Reason::TooDeep, "the tools reach 20 of 30 mm"}),
              "too deep (the tools reach 20 of 30 mm)");
    EXPECT_EQ(toString(StayReason{Reason::BelowStanding, "S1.F2, S1.F3"}),
              "below material that stays in S1.F2, S1.F3");
    for (const Reason kind : {Reason::TooDeep, Reason::BelowStanding, Reason::PlanningFailed}) {
        const StayReason reason{kind, "S1.F2 (EM6)"};
        EXPECT_EQ(stayReasonFrom(toString(reason)), reason);
    }
}

TEST(StayReason, KeepsWordsItDoesNotKnow) {
    const StayReason reason = stayReasonFrom("magnetic north");
    EXPECT_EQ(reason, Reason::Unknown);
    EXPECT_EQ(toString(reason), "magnetic north");
}

}  // namespace
}  // namespace stepmill
