#include "report/plan/over_bound.h"

#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/page/words.h"

namespace stepmill::report {
namespace {

/// Less is rounding [s].
constexpr double kTellS = 0.05;

/// The bound counts what is cleared and drilled, and changes to the tools for it.
double besideBoundS(const Plan& plan) {
    double sum_s = 0;
    for (const PlannedSetup& setup : plan.setups)
        for (const Operation& operation : setup.operations)
            if (!isClearing(operation.role) && operation.role != Role::Drill) sum_s += operation.feedS();
    return sum_s;
}

}  // namespace

std::string overBoundWords(const Plan& plan) {
    const PlanTotals& totals = plan.totals;
    if (totals.lower_bound_s <= 0) return {};
    const double beside_s = besideBoundS(plan);
    const double counted_s = totals.time_s - totals.air_s - beside_s;
    const std::vector<std::pair<double, const char*>> parts = {
        {counted_s - totals.lower_bound_s, "clearing, drilling and tool changes"},
        {beside_s, "finishing, form cutters and the like"},
        {totals.air_s, "rapids"}};
    std::vector<std::string> words;
    for (const auto& [time_s, of] : parts)
        if (time_s >= kTellS) words.push_back(fmt::format("{} of {}", clockTime(time_s), of));
    return fmt::format("over that: {}", fmt::join(words, ", "));
}

}  // namespace stepmill::report
