// One region over all depths of cut, by the pattern that takes the least time.

#include "toolpath/script/region_cut.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "stepmill/core/units.h"
#include "stepmill/toolpath/path_frame.h"
#include "toolpath/script/visit_order.h"

namespace stepmill::toolpath {

namespace {

/// Less of a ring than this is not worth a move of its own [mm].
constexpr double kLeastLevelMm = 0.01;
/// A pattern is taken for another only where it saves more than rounding.
constexpr double kSavedShare = 1e-6;

double degrees(double angle_rad) {
    return radToDeg(angle_rad);
}

/// Could scripting the depth leave this pass out? Innermost rings may lie in the next ones' ground.
bool mayBeNeedless(const std::vector<Pass>& passes, const Pass& pass) {
    return pass.closed && std::all_of(pass.neighbours.begin(), pass.neighbours.end(), [&](int j) {
               return passes[static_cast<std::size_t>(j)].level < pass.level;
           });
}

/// None needs what another clears, so any order will do.
std::vector<DepthBlock> inShortOrder(std::vector<DepthBlock> blocks) {
    std::vector<Stop> stops;
    for (const DepthBlock& block : blocks)
        stops.push_back({block.begin, block.end});
    std::vector<DepthBlock> ordered;
    for (const std::size_t i : visitOrder(stops))
        ordered.push_back(std::move(blocks[i]));
    return ordered;
}

}  // namespace

bool dips(const ClearingTask& task) {
    return task.top_z_mm - task.floor_z_mm > task.free_reach_mm;
}

bool isQuicker(const PatternTime& one, const PatternTime& other) {
    return one.time_s < other.time_s * (1 - kSavedShare);
}

RegionCutter::RegionCutter(const DepthTask& task, const PassMaker& passes, const Toolpath& frame,
                           double ramp_angle_rad, const Machine& machine)
    : task_(task),
      passes_(passes),
      frame_(frame),
      ramp_angle_rad_(ramp_angle_rad),
      machine_(machine),
      untouched_(task.clearing, task.radius_mm, task.step_over_mm) {}

std::optional<RegionCut> RegionCutter::choose(const RingFamily::Component& component, const Entry& entry,
                                              RegionPatterns& weighed) const {
    std::optional<RegionCut> best;
    const Pattern wanted = task_.clearing.pattern;
    bool stands_in = false;  // the best so far, for a region that may not have what is asked for
    bool lone_ring = false;
    for (std::size_t i = 0; i < component.variants.size(); ++i) {
        const RingFamily::Variant& variant = component.variants[i];
        if (i > 0 && !isAskedFor(task_.clearing, variant.pattern)) continue;
        // Lines in ground that one ring clears are cut in addition to it.
        if (i > 0 && wanted == Pattern::Best && lone_ring) break;
        const std::vector<Pass> passes = passes_.make(component, variant);
        if (passes.empty()) continue;
        lone_ring = i == 0 && passes.size() == 1 && passes.front().closed;
        if (best && !stands_in && wanted == Pattern::Best) {
            const double least = leastTime(passes);
            if (least >= best->time.time_s) {
                weighed.weighed.push_back({variant.pattern, degrees(variant.angle_rad), least, true});
                continue;
            }
        }
        RegionCut made = cut(component, entry, variant, passes);
        if (made.blocks.empty()) continue;
        weighed.weighed.push_back(made.time);
        if (!best || stands_in || isQuicker(made.time, best->time)) best = std::move(made);
        stands_in = !isAskedFor(task_.clearing, variant.pattern);
    }
    if (!best) return best;
    if (wanted != Pattern::Best) weighed.weighed = {best->time};
    std::stable_sort(weighed.weighed.begin(), weighed.weighed.end(),
                     [&](const PatternTime& a, const PatternTime& b) {
                         const bool a_taken = a.pattern == best->time.pattern;
                         const bool b_taken = b.pattern == best->time.pattern;
                         if (a_taken != b_taken) return a_taken;
                         return a.time_s < b.time_s;
                     });
    return best;
}

RegionCut RegionCutter::cut(const RingFamily::Component& component, const Entry& entry,
                            const RingFamily::Variant& variant, const std::vector<Pass>& passes) const {
    RegionCut made;
    DepthScript script = scriptDepth(task_, component, entry, passes);
    if (script.empty()) return made;
    script.apart = inShortOrder(std::move(script.apart));
    if (frame_.slot_feed_mm_per_min > 0) {
        const auto mark = [&](std::span<DepthBlock> blocks) {
            if (blocks.empty()) return;
            Engagement engagement = untouched_;
            for (DepthBlock& block : blocks)
                markWideCuts(block.steps, engagement);
        };
        mark({&script.whole, 1});
        mark(script.apart);
        mark(script.ring_first);
    }
    made.blocks = {std::move(script.whole)};
    made.time = {variant.pattern, degrees(variant.angle_rad), timeOf(made), false};
    // Blocks still to be cut stand beside shank and holder while one is cut deep.
    if (frame_.depths == 1 || dips(task_.clearing)) return made;
    takeIfQuicker(made, std::move(script.apart));
    takeIfQuicker(made, std::move(script.ring_first));
    return made;
}

void RegionCutter::takeIfQuicker(RegionCut& cut, std::vector<DepthBlock> blocks) const {
    if (blocks.empty()) return;
    RegionCut other{std::move(blocks), cut.time};
    other.time.time_s = timeOf(other);
    if (other.time.time_s < cut.time.time_s) cut = std::move(other);
}

double RegionCutter::timeOf(const RegionCut& cut) const {
    Toolpath trial = frame_;
    MoveWriter writer(trial);
    write(cut, Over::Retract, writer);
    writer.retract();
    return measure(trial, machine_).time_s();
}

PatternTime RegionCutter::timed(const RegionCut& cut) const {
    PatternTime time = cut.time;
    time.time_s = timeOf(cut);
    return time;
}

/// Of the passes alone, but for those that may lie in others' ground.
double RegionCutter::leastTime(const std::vector<Pass>& passes) const {
    double length_mm = 0;
    for (const Pass& pass : passes)
        if (!mayBeNeedless(passes, pass)) length_mm += length(pass.path);
    return length_mm * frame_.depths / frame_.feed_mm_per_min * kSecondsPerMinute;
}

double RegionCutter::floorOf(int depth) const {
    return toolpath::floorOf(task_.clearing, frame_, depth);
}

DepthHeights RegionCutter::heights(int from_depth, int to_depth) const {
    const ClearingTask& clearing = task_.clearing;
    return {floorOf(from_depth),
            floorOf(to_depth),
            clearing.floor_z_mm,
            clearing.top_z_mm,
            clearing.retract_z_mm,
            ramp_angle_rad_,
            clearing.retract_z_mm - machine_.safe_height_mm};
}

void RegionCutter::write(const std::vector<RegionCut>& cuts, std::vector<RegionPatterns> weighed,
                         Toolpath& path) const {
    std::vector<Stop> stops;
    stops.reserve(cuts.size());
    for (const RegionCut& cut : cuts)
        stops.push_back({cut.blocks.front().begin, cut.blocks.back().end});
    MoveWriter writer(path);
    for (const std::size_t i : visitOrder(stops)) {
        const Vec2& begin = cuts[i].blocks.front().begin;
        const bool over_top = !path.regions.empty() && task_.standing.isClearForAll(writer.at(), begin);
        write(cuts[i], over_top ? Over::Top : Over::Retract, writer);
        path.regions.push_back(std::move(weighed[i]));
    }
    writer.retract();
}

/// One cut over all depths.
void RegionCutter::write(const RegionCut& cut, Over first_over, MoveWriter& writer) const {
    Over over = first_over;
    for (std::size_t k = 0; k < cut.blocks.size(); ++k) {
        const DepthBlock& block = cut.blocks[k];
        if (k > 0) over = task_.standing.isClearForAll(writer.at(), block.begin) ? Over::Top : Over::Retract;
        if (writeLoneRing(block, over, writer)) continue;
        for (int i = 1; i <= frame_.depths; ++i)
            writer.writeDepth(block.steps, i == 1 ? over : block.next_over, heights(i - 1, i));
    }
}

/// A lone ring is cut on the way down, one depth of cut a turn at most, and levelled on the floor.
bool RegionCutter::writeLoneRing(const DepthBlock& block, Over first_over, MoveWriter& writer) const {
    const auto* ramp = std::get_if<RampAlong>(&block.steps.front());
    const bool only_leaves =
        std::all_of(block.steps.begin() + 1, block.steps.end(),
                    [](const ScriptStep& step) { return std::holds_alternative<Link>(step); });
    if (ramp == nullptr || !ramp->closed || !only_leaves) return false;
    writeDownAlong(ramp->curve, first_over, writer);
    writer.writeDepth({block.steps.begin() + 1, block.steps.end()}, Over::Retract,
                      heights(frame_.depths - 1, frame_.depths));
    return true;
}

void RegionCutter::writeDownAlong(const Path& ring, Over first_over, MoveWriter& writer) const {
    const double turn_mm = length(ring);
    if (turn_mm > task_.rates.descent_mm + kLeastLevelMm) {
        std::vector<DepthHeights> depths;
        for (int i = 1; i <= frame_.depths; ++i)
            depths.push_back(heights(i - 1, i));
        return writer.writeRing(ring, task_.rates.descent_mm, first_over, depths);
    }
    // A turn goes no deeper than one depth of cut.
    const double depth_mm = task_.clearing.top_z_mm - task_.clearing.floor_z_mm + kDescentStartMm;
    const double ramp_slope = std::tan(ramp_angle_rad_);
    const double deepest = frame_.step_down_mm / turn_mm;
    const double slope = task_.rates.may_plunge ? deepest : std::min(ramp_slope, deepest);
    RampAlong down = rampAlong(ring, true, depth_mm / slope);
    if (slope > ramp_slope) down.feed_mm_per_min = helixFeed(task_, turn_mm, slope * turn_mm);
    writer.writeDepth({down}, first_over, heights(0, frame_.depths));
}

}  // namespace stepmill::toolpath
