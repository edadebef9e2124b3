#include "plan/plan_warnings.h"

#include <fmt/format.h>

#include "stepmill/core/units.h"

namespace stepmill {
namespace {

/// A tool that takes this share of a feature's time or more ...
constexpr double kMuchTimeShare = 0.25;
/// ... for less than this share of its volume is named: removing material so takes five times as long as the
/// average, and leaving it for a hand file, a slimmer holder or another process may be the better answer.
constexpr double kLittleVolumeShare = 0.05;
/// Less time than this on a machine is not worth a word [s].
constexpr double kWorthAWordS = 300;

/// What one tool does in a feature.
struct Share {
    double time_s = 0;
    double area_mm2 = 0;
    bool for_holder = false;  ///< in the place of a tool whose holder is kept off
};

std::string durationWords(double seconds) {
    return fmt::format("{:.0f} min", seconds / kSecondsPerMinute);
}

}  // namespace

std::vector<Warning> slowSteps(const PlannedSetup& setup) {
    std::vector<Warning> warnings;
    for (const PlannedFeature& planned : setup.features) {
        std::map<std::string, Share> shares;
        for (const SequenceStep& step : planned.sequence.steps) {
            // What is asked for is not slow.
            if (step.role == Role::Finish) continue;
            Share& share = shares[step.tool_id];
            share.area_mm2 += step.area.new_area_mm2;
            share.for_holder = share.for_holder || step.role == Role::Surrogate;
        }
        double whole_s = 0;
        for (const Operation& operation : setup.operations) {
            if (operation.feature_id != planned.feature.id || operation.role == Role::Finish) continue;
            shares[operation.tool_id].time_s += operation.timeS();
            whole_s += operation.timeS();
        }
        for (const auto& [tool, share] : shares) {
            const bool slow = share.time_s >= std::max(kWorthAWordS, kMuchTimeShare * whole_s) &&
                              share.area_mm2 < kLittleVolumeShare * planned.feature.area_mm2;
            if (!slow) continue;
            const double depth_mm = planned.feature.top_z_mm - planned.sequence.floor_z_mm;
            warnings.push_back(
                {"slow", planned.feature.id,
                 fmt::format("{} takes {} of {} for {:.2f} of {:.2f} cm3, where no other tool of the library "
                             "is worth calling; {} would save most of it",
                             tool, durationWords(share.time_s), durationWords(whole_s),
                             share.area_mm2 * depth_mm / 1000, planned.feature.volume_mm3 / 1000,
                             share.for_holder ? "a larger tool with a longer stick-out or a slimmer holder"
                                              : "a larger corner radius in the design")});
        }
    }
    return warnings;
}

}  // namespace stepmill
