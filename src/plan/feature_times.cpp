#include "stepmill/plan/feature_times.h"

#include <algorithm>
#include <map>

namespace stepmill {
namespace {

/// How often each tool is changed to.
using Visits = std::map<std::string, int>;

Visits visitsOf(const ToolSequence& sequence) {
    Visits visits;
    std::string in_spindle;
    for (const SequenceStep& step : sequence.steps) {
        if (step.tool_id != in_spindle) ++visits[step.tool_id];
        in_spindle = step.tool_id;
    }
    return visits;
}

int sumOf(const Visits& visits) {
    int sum = 0;
    for (const auto& [tool, count] : visits)
        sum += count;
    return sum;
}

}  // namespace

FeatureTimes timesOf(const WholeFeature<PlannedFeature>& feature, const Machine& machine) {
    FeatureTimes times;
    Visits most;
    int changes = 0;
    double change_bound_s = 0;
    for (const PlannedFeature* band : feature.bands) {
        const ToolSequence& sequence = band->sequence;
        times.time_s += sequence.time_s;
        times.motion_s += sequence.motion_s;
        times.lower_bound_s += sequence.cutting_bound_s;
        change_bound_s = std::max(change_bound_s, sequence.lower_bound_s - sequence.cutting_bound_s);
        const Visits visits = visitsOf(sequence);
        changes += sumOf(visits);
        for (const auto& [tool, count] : visits)
            most[tool] = std::max(most[tool], count);
    }
    const double saved_s = (changes - sumOf(most)) * machine.tool_change_s;
    times.time_s -= saved_s;
    times.motion_s -= saved_s;
    times.lower_bound_s += change_bound_s;
    return times;
}

}  // namespace stepmill
