#include "stepmill/plan/feature_times.h"

#include <gtest/gtest.h>

namespace stepmill {
namespace {

/// Its paths take 10 s, with acceleration 12 s; each change of tool 5 s.
PlannedFeature bandBy(const std::vector<std::string>& tools, int number, int count) {
    PlannedFeature band;
    band.feature.id = bandId("S1.F1", number, count);
    if (count > 1) band.feature.band = Band{"S1.F1", number, count};
    for (const std::string& tool : tools)
        band.sequence.steps.emplace_back().tool_id = tool;
    band.sequence.time_s = 10 + 5.0 * static_cast<double>(tools.size());
    band.sequence.motion_s = band.sequence.time_s + 2;
    band.sequence.cutting_bound_s = 4;
    band.sequence.lower_bound_s = 9;
    return band;
}

FeatureTimes timesOf(const std::vector<PlannedFeature>& bands) {
    Machine machine;
    machine.tool_change_s = 5;
    return timesOf(wholeFeatures(bands).front(), machine);
}

TEST(FeatureTimes, OfOneBandAreItsSequences) {
    const FeatureTimes times = timesOf({bandBy({"A", "B", "A"}, 1, 1)});
    EXPECT_DOUBLE_EQ(times.time_s, 25);
    EXPECT_DOUBLE_EQ(times.motion_s, 27);
    EXPECT_DOUBLE_EQ(times.lower_bound_s, 9);
}

TEST(FeatureTimes, HaveEachToolChangedToAsOftenAsTheBandThatCallsItMost) {
    const FeatureTimes times =
        timesOf({bandBy({"A"}, 1, 3), bandBy({"A", "B", "A"}, 2, 3), bandBy({"B"}, 3, 3)});
    EXPECT_DOUBLE_EQ(times.time_s, 3 * 10 + 3 * 5) << "A twice and B once";
    EXPECT_DOUBLE_EQ(times.motion_s, 3 * 12 + 3 * 5);
    EXPECT_DOUBLE_EQ(times.lower_bound_s, 3 * 4 + 5);
}

TEST(FeatureTimes, OfWhatNoToolCutsAreNone) {
    PlannedFeature none;
    none.feature.id = "S1.F1";
    EXPECT_DOUBLE_EQ(timesOf({none}).time_s, 0);
}

}  // namespace
}  // namespace stepmill
