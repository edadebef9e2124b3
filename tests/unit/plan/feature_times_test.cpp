#include "stepmill/plan/feature_times.h"

#include <gtest/gtest.h>

#include "stepmill/sequence/tool_dag.h"

namespace stepmill {
namespace {

PlannedFeature bandOf(int number, int count) {
    PlannedFeature band;
    band.feature.id = bandId("S1.F1", number, count);
    if (count > 1) band.feature.band = Band{"S1.F1", number, count};
    band.sequence.least = {{"A"}, {{4}, {kNoEdge}}, {true}};
    return band;
}

/// Takes 3 s, with acceleration 4 s.
Operation operationOn(const PlannedFeature& band, const std::string& tool_id) {
    Operation operation;
    operation.feature_id = band.feature.id;
    operation.tool_id = tool_id;
    operation.path.totals.feed_time_s = 2;
    operation.path.totals.rapid_time_s = 1;
    operation.path.totals.motion_time_s = 4;
    return operation;
}

FeatureTimes timesOf(const std::vector<PlannedFeature>& bands, const std::vector<Operation>& operations) {
    Machine machine;
    machine.tool_change_s = 5;
    return timesOf(wholeFeatures(bands).front(), operations, machine);
}

TEST(FeatureTimes, AreThoseOfItsOwnOperations) {
    const PlannedFeature band = bandOf(1, 1);
    PlannedFeature other;
    other.feature.id = "S1.F2";
    const FeatureTimes times = timesOf({band}, {operationOn(band, "A"), operationOn(other, "C"),
                                                operationOn(band, "B"), operationOn(band, "A")});
    EXPECT_DOUBLE_EQ(times.time_s, 3 * 3 + 3 * 5);
    EXPECT_DOUBLE_EQ(times.motion_s, 3 * 4 + 3 * 5);
    EXPECT_DOUBLE_EQ(times.lower_bound_s, 4 + 5);
}

TEST(FeatureTimes, HaveEachToolChangedToAsOftenAsTheBandThatCallsItMost) {
    const std::vector<PlannedFeature> bands{bandOf(1, 3), bandOf(2, 3), bandOf(3, 3)};
    const FeatureTimes times =
        timesOf(bands, {operationOn(bands[0], "A"), operationOn(bands[1], "A"), operationOn(bands[1], "B"),
                        operationOn(bands[1], "A"), operationOn(bands[2], "B")});
    EXPECT_DOUBLE_EQ(times.time_s, 5 * 3 + 3 * 5) << "A twice and B once";
    EXPECT_DOUBLE_EQ(times.motion_s, 5 * 4 + 3 * 5);
    EXPECT_DOUBLE_EQ(times.lower_bound_s, 3 * 4 + 5) << "A is called once";
}

TEST(FeatureTimes, OfWhatNoToolCutsAreNone) {
    PlannedFeature none;
    none.feature.id = "S1.F1";
    EXPECT_DOUBLE_EQ(timesOf({none}, {}).time_s, 0);
}

}  // namespace
}  // namespace stepmill
