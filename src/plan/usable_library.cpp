// Cutting data no program can be made with on a machine.

#include "stepmill/plan/usable_library.h"

#include <algorithm>

#include <fmt/format.h>

#include "stepmill/catalog/spindle.h"
#include "stepmill/sequence/machine_limits.h"
#include "stepmill/toolpath/path_frame.h"

namespace stepmill {
namespace {

/// Programs tell feeds to a hundredth: slower ones are no feeds any more [mm/min].
constexpr double kSlowestFeedMmPerMin = 1;

double slowestFeed(const CuttingData& cutting) {
    double slowest = cutting.feed_mm_per_min;
    for (const double feed : {cutting.plunge_feed_mm_per_min, cutting.slot_feed_mm_per_min})
        if (feed > 0) slowest = std::min(slowest, feed);
    return slowest;
}

/// The thinnest depth of cut of roughing and of finishing walls.
double thinnestCutMm(const CuttingData& cutting, const FinishAllowance& finish) {
    if (finish.walls_mm <= 0 || cutting.step_over_mm <= 0) return cutting.step_down_mm;
    return std::min(cutting.step_down_mm, cutting.step_over_mm * cutting.step_down_mm / finish.walls_mm);
}

std::string troubleWith(const CuttingData& cutting, const Machine& machine, const FinishAllowance& finish,
                        double deepest_mm) {
    const CuttingData limited = limitedBy(machine, cutting);
    const double slowest = slowestFeed(limited);
    if (slowest < kSlowestFeedMmPerMin)
        return fmt::format("at the {:g} rev/min of {} its feed is {:.2g} mm/min, less than {:g}",
                           limited.speed_rpm, machine.name, slowest, kSlowestFeedMmPerMin);
    const double thinnest_mm = thinnestCutMm(cutting, finish);
    if (thinnest_mm > 0 && deepest_mm > toolpath::kMostDepths * thinnest_mm)
        return fmt::format("cuts of {:.2g} mm would be more than {} over the stock's height of {:.4g} mm",
                           thinnest_mm, toolpath::kMostDepths, deepest_mm);
    return {};
}

}  // namespace

UsableLibrary usableLibrary(const ToolLibrary& library, const SequenceOptions& options,
                            const Machine& machine, double deepest_mm) {
    UsableLibrary usable{library, {}};
    for (ToolAssembly& tool : usable.library.tools) {
        tool = inSpindle(std::move(tool), machine);
        const CuttingData* cutting = tool.cuttingFor(options.material);
        if (cutting == nullptr) continue;
        const std::string trouble = troubleWith(*cutting, machine, options.finish, deepest_mm);
        if (trouble.empty()) continue;
        usable.warnings.push_back(
            {"tool-unusable", tool.id, "not used in " + options.material + ": " + trouble});
        std::erase_if(tool.cutting,
                      [&](const CuttingData& data) { return data.material == options.material; });
    }
    return usable;
}

double tallestStockMm(const std::vector<Setup>& setups) {
    double tallest_mm = 0;
    for (const Setup& setup : setups)
        tallest_mm = std::max(tallest_mm, setup.stock_bbox_mm.sizes().z());
    return tallest_mm;
}

}  // namespace stepmill
