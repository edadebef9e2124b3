#include "sequence/dag/candidate.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/units.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/sequence/advice/area_models.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/machine_limits.h"
#include "stepmill/sequence/spotting.h"
#include "stepmill/toolpath/adaptive_cutting.h"
#include "stepmill/toolpath/cutting_model.h"
#include "stepmill/toolpath/path_frame.h"

namespace stepmill {
namespace {

/// The fastest tools that have any area free of collisions, and so may be surrogates.
struct FastestSurrogates {
    double any = 0;
    double outsider = 0;         ///< of those that are no candidates
    double outsider_as_cut = 0;  ///< the same at feeds by what is cut
};

/// No more goes in a second where feeds follow from what is cut: of a mill what it is rated for, or what it
/// plunges through. Of others, and where feeds are the library's, the volume rate.
double rateAsCut(const Feature& feature, const ToolAssembly& tool, const CuttingData& cutting,
                 const SequenceOptions& options, const Machine& machine) {
    const double most = volumeRate(feature, tool, cutting);
    if (tool.isForHoles() || !options.cut_material || machine.spindle_curve.empty()) return most;
    double rated = ratedRemovalMm3PerMin(cutting);
    if (const auto adaptive = adaptiveCutting(tool, cutting, feature.depth_mm()))
        rated = std::max(rated, ratedRemovalMm3PerMin(*adaptive));
    const double disc_mm2 = kPi * tool.radius_mm() * tool.radius_mm();
    if (tool.max_plunge_mm > 0) rated = std::max(rated, disc_mm2 * cutting.plunge_feed_mm_per_min);
    return std::min(most, rated / kSecondsPerMinute);
}

FastestSurrogates fastestSurrogates(const Feature& feature, const std::vector<ToolReach>& reaches,
                                    const std::vector<Candidate>& candidates, const ToolLibrary& library,
                                    const SequenceOptions& options, const Machine& machine,
                                    const Tolerances& tol) {
    FastestSurrogates fastest;
    for (const ToolReach& reach : reaches) {
        const ToolAssembly& tool = library.tool(reach.tool_id);
        const CuttingData* cutting = tool.cuttingFor(options.material);
        if (cutting == nullptr || tool.isForHoles() || reach.collision_free_area_mm2 <= tol.area_mm2)
            continue;
        const double rate = volumeRate(feature, tool, limitedBy(machine, *cutting));
        const bool listed = std::any_of(candidates.begin(), candidates.end(),
                                        [&](const Candidate& other) { return other.tool == &tool; });
        fastest.any = std::max(fastest.any, rate);
        if (listed) continue;
        fastest.outsider = std::max(fastest.outsider, rate);
        fastest.outsider_as_cut =
            std::max(fastest.outsider_as_cut,
                     rateAsCut(feature, tool, limitedBy(machine, *cutting), options, machine));
    }
    return fastest;
}

/// Milled walls get their finishing pass; a drill before the mill would keep it from them.
bool mayPreDrill(const Feature& feature, const ToolAssembly& drill, const SequenceOptions& options,
                 const Tolerances& tol) {
    if (options.cost_model != CostModel::Path || !preDrills(feature, drill, tol)) return false;
    return !options.finish.any() || isOfSize(feature, drill, tol);
}

/// Of the usual cutting data and of those at constant engagement the faster along walls.
double wallRate(const Feature& feature, const ToolAssembly& tool, const CuttingData& cutting) {
    const auto rate = [&](const CuttingData& data) {
        return data.feed_mm_per_min / toolpath::depthsFor(feature.depth_mm(), data.step_down_mm) /
               kSecondsPerMinute;
    };
    const auto adaptive = adaptiveCutting(tool, cutting, feature.depth_mm());
    return adaptive ? std::max(rate(cutting), rate(*adaptive)) : rate(cutting);
}

/// \pre  it mills, without surrogates
void touchWalls(const Feature& feature, const Walls& walls, Candidate& candidate) {
    candidate.walls = walls.touchedBy(*candidate.own);
    candidate.wall_rate_mm_per_s = wallRate(feature, *candidate.tool, candidate.cutting);
}

/// What a tool takes part with: nothing for a drill that neither makes the hole nor makes room for a mill.
std::optional<Candidate> candidateOf(const Feature& feature, const Walls& walls, const ToolAssembly& tool,
                                     const ToolReach& reach, const CuttingData& cutting,
                                     const SequenceOptions& options, const Machine& machine,
                                     const Tolerances& tol) {
    Candidate candidate;
    candidate.tool = &tool;
    candidate.reach = &reach;
    candidate.cleared = &reach.cleared();
    candidate.own = &reach.own();
    candidate.cutting = cutting;
    candidate.coverable_mm2 = reach.cleared().coverable_area_mm2;
    candidate.volume_rate_mm3_per_s = candidate.joint_rate_mm3_per_s = volumeRate(feature, tool, cutting);
    candidate.rate_as_cut_mm3_per_s = rateAsCut(feature, tool, cutting, options, machine);
    if (tool.isSpot()) {
        candidate.spots = options.cost_model == CostModel::Path && spotFits(feature, tool);
        return candidate.spots ? std::optional(candidate) : std::nullopt;
    }
    if (tool.isDrill()) {
        candidate.predrills = mayPreDrill(feature, tool, options, tol);
        const bool makes = drillCheck(feature, tool, tol).fits;
        if (!makes && !candidate.predrills) return std::nullopt;
        if (makes) candidate.coverable_mm2 = feature.area_mm2;
    }
    if (candidate.coverable_mm2 <= tol.area_mm2) return std::nullopt;
    if (candidate.mills() && !candidate.hasSurrogates()) touchWalls(feature, walls, candidate);
    return candidate;
}

/// The tool of a candidate with surrogates by itself.
Candidate aloneOf(const Feature& feature, const Walls& walls, Candidate candidate) {
    candidate.alone = true;
    candidate.cleared = candidate.own;
    candidate.coverable_mm2 = candidate.own->coverable_area_mm2;
    touchWalls(feature, walls, candidate);
    return candidate;
}

/// Of the drills that make room the widest stays, as the first tool; none where no mill can end the feature.
void keepOnePreDrill(const Feature& feature, const Tolerances& tol, std::vector<Candidate>& tools) {
    const bool milled_whole = std::any_of(tools.begin(), tools.end(), [&](const Candidate& tool) {
        return tool.mills() && tool.coverable_mm2 >= feature.area_mm2 - sameArea(feature, tol);
    });
    const bool plain =
        std::none_of(tools.begin(), tools.end(), [](const Candidate& tool) { return tool.hasSurrogates(); });
    std::optional<Candidate> widest;
    for (Candidate& tool : tools) {
        if (!tool.predrills) continue;
        if (milled_whole && plain && !widest) widest = tool;
        tool.predrills = false;
    }
    std::erase_if(tools, [&](const Candidate& tool) {
        if (widest && tool.tool == widest->tool) return true;
        return tool.drill() && !drillCheck(feature, *tool.tool, tol).fits;
    });
    if (widest) tools.insert(tools.begin(), *widest);
}

/// Spot drills come before all others; none where no drill wants one.
void putSpotsFirst(std::vector<Candidate>& tools) {
    const bool wanted =
        std::any_of(tools.begin(), tools.end(), [](const Candidate& tool) { return tool.wantsSpot(); });
    if (!wanted) std::erase_if(tools, [](const Candidate& tool) { return tool.spots; });
    std::stable_partition(tools.begin(), tools.end(), [](const Candidate& tool) { return tool.spots; });
}

/// Most that a mill removes in a minute [mm3], along the level or the best slope it may take: any, where it
/// may plunge.
double mostRemoved(const ToolAssembly& tool, const CuttingData& data, double front_mm2) {
    const double disc_mm2 = kPi * tool.radius_mm() * tool.radius_mm();
    const double feed = data.feed_mm_per_min;
    const double sink = std::min(feed, data.plunge_feed_mm_per_min);
    const auto along = [&](double angle_rad) {
        const double per_mm = front_mm2 * std::cos(angle_rad) + disc_mm2 * std::sin(angle_rad);
        return per_mm * (angle_rad > 0 ? rampFeed(feed, sink, angle_rad) : feed);
    };
    // It rises up to the slope at which the sinking holds the feed back, or at which the way is best, and
    // falls from there on.
    const double best_rad = std::min(std::asin(sink / feed), std::atan2(disc_mm2, front_mm2));
    if (tool.max_plunge_mm > 0) return std::max(along(best_rad), disc_mm2 * sink);
    return along(std::min(best_rad, toolpath::rampAngle(data)));
}

}  // namespace

double leastWallS(const Candidate* from, const Candidate& to) {
    if (to.wall_rate_mm_per_s <= 0 || (from != nullptr && from->hasSurrogates())) return 0;
    const double new_mm = from != nullptr ? to.walls.least_mm - from->walls.most_mm
                                          : to.walls.least_mm + to.walls.hollow_least_mm;
    // Narrow cuts may be fed faster than the cutting data say.
    return std::max(0.0, new_mm) / (kMostChipThinning * to.wall_rate_mm_per_s);
}

double volumeRate(const Feature& feature, const ToolAssembly& tool, const CuttingData& cutting) {
    if (tool.isSpot()) return 0;  // it clears no ground
    if (tool.isDrill()) {
        const double disc_mm2 = kPi * tool.radius_mm() * tool.radius_mm();
        const double feed = std::max(cutting.plunge_feed_mm_per_min, cutting.feed_mm_per_min);
        return std::max(disc_mm2, feature.area_mm2) * feed / kSecondsPerMinute;
    }
    const auto swept = [&](const CuttingData& data, double width_mm) {
        const double depth_of_cut =
            feature.depth_mm() / toolpath::depthsFor(feature.depth_mm(), data.step_down_mm);
        return mostRemoved(tool, data, width_mm * depth_of_cut);
    };
    double most = swept(cutting, tool.diameter_mm);
    // A derived set removes no more than the usual one.
    if (cutting.adaptive)
        if (const auto adaptive = adaptiveCutting(tool, cutting, feature.depth_mm()))
            most = std::max(most, swept(*adaptive, adaptive->step_over_mm));
    return most / kSecondsPerMinute;
}

CuttingData limitedBy(const Machine& machine, CuttingData cutting) {
    if (cutting.plunge_feed_mm_per_min <= 0) cutting.plunge_feed_mm_per_min = cutting.feed_mm_per_min;
    if (machine.max_speed_rpm > 0 && cutting.speed_rpm > machine.max_speed_rpm) {
        const double slower = machine.max_speed_rpm / cutting.speed_rpm;
        cutting.speed_rpm = machine.max_speed_rpm;
        cutting.feed_mm_per_min *= slower;
        cutting.plunge_feed_mm_per_min *= slower;
        cutting.slot_feed_mm_per_min *= slower;
        cutting.rated_removal_mm3_per_min *= slower;
        if (cutting.adaptive && cutting.adaptive->speed_rpm <= 0) cutting.adaptive->feed_mm_per_min *= slower;
    }
    if (cutting.adaptive && machine.max_speed_rpm > 0 &&
        cutting.adaptive->speed_rpm > machine.max_speed_rpm) {
        cutting.adaptive->feed_mm_per_min *= machine.max_speed_rpm / cutting.adaptive->speed_rpm;
        cutting.adaptive->speed_rpm = machine.max_speed_rpm;
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
    const Walls walls(feature, tol);
    std::vector<Candidate> usable;
    for (const ToolReach& reach : reaches) {
        const ToolAssembly& tool = library.tool(reach.tool_id);
        const CuttingData* cutting = tool.cuttingFor(options.material);
        if (cutting == nullptr || reach.exclusion() != nullptr) continue;
        const CuttingData limited = limitedBy(machine, *cutting);
        auto candidate = candidateOf(feature, walls, tool, reach, limited, options, machine, tol);
        if (!candidate) continue;
        if (candidate->hasSurrogates() && options.surrogates != SurrogateRule::Single)
            usable.push_back(aloneOf(feature, walls, *candidate));
        usable.push_back(std::move(*candidate));
    }
    if (isHole(feature.feature_class)) {
        // In a hole wider by less than a sliver a mill has no way that sweeps anything.
        std::erase_if(usable, [&](const Candidate& tool) {
            return tool.mills() && holeRadiusMm(feature) - tool.tool->radius_mm() < tol.sliver_mm;
        });
        keepOnePreDrill(feature, tol, usable);
        putSpotsFirst(usable);
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
        tool.outsider_rate_as_cut_mm3_per_s = fastest.outsider_as_cut;
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
        if (tool.mills()) best = std::max(best, tool.coverable_mm2);
    }
    const bool milled_whole = best >= feature.area_mm2 - sameArea(feature, tol);
    // A hole that a drill makes is drilled, though a mill that is called anyway may save its tool change: it
    // is rounder, and end mills last. No mill makes a point.
    const bool drilled = (feature.through || feature.point_mm > 0) &&
                         std::any_of(tools.begin(), tools.end(),
                                     [](const Candidate& tool) { return tool.drill() && !tool.predrills; });
    std::vector<bool> ends;
    for (const Candidate& tool : tools) {
        // A drill's point leaves a cone on a flat floor, so there it ends only what no cutter can finish.
        const bool drill_ends = !tool.predrills && (drilled || !milled_whole);
        const bool mill_ends =
            tool.mills() && !drilled && tool.coverable_mm2 >= best - sameArea(feature, tol);
        ends.push_back(tool.drill() ? drill_ends : mill_ends);
    }
    return ends;
}

}  // namespace stepmill
