// A path at constant engagement: region by region, depth by depth, bite by bite.

#include "toolpath/adaptive/adaptive_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/toolpath/adaptive_cutting.h"
#include "stepmill/toolpath/path_frame.h"
#include "toolpath/adaptive/adaptive_room.h"
#include "toolpath/adaptive/growth.h"
#include "toolpath/script/region_cut.h"

namespace stepmill::toolpath {
namespace {

/// No adaptive path has been found to take less than this many times what its volume takes alone.
constexpr double kLeastOverVolume = 1.3;
/// A helix narrower than this share of the radius leaves no room to begin in.
constexpr double kLeastHelixShare = 0.1;
/// Ways are clear for cusps of this share of the radius as well as for those of proofs.
constexpr double kThinnerCuspShare = 0.9 * kCuspShare;

/// Area of the target that is not cleared before and that the task's centres reach [mm2].
double areaToClear(const ClearingTask& task, double radius_mm, const Tolerances& tol) {
    const auto reached = [&](const Region& centres) {
        return centres.empty() ? 0 : area(intersect(task.target, offset(centres, radius_mm, tol), tol));
    };
    if (task.cleared_centres.empty()) return reached(task.centres);
    return reached(unite(task.centres, task.cleared_centres, tol)) - reached(task.cleared_centres);
}

/// Makes the cuts of a task's regions.
class AdaptiveCutter {
  public:
    AdaptiveCutter(const DepthTask& task, const RoomFinder& rooms, const CuttingData& cutting,
                   const Machine& machine, double longest_mm)
        : task_(task),
          rooms_(rooms),
          longest_mm_(longest_mm),
          lift_mm_(cutting.adaptive && cutting.adaptive->lift_mm > 0 ? cutting.adaptive->lift_mm
                                                                     : kUsualAdaptiveLiftMm),
          glide_mm_per_min_(glideFeedMmPerMin(machine)) {}

    /// Nothing where the region cannot be cleared so. Without steps where nothing is to be done.
    std::optional<DepthBlock> cut(const RingFamily::Component& component, const Entry& entry) const {
        const AdaptiveRoom found = rooms_.roomOf(component);
        GrowthTask growth;
        growth.room = found.room;
        growth.cleared = found.cleared;
        growth.target = task_.clearing.target;
        growth.radius_mm = task_.radius_mm;
        growth.step_over_mm = task_.step_over_mm;
        growth.at = entry.at;
        growth.longest_mm = longest_mm_;
        DepthBlock block;
        std::optional<Path> circle;
        if (growth.cleared.empty()) {
            circle = helixCircle(component, entry);
            if (!circle) return std::nullopt;
            growth.cleared = {{*circle}};
            growth.at = circle->start;
            block.steps.push_back(rampAlong(*circle, true, task_.rates.descent_mm));
        }
        const auto passes = growthPasses(growth, task_.tol);
        if (!passes) return std::nullopt;
        if (!addPasses(circle, *passes, block)) return std::nullopt;
        if (block.steps.empty()) return block;
        block.begin = beginOf(block.steps.front());
        block.end = passes->empty() ? growth.at : passes->back().path.end();
        if (task_.standing.isClearForAll(block.end, block.begin)) block.next_over = Over::Top;
        return block;
    }

  private:
    static Vec2 beginOf(const ScriptStep& step) {
        if (const auto* ramp = std::get_if<RampAlong>(&step)) return ramp->lead.start;
        return std::get<ComeDown>(step).at;
    }

    /// Counter-clockwise, so that its inside is on the left as of a region.
    std::optional<Path> helixCircle(const RingFamily::Component& component, const Entry& entry) const {
        if (entry.kind != EntryKind::Helix) return std::nullopt;
        const double room_mm = distanceToBoundary(component.region, entry.at);
        const double radius_mm =
            snapToGrid(std::min(entry.helix_radius_mm, room_mm - task_.tol.guard_mm - kGridMm));
        if (radius_mm < kLeastHelixShare * task_.radius_mm) return std::nullopt;
        return makeCircle(snapToGrid(entry.at), radius_mm).loops.front();
    }

