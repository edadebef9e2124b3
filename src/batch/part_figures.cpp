#include "stepmill/batch/part_figures.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "batch/tool_ways.h"
#include "stepmill/core/units.h"
#include "stepmill/feature/whole_feature.h"

namespace stepmill {
namespace {

/// Reasons that a line of a table has room for.
constexpr std::size_t kReasonsShown = 3;

std::vector<ReasonVolume> largestFirst(const VolumeBalance& books) {
    std::vector<ReasonVolume> stays = books.residual_by_reason;
    stays.insert(stays.end(), books.unreachable_by_reason.begin(), books.unreachable_by_reason.end());
    std::erase_if(stays, [](const ReasonVolume& entry) { return entry.volume_mm3 <= kVolumeRoundingMm3; });
    std::stable_sort(stays.begin(), stays.end(), [](const ReasonVolume& a, const ReasonVolume& b) {
        return a.volume_mm3 > b.volume_mm3;
    });
    return stays;
}

std::string reasonWords(const Plan& plan) {
    std::vector<std::string> words;
    std::vector<ReasonVolume> stays = largestFirst(plan.balance);
    const std::size_t shown = std::min(stays.size(), kReasonsShown);
    for (std::size_t i = 0; i < shown; ++i)
        words.push_back(fmt::format("{} {:.3f} cm3", toString(stays[i].reason), stays[i].volume_mm3 / 1000));
    if (stays.size() > shown) words.push_back(fmt::format("{} more reasons", stays.size() - shown));
    for (const Warning& warning : plan.warnings)
        if (warning.code == "unit-doubt" || warning.code == "input-doubt") words.push_back(warning.text);
    return fmt::format("{}", fmt::join(words, "; "));
}

ToolUse& useOf(const std::string& tool_id, std::vector<ToolUse>& uses) {
    const auto at =
        std::lower_bound(uses.begin(), uses.end(), tool_id,
                         [](const ToolUse& use, const std::string& id) { return use.tool_id < id; });
    if (at != uses.end() && at->tool_id == tool_id) return *at;
    ToolUse use;
    use.tool_id = tool_id;
    return *uses.insert(at, std::move(use));
}

std::vector<ToolUse> usesOf(const Plan& plan) {
    std::vector<ToolUse> uses;
    std::string in_spindle;
    for (const PlannedSetup& setup : plan.setups)
        for (const Operation& operation : setup.operations) {
            const ToolAssembly& tool = plan.library.tool(operation.tool_id);
            ToolUse& use = useOf(tool.id, uses);
            use.diameter_mm = tool.diameter_mm;
            ++use.operations;
            use.visits += in_spindle == tool.id ? 0 : 1;
            in_spindle = tool.id;
            const double feeding_s = operation.path.totals.feed_time_s;
            use.cutting_s += feeding_s + operation.dwellOfAll_s();
            if (tool.life_min > 0) use.life_used += feeding_s / kSecondsPerMinute / tool.life_min;
        }
    return uses;
}

std::vector<ToolTask> tasksOf(const Plan& plan) {
    std::vector<ToolTask> tasks;
    for (const PlannedSetup& setup : plan.setups)
        for (const PlannedFeature& planned : setup.features) {
            ToolTask task;
            task.ways = batch::waysThrough(planned.sequence.edges, plan.objective);
            if (!task.ways.empty()) tasks.push_back(std::move(task));
        }
    return tasks;
}

void addOffers(std::vector<OfferWorth>& to, const std::vector<OfferWorth>& more) {
    for (const OfferWorth& offer : more) {
        const auto at =
            std::lower_bound(to.begin(), to.end(), offer.tool_id,
                             [](const OfferWorth& one, const std::string& id) { return one.tool_id < id; });
        if (at == to.end() || at->tool_id != offer.tool_id) {
            to.insert(at, offer);
            continue;
        }
        at->features += offer.features;
        at->saves_s += offer.saves_s;
        at->saves_cost += offer.saves_cost;
        at->more_mm3 += offer.more_mm3;
    }
}

}  // namespace

PartFigures figuresOf(const Plan& plan, const std::string& report) {
    PartFigures figures;
    figures.size_mm = plan.part.bbox_mm.sizes();
    figures.material = plan.material;
    figures.solids = 1;
    figures.setups = static_cast<int>(plan.setups.size());
    for (const PlannedSetup& setup : plan.setups)
        figures.features += static_cast<int>(wholeFeatures(setup.features).size());
    figures.time_s = plan.totals.time_s;
    figures.motion_s = plan.machine.acceleration_mm_per_s2 > 0 ? plan.totals.motion_s : 0;
    figures.cost = plan.totals.cost;
    figures.currency = plan.machine.currency;
    figures.lower_bound_s = plan.totals.lower_bound_s;
    figures.stock_minus_part_mm3 = plan.balance.stock_minus_part_mm3;
    figures.stays_mm3 = plan.balance.residual_mm3 + plan.balance.unreachable_mm3;
    figures.reason = reasonWords(plan);
    figures.tools = usesOf(plan);
    figures.tasks = tasksOf(plan);
    figures.tasks_in_money = plan.objective == Objective::Cost;
    figures.reports = {report};
    return figures;
}

void addFigures(PartFigures& to, const PartFigures& solid) {
    if (to.solids == 0) {
        to = solid;
        return;
    }
    if (solid.size_mm.prod() > to.size_mm.prod()) {
        to.size_mm = solid.size_mm;
        to.picture = solid.picture;
    }
    to.solids += solid.solids;
    to.setups += solid.setups;
    to.features += solid.features;
    to.time_s += solid.time_s;
    to.motion_s += solid.motion_s;
    to.cost += solid.cost;
    to.lower_bound_s += solid.lower_bound_s;
    to.stock_minus_part_mm3 += solid.stock_minus_part_mm3;
    to.stays_mm3 += solid.stays_mm3;
    if (!solid.reason.empty()) to.reason += (to.reason.empty() ? "" : "; ") + solid.reason;
    to.tasks.insert(to.tasks.end(), solid.tasks.begin(), solid.tasks.end());
    to.reports.insert(to.reports.end(), solid.reports.begin(), solid.reports.end());
    addOffers(to.offers, solid.offers);
    for (const ToolUse& more : solid.tools) {
        ToolUse& use = useOf(more.tool_id, to.tools);
        use.diameter_mm = more.diameter_mm;
        use.operations += more.operations;
        use.visits += more.visits;
        use.cutting_s += more.cutting_s;
        use.life_used += more.life_used;
    }
}

}  // namespace stepmill
