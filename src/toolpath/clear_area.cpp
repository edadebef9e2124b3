// From areas to a path over all depths of cut.

#include <algorithm>
#include <cmath>

#include "stepmill/core/error.h"
#include "stepmill/toolpath/path_frame.h"
#include "stepmill/toolpath/toolpath.h"
#include "toolpath/adaptive/adaptive_path.h"
#include "toolpath/script/region_cut.h"

namespace stepmill {

namespace {

/// What keeping clear may add to a region's time at most, as a share of it.
constexpr double kRivalShare = 0.01;

/// Where the cutter can go down no way but straight, no depth of cut is more than it may plunge.
CuttingData withinPlunges(const ClearingTask& task, const ToolAssembly& tool, CuttingData cutting) {
    const bool plunges = std::any_of(task.entries.begin(), task.entries.end(),
                                     [](const Entry& entry) { return entry.kind == EntryKind::Plunge; });
    if (plunges && tool.max_plunge_mm > 0 &&
        (cutting.step_down_mm <= 0 || cutting.step_down_mm > tool.max_plunge_mm))
        cutting.step_down_mm = tool.max_plunge_mm;
    return cutting;
}

Toolpath emptyPath(const ClearingTask& task, double radius_mm, const CuttingData& cutting,
                   const Machine& machine) {
    const int depths = toolpath::depthsFor(task.top_z_mm - task.floor_z_mm, cutting.step_down_mm);
    Toolpath path = toolpath::pathFrame(task, depths, radius_mm, cutting, machine);
    path.pattern = toString(Pattern::ContourInsideOut);
    return path;
}

/// Mean length of the approach over ground as deep as the feature. At the last depth all of it is left, at
/// higher depths less.
double deepApproachMm(const Toolpath& path) {
    double sum_mm = 0;
    for (int above = 0; above < path.depths; ++above)
        sum_mm += std::max(0.0, toolpath::kApproachMm - above * path.step_down_mm);
    return sum_mm / path.depths;
}

/// The word for a pattern, with the angle of lines in whole degrees.
std::string patternWord(const PatternTime& time) {
    const bool has_angle = time.pattern == Pattern::Zigzag || time.pattern == Pattern::OneWay;
    if (!has_angle) return toString(time.pattern);
    return toString(time.pattern) + " at " + std::to_string(std::lround(time.angle_deg)) + " deg";
}

std::string patternWords(const std::vector<RegionPatterns>& regions) {
    std::vector<std::string> seen;
    for (const RegionPatterns& region : regions) {
        const std::string word = patternWord(region.weighed.front());
        if (std::find(seen.begin(), seen.end(), word) == seen.end()) seen.push_back(word);
    }
    std::string words;
    for (const std::string& word : seen)
        words += (words.empty() ? "" : " + ") + word;
    return words;
}

/// The regions' cuts one after another, in the order with the shortest ways between them.
void writeRegions(const ClearingTask& task, const RingFamily& family, const toolpath::DepthTask& depth,
                  double angle_rad, const Machine& machine, Toolpath& path) {
    using namespace toolpath;
    const Toolpath frame = path;
    const PassMaker passes(task, family, depth.tol);
    const RegionCutter cutter(depth, passes, frame, angle_rad, machine);
    std::vector<RegionCut> cuts;
    std::vector<RegionPatterns> weighed;
    for (std::size_t i = 0; i < family.components().size(); ++i) {
        const RingFamily::Component& component = family.components()[i];
        RegionPatterns patterns;
        if (!passes.concerns(component)) continue;
        std::optional<RegionCut> cut = cutter.choose(component, task.entries[i], patterns);
        if (!cut) continue;
        cuts.push_back(std::move(*cut));
        weighed.push_back(std::move(patterns));
    }
    if (cuts.empty()) return;
    cutter.write(cuts, std::move(weighed), path);
    path.pattern = patternWords(path.regions);
}

/// Clears the task in depths of cut of no more than the cutting data's step-down.
Toolpath inDepths(const ClearingTask& task, const RingFamily& rings, const ToolAssembly& tool,
                  const CuttingData& cutting, const Machine& machine, const Tolerances& tol) {
    using namespace toolpath;
    Toolpath path = emptyPath(task, tool.radius_mm(), cutting, machine);
    const double angle = rampAngle(cutting);
    const LinkRates rates{(path.step_down_mm + kDescentStartMm) / std::tan(angle),
                          path.feed_mm_per_min,
                          path.plunge_feed_mm_per_min,
                          machine.rapid_mm_per_min,
                          path.step_down_mm + kApproachMm,
                          kApproachMm,
                          deepApproachMm(path),
                          path.ramp_feed_mm_per_min,
                          path.step_down_mm + kDescentStartMm,
                          path.step_down_mm <= tool.max_plunge_mm + kGridMm,
                          ratedRemovalMm3PerMin(cutting),
                          dips(task) ? 1 : path.depths};
    const Standing standing(task, tool.radius_mm(), tol);
    const SweptGround untouched(task, tool.radius_mm());
    const DepthTask depth{task, standing, tool.radius_mm(), path.step_over_mm, rates, untouched, tol};
    writeRegions(task, rings, depth, angle, machine, path);
    path.totals = measure(path, machine);
    return withClearRapids(path, task, tool.radius_mm(), machine);
}

/// The same with the best pattern for each region, or with a close rival in all of them: rapids keep clear
/// after the regions have chosen, which may turn the order round.
Toolpath quickestInDepths(const ClearingTask& task, const RingFamily& rings, const ToolAssembly& tool,
                          const CuttingData& cutting, const Machine& machine, const Tolerances& tol) {
    Toolpath best = inDepths(task, rings, tool, cutting, machine, tol);
    if (task.pattern != Pattern::Best) return best;
    ClearingTask one_pattern = task;
    for (const Pattern pattern : rivalPatterns(best, kRivalShare)) {
        one_pattern.pattern = pattern;
        Toolpath rival = inDepths(one_pattern, rings, tool, cutting, machine, tol);
        if (rival.totals.time_s() < best.totals.time_s()) best = std::move(rival);
    }
    return best;
}

/// Could depths of cut that the tool may plunge take less time? Only where its ramps take longer than the
/// depths that would come in addition.
bool mayPlungeInstead(const Toolpath& path, const ToolAssembly& tool) {
    if (tool.max_plunge_mm <= 0 || path.step_down_mm <= tool.max_plunge_mm) return false;
    double ramps_mm = 0;
    double level_mm = 0;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const double flat_mm = length(Vec2(from.head<2>()), {Vec2(move.to.head<2>()), move.arc});
        if (move.kind == MoveKind::Ramp) ramps_mm += flat_mm;
        if (move.kind == MoveKind::Feed || move.kind == MoveKind::Slot) level_mm += flat_mm;
        from = move.to;
    }
    const double more_depths = path.step_down_mm / tool.max_plunge_mm - 1;
    return ramps_mm / path.ramp_feed_mm_per_min > more_depths * level_mm / path.feed_mm_per_min;
}

Toolpath byRingsAndLines(const ClearingTask& task, const RingFamily& rings, const ToolAssembly& tool,
                         const CuttingData& cutting, const Machine& machine, const Tolerances& tol) {
    const CuttingData usual = withinPlunges(task, tool, cutting);
    Toolpath path = quickestInDepths(task, rings, tool, usual, machine, tol);
    if (!mayPlungeInstead(path, tool)) return path;
    CuttingData shallow = usual;
    shallow.step_down_mm = tool.max_plunge_mm;
    Toolpath plunged = quickestInDepths(task, rings, tool, shallow, machine, tol);
    return plunged.totals.time_s() < path.totals.time_s() ? plunged : path;
}

/// Where the library has a set for it, or it is named: a derived set removes no more in a minute than the
/// usual one, and is hardly ever quicker.
bool mayBeAdaptive(const ClearingTask& task, const CuttingData& cutting) {
    if (task.pattern != Pattern::Best) return task.pattern == Pattern::Adaptive;
    return task.patterns.empty() ? cutting.adaptive.has_value() : isAmong(task.patterns, Pattern::Adaptive);
}

}  // namespace

