#include "sequence/dag/candidate.h"

#include "stepmill/core/units.h"
#include "stepmill/sequence/advice/area_models.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/machine_limits.h"
#include "stepmill/toolpath/path_frame.h"

namespace stepmill {
namespace {

/// The fastest tools that have any area free of collisions, and so may be surrogates.
struct FastestSurrogates {
    double any = 0;
    double outsider = 0;  ///< of those that are no candidates
};

FastestSurrogates fastestSurrogates(const Feature& feature, const std::vector<ToolReach>& reaches,
                                    const std::vector<Candidate>& candidates, const ToolLibrary& library,
                                    const SequenceOptions& options, const Machine& machine,
                                    const Tolerances& tol) {
    FastestSurrogates fastest;
    for (const ToolReach& reach : reaches) {
        const ToolAssembly& tool = library.tool(reach.tool_id);
        const CuttingData* cutting = tool.cuttingFor(options.material);
        if (cutting == nullptr || tool.isDrill() || reach.collision_free_area_mm2 <= tol.area_mm2) continue;
        const double rate = volumeRate(feature, tool, limitedBy(machine, *cutting));
        const bool listed = std::any_of(candidates.begin(), candidates.end(),
                                        [&](const Candidate& other) { return other.tool == &tool; });
        fastest.any = std::max(fastest.any, rate);
        if (!listed) fastest.outsider = std::max(fastest.outsider, rate);
    }
    return fastest;
}

}  // namespace

double volumeRate(const Feature& feature, const ToolAssembly& tool, const CuttingData& cutting) {
    const double disc_mm2 = kPi * tool.radius_mm() * tool.radius_mm();
    if (tool.isDrill()) {
        const double feed = std::max(cutting.plunge_feed_mm_per_min, cutting.feed_mm_per_min);
        return std::max(disc_mm2, feature.area_mm2) * feed / kSecondsPerMinute;
    }
    const double depth_of_cut =
        feature.depth_mm() / toolpath::depthsFor(feature.depth_mm(), cutting.step_down_mm);
    const double slot_mm2 = tool.diameter_mm * depth_of_cut;
    const double swept = slot_mm2 * cutting.feed_mm_per_min + disc_mm2 * cutting.plunge_feed_mm_per_min;
    return swept / kSecondsPerMinute;
}

CuttingData limitedBy(const Machine& machine, CuttingData cutting) {
    if (cutting.plunge_feed_mm_per_min <= 0) cutting.plunge_feed_mm_per_min = cutting.feed_mm_per_min;
    if (machine.max_speed_rpm > 0 && cutting.speed_rpm > machine.max_speed_rpm) {
        const double slower = machine.max_speed_rpm / cutting.speed_rpm;
        cutting.speed_rpm = machine.max_speed_rpm;
        cutting.feed_mm_per_min *= slower;
        cutting.plunge_feed_mm_per_min *= slower;
        cutting.slot_feed_mm_per_min *= slower;
    }
    if (machine.max_feed_mm_per_min > 0) {
        cutting.feed_mm_per_min = std::min(cutting.feed_mm_per_min, machine.max_feed_mm_per_min);
        cutting.plunge_feed_mm_per_min =
            std::min(cutting.plunge_feed_mm_per_min, machine.max_feed_mm_per_min);
    }
    return cutting;
}

std::vector<const ToolAssembly*> byFallingDiameter(const ToolLibrary& library) {
    std::vector<const ToolAssembly*> tools;
    for (const ToolAssembly& tool : library.tools)
        tools.push_back(&tool);
    std::stable_sort(tools.begin(), tools.end(), [](const ToolAssembly* a, const ToolAssembly* b) {
        if (a->diameter_mm != b->diameter_mm) return a->diameter_mm > b->diameter_mm;
        return a->stick_out_mm < b->stick_out_mm;
    });
    return tools;
}

std::vector<Candidate> usableTools(const Feature& feature, const std::vector<ToolReach>& reaches,
                                   const ToolLibrary& library, const SequenceOptions& options,
                                   const Machine& machine, const Tolerances& tol) {
    std::vector<Candidate> usable;
    for (const ToolReach& reach : reaches) {
        const ToolAssembly& tool = library.tool(reach.tool_id);
        const CuttingData* cutting = tool.cuttingFor(options.material);
        if (cutting == nullptr || reach.exclusion() != nullptr) continue;
        const double coverable = tool.isDrill() ? feature.area_mm2 : reach.cleared().coverable_area_mm2;
        if (coverable <= tol.area_mm2) continue;
        if (tool.isDrill() && !drillCheck(feature, tool, tol).fits) continue;
        const CuttingData limited = limitedBy(machine, *cutting);
        const double rate = volumeRate(feature, tool, limited);
        usable.push_back({&tool, &reach, &reach.cleared(), &reach.own(), limited, coverable, rate, rate});
    }
    const bool any_with_surrogates =
        std::any_of(usable.begin(), usable.end(), [](const Candidate& tool) { return tool.hasSurrogates(); });
    if (!any_with_surrogates) return usable;
    const FastestSurrogates fastest =
        fastestSurrogates(feature, reaches, usable, library, options, machine, tol);
    for (Candidate& tool : usable) {
        if (!tool.hasSurrogates()) continue;
        tool.joint_rate_mm3_per_s = std::max(tool.joint_rate_mm3_per_s, fastest.any);
        tool.outsider_rate_mm3_per_s = fastest.outsider;
    }
    return usable;
}

double sameArea(const Feature& feature, const Tolerances& tol) {
    return std::max(tol.area_mm2, kFullAccessShare * feature.area_mm2);
}

std::vector<bool> endTools(const Feature& feature, const std::vector<Candidate>& tools,
                           const Tolerances& tol) {
    double best = 0;
    for (const Candidate& tool : tools) {
        if (!tool.drill()) best = std::max(best, tool.coverable_mm2);
    }
    const bool milled_whole = best >= feature.area_mm2 - sameArea(feature, tol);
    std::vector<bool> ends;
    for (const Candidate& tool : tools) {
        // A drill's point leaves a cone on a blind floor, so there it ends only what no cutter can
        // finish.
        const bool drill_ends = feature.through || !milled_whole;
        ends.push_back(tool.drill() ? drill_ends : tool.coverable_mm2 >= best - sameArea(feature, tol));
    }
    return ends;
}

}  // namespace stepmill
