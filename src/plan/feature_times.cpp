#include "stepmill/plan/feature_times.h"

#include <algorithm>
#include <map>

#include "plan/order/joint_bound.h"

namespace stepmill {
namespace {

/// How often each tool is changed to.
using Visits = std::map<std::string, int>;

/// Of one band.
struct BandTimes {
    double time_s = 0;  ///< without changes of tools
    double motion_s = 0;
    Visits visits;
};

BandTimes timesOf(const std::string& band_id, const std::vector<Operation>& operations) {
    BandTimes times;
    std::string in_spindle;
    for (const Operation& operation : operations) {
        if (operation.feature_id != band_id) continue;
        times.time_s += operation.timeS();
        times.motion_s += operation.motionS();
        if (operation.tool_id != in_spindle) ++times.visits[operation.tool_id];
        in_spindle = operation.tool_id;
    }
    return times;
}

}  // namespace

LeastTimes leastTimesAsFed(const PlannedFeature& band, const std::vector<Operation>& operations) {
    double pace = 1;
    for (const Operation& operation : operations)
        if (operation.feature_id == band.feature.id) pace = std::max(pace, operation.pace);
    LeastTimes least = band.sequence.least;
    for (std::vector<double>& row : least.cutting_s)
        for (double& cutting_s : row)
            cutting_s /= pace;
    return least;
}

FeatureTimes timesOf(const WholeFeature<PlannedFeature>& feature, const std::vector<Operation>& operations,
                     const Machine& machine) {
    FeatureTimes times;
    Visits most;
    std::vector<LeastTimes> least;
    for (const PlannedFeature* band : feature.bands) {
        const BandTimes own = timesOf(band->feature.id, operations);
        times.time_s += own.time_s;
        times.motion_s += own.motion_s;
        for (const auto& [tool, count] : own.visits)
            most[tool] = std::max(most[tool], count);
        least.push_back(leastTimesAsFed(*band, operations));
    }
    for (const auto& [tool, count] : most) {
        times.time_s += count * machine.tool_change_s;
        times.motion_s += count * machine.tool_change_s;
    }
    times.lower_bound_s = leastTogetherS(least, machine.tool_change_s);
    return times;
}

}  // namespace stepmill
