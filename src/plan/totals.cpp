#include "plan/totals.h"

#include <algorithm>

#include "plan/order/joint_bound.h"
#include "stepmill/core/units.h"
#include "stepmill/plan/feature_times.h"

namespace stepmill {
namespace {

/// What the setup's features take at least.
std::vector<LeastTimes> leastTimesOf(const PlannedSetup& setup) {
    std::vector<LeastTimes> features;
    for (const PlannedFeature& planned : setup.features)
        if (!planned.sequence.steps.empty()) features.push_back(leastTimesAsFed(planned, setup.operations));
    return features;
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
        cutting_s += operation.feedS();
        air_s += operation.path.totals.rapid_time_s;
        motion_s += operation.motionS();
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
    totals.cost += machine.costOf(setup.time_s);
}

/// Of every setup, however tools are shared; the first tool of each may be in the spindle from the setup
/// before.
double leastOfAll(const std::vector<PlannedSetup>& setups, const Machine& machine) {
    double least_s = 0;
    for (const PlannedSetup& setup : setups) {
        const double own_s = leastTogetherS(leastTimesOf(setup), machine.tool_change_s);
        least_s += least_s > 0 ? std::max(0.0, own_s - machine.tool_change_s) : own_s;
    }
    return least_s;
}

}  // namespace

TimedSetups withTimes(std::vector<PlannedSetup> setups, const ToolLibrary& library, const Machine& machine) {
    PlanTotals totals;
    std::string in_spindle;
    for (PlannedSetup& setup : setups)
        addSetup(library, machine, setup, in_spindle, totals);
    totals.lower_bound_s = leastOfAll(setups, machine);
    return {std::move(setups), totals};
}

}  // namespace stepmill
