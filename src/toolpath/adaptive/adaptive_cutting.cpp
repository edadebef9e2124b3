#include "stepmill/toolpath/adaptive_cutting.h"

#include <algorithm>
#include <cmath>

#include "stepmill/toolpath/cutting_model.h"
#include "stepmill/toolpath/path_frame.h"

namespace stepmill {
namespace {

/// Shares of the diameter. A narrower cut only rubs, a wider one is no light one.
constexpr double kNarrowestShare = 0.05;
constexpr double kWidestShare = 0.25;
/// Halvings of the range in which the step-over is looked for.
constexpr int kWidthHalvings = 40;

/// A tooth's greatest chip, as a share of its feed, in a cut of that share of the diameter.
double greatestChip(double width_share) {
    const double share = std::min(width_share, 0.5);
    return 2 * std::sqrt(share * (1 - share));
}

/// How much faster a cut may be fed that is narrower than the step-over, for chips of the same thickness.
double thinning(double width_share, double step_over_share) {
    return std::clamp(greatestChip(step_over_share) / greatestChip(width_share), 1.0, kMostChipThinning);
}

/// The library's own set.
CuttingData givenSet(const AdaptiveData& set, CuttingData cutting, double depth_mm) {
    cutting.step_over_mm = set.step_over_mm;
    cutting.step_down_mm = depth_mm / toolpath::depthsFor(depth_mm, set.step_down_mm);
    if (set.speed_rpm > 0) cutting.speed_rpm = set.speed_rpm;
    if (set.feed_mm_per_min > 0) cutting.feed_mm_per_min = set.feed_mm_per_min;
    return cutting;
}

}  // namespace

std::vector<Pattern> notAdaptive(std::vector<Pattern> patterns) {
    std::erase(patterns, Pattern::Adaptive);
    if (!patterns.empty()) return patterns;
    return {Pattern::ContourInsideOut, Pattern::ContourOutsideIn, Pattern::StockOffset, Pattern::Zigzag,
            Pattern::OneWay};
}

double glideFeedMmPerMin(const Machine& machine) {
    if (machine.max_feed_mm_per_min <= 0) return machine.rapid_mm_per_min;
    return std::min(machine.max_feed_mm_per_min, machine.rapid_mm_per_min);
}

double engagementRad(double radius_mm, double step_over_mm) {
    return std::acos(1 - step_over_mm / radius_mm);
}

std::optional<CuttingData> adaptiveCutting(const ToolAssembly& tool, const CuttingData& cutting,
                                           double depth_mm) {
    CuttingData adaptive;
    if (cutting.adaptive) {
        adaptive = givenSet(*cutting.adaptive, cutting, depth_mm);
    } else {
        if (cutting.step_over_mm <= 0 || cutting.step_down_mm <= 0 || tool.flute_length_mm <= 0)
            return std::nullopt;
        const int depths = toolpath::depthsFor(depth_mm, tool.flute_length_mm);
        if (depths >= toolpath::depthsFor(depth_mm, cutting.step_down_mm)) return std::nullopt;
        adaptive = cutting;
        adaptive.step_down_mm = depth_mm / depths;
        const double usual_share = cutting.step_over_mm / tool.diameter_mm;
        const double section_share = usual_share * cutting.step_down_mm / adaptive.step_down_mm;
        // The removal rises with the width, thinner chips and all.
        const auto removes = [&](double share) { return share * thinning(share, usual_share); };
        if (removes(kNarrowestShare) > section_share) return std::nullopt;
        double low = kNarrowestShare;
        double high = std::min(kWidestShare, usual_share);
        if (removes(high) <= section_share) low = high;
        for (int i = 0; i < kWidthHalvings && low < high; ++i) {
            const double middle = (low + high) / 2;
            (removes(middle) <= section_share ? low : high) = middle;
        }
        adaptive.step_over_mm = low * tool.diameter_mm;
        adaptive.feed_mm_per_min *= thinning(low, usual_share);
    }
    adaptive.slot_feed_mm_per_min = 0;
    adaptive.rated_removal_mm3_per_min = 0;  // its own step-over, step-down and feed
    adaptive.slot_step_down_mm = std::min(slotStepDownMm(tool, cutting), adaptive.step_down_mm);
    return adaptive;
}

}  // namespace stepmill
