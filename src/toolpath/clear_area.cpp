// From areas to a path over all depths of cut.

#include <algorithm>
#include <cmath>

#include "stepmill/core/error.h"
#include "stepmill/toolpath/path_frame.h"
#include "stepmill/toolpath/toolpath.h"
#include "toolpath/script/region_cut.h"
#include "toolpath/script/visit_order.h"

namespace stepmill {

namespace {

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
    std::vector<Stop> stops;
    for (std::size_t i = 0; i < family.components().size(); ++i) {
        const RingFamily::Component& component = family.components()[i];
        RegionPatterns patterns;
        if (!passes.concerns(component)) continue;
        std::optional<RegionCut> cut = cutter.choose(component, task.entries[i], patterns);
        if (!cut) continue;
        stops.push_back({cut->blocks.front().begin, cut->blocks.back().end});
        cuts.push_back(std::move(*cut));
        weighed.push_back(std::move(patterns));
    }
    if (cuts.empty()) return;
    MoveWriter writer(path);
    for (const std::size_t i : visitOrder(stops)) {
        const bool over_top =
            !path.regions.empty() && depth.standing.isClearForAll(writer.at(), cuts[i].blocks.front().begin);
        cutter.write(cuts[i], over_top ? Over::Top : Over::Retract, writer);
        path.regions.push_back(std::move(weighed[i]));
    }
    writer.retract();
    path.pattern = patternWords(path.regions);
}

}  // namespace

Toolpath clearArea(const ClearingTask& task, const ToolAssembly& tool, const CuttingData& cutting,
                   const Machine& machine, const Tolerances& tol) {
    STEPMILL_CHECK(tool.radius_mm() > 0, "a cutter has a diameter");
    STEPMILL_CHECK(cutting.feed_mm_per_min > 0 && machine.rapid_mm_per_min > 0, "feeds are positive");
    STEPMILL_CHECK(task.retract_z_mm >= task.top_z_mm, "retract height below the material");
    Toolpath path = emptyPath(task, tool.radius_mm(), cutting, machine);
    if (task.centres.empty() || task.free_centres.empty() || task.top_z_mm <= task.floor_z_mm) return path;

    using namespace toolpath;
    const std::shared_ptr<const RingFamily> rings =
        task.rings ? task.rings : makeRings(task, tool, cutting, tol);
    STEPMILL_CHECK(rings->radiusMm() == tool.radius_mm() && rings->stepOverMm() == path.step_over_mm,
                   "rings of another tool or step-over");
    STEPMILL_CHECK(task.entries.size() == rings->components().size(),
                   "a clearing task has one entry per component of its free centres");
    const double angle = rampAngle(cutting);
    const LinkRates rates{(path.step_down_mm + kDescentStartMm) / std::tan(angle),
                          path.feed_mm_per_min,
                          path.plunge_feed_mm_per_min,
                          machine.rapid_mm_per_min,
                          path.step_down_mm + kApproachMm,
                          kApproachMm,
                          deepApproachMm(path)};
    const Standing standing(task, tool.radius_mm(), tol);
    const DepthTask depth{task, standing, tool.radius_mm(), path.step_over_mm, rates, tol};
    writeRegions(task, *rings, depth, angle, machine, path);
    path.totals = measure(path, machine);
    return path;
}

}  // namespace stepmill
