#include "plan/totals.h"

#include <algorithm>
#include <set>

#include "stepmill/core/units.h"

namespace stepmill {
namespace {

std::set<std::string> endToolsOf(const ToolSequence& sequence) {
    std::set<std::string> ends;
    for (const DagEdge& edge : sequence.edges) {
        if (edge.to.empty()) ends.insert(edge.from);
    }
    return ends;
}

/// Tools a setup cannot do without: features no two of which can be finished by the same tool.
int unavoidableTools(const PlannedSetup& setup) {
    std::set<std::string> taken;
    int count = 0;
    for (const PlannedFeature& planned : setup.features) {
        if (planned.sequence.steps.empty()) continue;
        const std::set<std::string> ends = endToolsOf(planned.sequence);
        const bool apart = std::none_of(ends.begin(), ends.end(),
                                        [&](const std::string& id) { return taken.count(id) > 0; });
        if (!apart) continue;
        taken.insert(ends.begin(), ends.end());
        ++count;
    }
    return count;
}

/// No cut of the feature is fed higher than this times its cutting data's feed.
double fastestPace(const PlannedSetup& setup, const std::string& feature_id) {
    double pace = 1;
    for (const Operation& operation : setup.operations)
        if (operation.feature_id == feature_id) pace = std::max(pace, operation.pace);
    return pace;
}

/// \param in_spindle  the tool that the setup before ended with; becomes this one's last
void addSetup(const ToolLibrary& library, const Machine& machine, PlannedSetup& setup,
              std::string& in_spindle, PlanTotals& totals) {
    double change_s = 0;
    double cutting_s = 0;
    double air_s = 0;
    double motion_s = 0;
    for (const Operation& operation : setup.operations) {
        const ToolAssembly& tool = library.tool(operation.tool_id);
        if (operation.tool_id != in_spindle) {
            change_s += machine.tool_change_s;
            ++totals.tool_changes;
            in_spindle = operation.tool_id;
        }
        cutting_s += operation.path.totals.feed_time_s + operation.dwellOfAll_s();
        air_s += operation.path.totals.rapid_time_s;
        motion_s += operation.path.totals.motion_time_s + operation.dwellOfAll_s();
        if (tool.life_min > 0)
            totals.cost += operation.path.totals.feed_time_s / kSecondsPerMinute / tool.life_min * tool.price;
    }
    setup.time_s = cutting_s + air_s + change_s;
    setup.motion_s = motion_s + change_s;
    totals.motion_s += setup.motion_s;
    totals.cutting_s += cutting_s;
    totals.air_s += air_s;
    totals.tool_change_s += change_s;
    totals.time_s += setup.time_s;
    totals.cost += setup.time_s / (60 * kSecondsPerMinute) * machine.hourly_rate;
    for (const PlannedFeature& planned : setup.features) {
        if (planned.sequence.steps.empty()) continue;
        totals.lower_bound_s += planned.sequence.cutting_bound_s / fastestPace(setup, planned.feature.id);
    }
}

/// Changes no plan does without: those of every setup, of which each setup's first may be the last tool of
/// the setup before.
int unavoidableChanges(const std::vector<PlannedSetup>& setups) {
    int changes = 0;
    for (const PlannedSetup& setup : setups) {
        const int own = unavoidableTools(setup);
        changes += changes > 0 && own > 0 ? own - 1 : own;
    }
    return changes;
}

}  // namespace

TimedSetups withTimes(std::vector<PlannedSetup> setups, const ToolLibrary& library, const Machine& machine) {
    PlanTotals totals;
    std::string in_spindle;
    for (PlannedSetup& setup : setups)
        addSetup(library, machine, setup, in_spindle, totals);
    totals.lower_bound_s += unavoidableChanges(setups) * machine.tool_change_s;
    return {std::move(setups), totals};
}

}  // namespace stepmill