    /// False where a pass cannot be come to: skins along walls count as cleared while the passes grow, but
    /// neither glides nor plunges may meet them.
    /// \param circle  of the helix, where the tool comes down by one
    bool addPasses(const std::optional<Path>& circle, const std::vector<GrowthPass>& passes,
                   DepthBlock& block) const {
        const SweptGround before(task_.clearing, task_.radius_mm);
        SweptGround ground = before;
        std::optional<Vec2> at;  // nothing: over the ground
        if (circle) at = sweep(*circle, ground);
        for (const GrowthPass& pass : passes) {
            const Vec2& start = pass.path.start;
            if (at && pass.way && isClear(*at, *pass.way, ground)) {
                block.steps.push_back(Glide{*pass.way, lift_mm_, glide_mm_per_min_});
            } else {
                if (!isClear(start, {start}, ground)) return false;
                block.steps.push_back(ComeDown{start, Over::Retract, before.isClear(start, start)});
            }
            block.steps.push_back(Cut{pass.path});
            at = sweep(pass.path, ground);
        }
        return true;
    }

    static Vec2 sweep(const Path& path, SweptGround& ground) {
        for (const Edge& edge : edgesOf(path))
            ground.add(edge);
        return path.end();
    }

    /// As proofs ask it, and so that what rounding moves changes no answer.
    bool isClear(Vec2 from, const std::vector<Vec2>& way, const SweptGround& ground) const {
        return std::all_of(way.begin(), way.end(), [&](const Vec2& to) {
            const Edge leg = makeLine(std::exchange(from, to), to);
            return ground.isClear(leg) && ground.isClear(leg, kThinnerCuspShare * task_.radius_mm);
        });
    }

    const DepthTask& task_;
    const RoomFinder& rooms_;
    double longest_mm_;
    double lift_mm_;
    double glide_mm_per_min_;
};

}  // namespace

std::optional<Toolpath> adaptivePath(const ClearingTask& task, const RingFamily& family,
                                     const ToolAssembly& tool, const CuttingData& cutting,
                                     const Machine& machine, const Tolerances& tol, double to_beat_s) {
    const double depth_mm = task.top_z_mm - task.floor_z_mm;
    const std::optional<CuttingData> adaptive = adaptiveCutting(tool, cutting, depth_mm);
    if (!adaptive || adaptive->step_over_mm <= 0) return std::nullopt;
    const double r = tool.radius_mm();
    Toolpath path = pathFrame(task, depthsFor(depth_mm, adaptive->step_down_mm), r, *adaptive, machine);
    const double volume_s = areaToClear(task, r, tol) * path.depths /
                            (path.step_over_mm * path.feed_mm_per_min) * kSecondsPerMinute;
    if (kLeastOverVolume * volume_s > to_beat_s) return std::nullopt;
    path.engagement_rad = engagementRad(r, path.step_over_mm);

    const double angle = rampAngle(*adaptive);
    LinkRates rates{};
    rates.descent_mm = (path.step_down_mm + kDescentStartMm) / std::tan(angle);
    const Standing standing(task, r, tol);
    const SweptGround untouched(task, r);
    const DepthTask depth{task, standing, r, path.step_over_mm, rates, untouched, tol};
    const PassMaker passes(task, family, tol);
    const RoomFinder rooms(task, r, passes.isLimited(), tol);
    const Toolpath frame = path;
    const double longest_mm = to_beat_s / kSecondsPerMinute * path.feed_mm_per_min / path.depths;
    const AdaptiveCutter cutter(depth, rooms, *adaptive, machine, longest_mm);
    const RegionCutter regions(depth, passes, frame, angle, machine);
    std::vector<RegionCut> cuts;
    std::vector<RegionPatterns> weighed;
    for (std::size_t i = 0; i < family.components().size(); ++i) {
        const RingFamily::Component& component = family.components()[i];
        if (!passes.concerns(component)) continue;
        std::optional<DepthBlock> block = cutter.cut(component, task.entries[i]);
        if (!block) return std::nullopt;
        if (block->steps.empty()) continue;
        cuts.push_back({{std::move(*block)}, {Pattern::Adaptive, 0, 0, false}});
        weighed.push_back({{regions.timed(cuts.back())}});
    }
    if (cuts.empty()) return std::nullopt;
    regions.write(cuts, std::move(weighed), path);
    path.pattern = toString(Pattern::Adaptive);
    path.totals = measure(path, machine);
    return withClearRapids(path, task, r, machine);
}

}  // namespace stepmill::toolpath
