#include <gtest/gtest.h>

#include "stepmill/plan/warning_order.h"

namespace stepmill {
namespace {

TEST(ByConsequence, PutsTheGravestFirstAndKeepsTheOrderOfEquals) {
    const std::vector<Warning> sorted = byConsequence({{"section", "S1", "a"},
                                                       {"slow", "S1.F1", "b"},
                                                       {"residual", "S1.F2", "c"},
                                                       {"residual", "S1.F1", "d"},
                                                       {"travel", "S2", "e"}});
    std::string texts;
    for (const Warning& warning : sorted)
        texts += warning.text;
    EXPECT_EQ(texts, "ecdba");
}

TEST(ByConsequence, MakesOneWithACountOfThoseAlike) {
    const std::vector<Warning> grouped = byConsequence({{"no-allowance", "S1.F1", "too thin"},
                                                        {"no-allowance", "S1.F2", "too thin"},
                                                        {"slow", "S1.F2", "x"}});
    ASSERT_EQ(grouped.size(), 2U);
    EXPECT_EQ(grouped[0].subject, "S1.F1");
    EXPECT_EQ(grouped[0].count, 2);
    EXPECT_EQ(grouped[1].count, 1);
}

TEST(ByConsequence, JoinsWithinASetupAndOfToolsAlone) {
    const std::vector<Warning> grouped = byConsequence({{"taped", "S1", "by tape"},
                                                        {"taped", "S2", "by tape"},
                                                        {"deflection", "S2.O1", "bends"},
                                                        {"deflection", "S2.O3", "bends"},
                                                        {"tool-unusable", "EM6", "too thin"},
                                                        {"tool-unusable", "EM8", "too thin"}});
    ASSERT_EQ(grouped.size(), 4U);
    EXPECT_EQ(setupOf(grouped[0]), "S1");
    EXPECT_EQ(setupOf(grouped[1]), "S2");
    EXPECT_EQ(grouped[2].count, 2);
}

TEST(SetupOf, IsWhatAnIdBeginsWith) {
    EXPECT_EQ(setupOf({"slow", "S12.F2.3", ""}), "S12");
    EXPECT_EQ(setupOf({"slow", "part.step", ""}), "");
    EXPECT_EQ(setupOf({"slow", "S", ""}), "");
    EXPECT_EQ(setupOf({"slow", "Saw7", ""}), "");
}

TEST(ByConsequence, LeavesEverySetupItsTravel) {
    EXPECT_EQ(byConsequence({{"travel", "S1", "too long"}, {"travel", "S2", "too long"}}).size(), 2U);
}

TEST(IsWithinTravel, AsksTheWarnings) {
    Plan plan;
    plan.warnings = {{"travel", "S2", "too long"}, {"slow", "S1", "x"}};
    EXPECT_TRUE(isWithinTravel(plan, "S1"));
    EXPECT_FALSE(isWithinTravel(plan, "S2"));
}

}  // namespace
}  // namespace stepmill