std::set<Pattern> rivalPatterns(const Toolpath& path, double longer_share) {
    std::set<Pattern> rivals;
    for (const RegionPatterns& region : path.regions)
        for (const PatternTime& weighed : region.weighed)
            if (weighed.pattern != region.weighed.front().pattern &&
                weighed.time_s <= region.weighed.front().time_s * (1 + longer_share))
                rivals.insert(weighed.pattern);
    return rivals;
}

Toolpath clearArea(const ClearingTask& task, const ToolAssembly& tool, const CuttingData& cutting,
                   const Machine& machine, const Tolerances& tol) {
    STEPMILL_CHECK(tool.radius_mm() > 0, "a cutter has a diameter");
    STEPMILL_CHECK(cutting.feed_mm_per_min > 0 && machine.rapid_mm_per_min > 0, "feeds are positive");
    STEPMILL_CHECK(task.retract_z_mm >= task.top_z_mm, "retract height below the material");
    if (task.centres.empty() || task.free_centres.empty() || task.top_z_mm <= task.floor_z_mm)
        return emptyPath(task, tool.radius_mm(), cutting, machine);

    const std::shared_ptr<const RingFamily> rings =
        task.rings ? task.rings : makeRings(task, tool, cutting, tol);
    STEPMILL_CHECK(rings->radiusMm() == tool.radius_mm() &&
                       rings->stepOverMm() == toolpath::usedStepOver(cutting, tool.radius_mm()),
                   "rings of another tool or step-over");
    STEPMILL_CHECK(task.entries.size() == rings->components().size(),
                   "a clearing task has one entry per component of its free centres");
    Toolpath path = byRingsAndLines(task, *rings, tool, cutting, machine, tol);
    if (!mayBeAdaptive(task, cutting)) return path;
    const bool asked =
        task.pattern == Pattern::Adaptive || task.patterns == std::vector<Pattern>{Pattern::Adaptive};
    const double to_beat_s =
        asked || path.moves.empty() ? std::numeric_limits<double>::infinity() : path.totals.motion_time_s;
    std::optional<Toolpath> adaptive =
        toolpath::adaptivePath(task, *rings, tool, cutting, machine, tol, to_beat_s);
    if (!adaptive || adaptive->totals.motion_time_s >= to_beat_s) return path;
    return *std::move(adaptive);
}

}  // namespace stepmill
