#include "sequence/dag/candidate.h"
#include "stepmill/core/units.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

double weightOf(const EdgeCost& cost, Objective objective) {
    return objective == Objective::Time ? cost.motion_s : cost.motion_cost;
}

double changeWeight(const Machine& machine, Objective objective) {
    return weightOf(machineCost(machine.tool_change_s, machine), objective);
}

EdgeCost machineCost(double seconds, const Machine& machine) {
    const double cost = machine.costOf(seconds);
    return {seconds, cost, seconds, cost};
}

EdgeCost edgeCost(const PathTotals& totals, const ToolAssembly& tool, const Machine& machine) {
    // Eq. 13: l_m / F_m + l_a / F_r + T_ch. Plunges run at a feed of their own, so the times come from the
    // path and not from its lengths. Eq. 12: machine time at the hourly rate, and the share of the tool's
    // life the cutting uses up.
    EdgeCost result = machineCost(totals.time_s() + machine.tool_change_s, machine);
    // Bounds know feed times only.
    const double motion_s = std::max(totals.time_s(), totals.motion_time_s);
    const EdgeCost motion = machineCost(motion_s + machine.tool_change_s, machine);
    const double wear =
        tool.life_min > 0 ? totals.feed_time_s / kSecondsPerMinute / tool.life_min * tool.price : 0;
    result.cost += wear;
    result.motion_s = motion.time_s;
    result.motion_cost = motion.cost + wear;
    return result;
}

}  // namespace stepmill
