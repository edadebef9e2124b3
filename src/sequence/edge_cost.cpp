#include "sequence/candidate.h"
#include "stepmill/core/units.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

std::string toString(Role role) {
    switch (role) {
        case Role::Face:
            return "face";
        case Role::Rough:
            return "rough";
        case Role::Rest:
            return "rest";
        case Role::Surrogate:
            return "surrogate";
        case Role::Drill:
            return "drill";
    }
    return "rough";
}

EdgeCost machineCost(double seconds, const Machine& machine) {
    return {seconds, seconds / (kSecondsPerMinute * 60) * machine.hourly_rate};
}

EdgeCost edgeCost(const PathTotals& totals, const ToolAssembly& tool, const Machine& machine) {
    // Eq. 13: l_m / F_m + l_a / F_r + T_ch. Plunges run at a feed of their own, so the times come from the
    // path and not from its lengths. Eq. 12: machine time at the hourly rate, and the share of the tool's
    // life the cutting uses up.
    EdgeCost result = machineCost(totals.time_s() + machine.tool_change_s, machine);
    if (tool.life_min > 0) result.cost += totals.feed_time_s / kSecondsPerMinute / tool.life_min * tool.price;
    return result;
}

}  // namespace stepmill
