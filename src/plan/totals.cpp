#include <set>

#include "plan/plan_steps.h"
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

void addSetup(const Plan& plan, PlannedSetup& setup, PlanTotals& totals) {
    double change_s = 0;
    double cutting_s = 0;
    double air_s = 0;
    double motion_s = 0;
    for (std::size_t i = 0; i < setup.operations.size(); ++i) {
        const Operation& operation = setup.operations[i];
        const ToolAssembly& tool = plan.library.tool(operation.tool_id);
        if (changesTool(setup.operations, i)) {
            change_s += plan.machine.tool_change_s;
            ++totals.tool_changes;
        }
        cutting_s += operation.path.totals.feed_time_s + operation.dwell_s;
        air_s += operation.path.totals.rapid_time_s;
        motion_s += operation.path.totals.motion_time_s + operation.dwell_s;
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
    totals.cost += setup.time_s / (60 * kSecondsPerMinute) * plan.machine.hourly_rate;
    for (const PlannedFeature& planned : setup.features) {
        if (!planned.sequence.steps.empty()) totals.lower_bound_s += planned.sequence.cutting_bound_s;
    }
    totals.lower_bound_s += unavoidableTools(setup) * plan.machine.tool_change_s;
}

}  // namespace

void addUpTotals(Plan& plan) {
    PlanTotals totals;
    for (PlannedSetup& setup : plan.setups)
        addSetup(plan, setup, totals);
    plan.totals = totals;
}

}  // namespace stepmill
