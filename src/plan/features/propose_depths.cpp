#include "plan/features/propose_depths.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "plan/features/level_times.h"
#include "stepmill/access/collision.h"
#include "stepmill/access/slivers.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// Gains below this are within the error of the estimate [s], [share of what the feature takes].
constexpr double kLeastPartingS = 2;
constexpr double kLeastPartingShare = 0.05;
/// A part less deep than this is not worth its changes of tools [mm].
constexpr double kLeastPartMm = 1;

struct DepthProposal {
    Region bulk;  ///< what of the target other mills clear all the way down before; may be empty
    Region rest;
    double floor_z_mm = 0;  ///< of the rest's upper part
    double gain_s = 0;
};

/// The best way to part one feature.
class DepthSearch {
  public:
    DepthSearch(const PlannedFeature& planned, const DepthPlanning& from, const Tolerances& tol)
        : planned_(planned), from_(from), tol_(tol) {
        for (const SequenceStep& step : planned.sequence.steps)
            all_s_ += step.path.totals.motion_time_s;
    }

    std::optional<DepthProposal> best() {
        std::optional<DepthProposal> best;
        if (!mayBeParted()) return best;
        for (const ToolReach& reach : planned_.sequence.tools)
            consider(reach, best);
        return best;
    }

  private:
    const Feature& feature() const { return planned_.feature; }

    bool mayBeParted() const {
        return feature().ground_of.empty() && !drills() && cutMm() >= 2 * kLeastPartMm &&
               all_s_ > kLeastPartingS + 2 * from_.change_s;
    }

    /// Holes that a drill makes stay whole; one that only makes room for a mill does so for each part.
    bool drills() const {
        const std::vector<SequenceStep>& steps = planned_.sequence.steps;
        return !steps.empty() && from_.library.tool(steps.back().tool_id).isForHoles();
    }

    /// How deep its steps go: less than the feature where no tool gets down to its floor.
    double cutMm() const { return feature().top_z_mm - planned_.sequence.floor_z_mm; }

    /// What wider mills clear may be cut by itself before, or by this mill as well.
    void consider(const ToolReach& reach, std::optional<DepthProposal>& best) {
        const ToolAssembly& tool = from_.library.tool(reach.tool_id);
        if (tool.cuttingFor(from_.material) == nullptr || tool.isForHoles() || !isTooShort(reach)) return;
        const Region by_wider = coveredByWider(tool);
        for (const Region& bulk : {Region{}, by_wider}) {
            std::optional<DepthProposal> proposal = proposalBeside(bulk, reach);
            if (proposal && (!best || proposal->gain_s > best->gain_s)) best = std::move(proposal);
            if (by_wider.empty()) return;
        }
    }

    std::optional<DepthProposal> proposalBeside(const Region& bulk, const ToolReach& reach) {
        const ToolAssembly& tool = from_.library.tool(reach.tool_id);
        const CuttingData& cutting = *tool.cuttingFor(from_.material);
        const Region own = without(reach.cutter.coverable, bulk);
        if (!times_) times_.emplace(planned_, tol_);
        const double replaced_s = times_->secondsOver(own);
        if (replaced_s <= leastGainS()) return std::nullopt;
        const double floor_z_mm = std::max(floorOf(reach, tool), planned_.sequence.floor_z_mm + kLeastPartMm);
        const double part_mm = feature().top_z_mm - floor_z_mm;
        if (part_mm < kLeastPartMm) return std::nullopt;
        const double takes_s =
            area(own) * secondsPerMm2(planned_, tool, cutting, reach.cutter) * depthsOf(part_mm, cutting);
        const double gain_s = replaced_s * part_mm / cutMm() - takes_s - from_.change_s;
        if (gain_s <= leastGainS()) return std::nullopt;
        Region rest = without(feature().target, bulk);
        if (feature::isSliver(rest, tol_)) return std::nullopt;
        return DepthProposal{bulk, std::move(rest), floor_z_mm, gain_s};
    }

    Region without(const Region& region, const Region& bulk) const {
        return bulk.empty() ? region : access::withoutSliverComponents(subtract(region, bulk, tol_), tol_);
    }

    double leastGainS() const { return std::max(kLeastPartingS, kLeastPartingShare * all_s_); }

    /// Is it kept off for its length alone, at least in part?
    static bool isTooShort(const ToolReach& reach) {
        const Exclusion* excluded = reach.exclusion();
        if (excluded == nullptr) return reach.cutter.coverable_area_mm2 > reach.own().coverable_area_mm2;
        return excluded->reason == ExclusionReason::TooShort ||
               excluded->reason == ExclusionReason::HolderCollision;
    }

    /// What of the target steps of wider tools clear.
    Region coveredByWider(const ToolAssembly& tool) const {
        std::vector<Region> covered;
        for (const SequenceStep& step : planned_.sequence.steps)
            if (from_.library.tool(step.tool_id).diameter_mm > tool.diameter_mm)
                covered.push_back(step.area.area);
        if (covered.empty()) return {};
        return access::withoutSliverComponents(intersect(unite(covered, tol_), feature().target, tol_), tol_);
    }

    /// The lowest floor at which holder and shank are clear of what stands beside and of the feature's own
    /// material, as much as the stock may have of that.
    double floorOf(const ToolReach& reach, const ToolAssembly& tool) {
        if (!grown_) grown_.emplace(onGrownStock(feature(), from_.growth, tol_), tol_);
        const DepthLimit limit = depthLimitOf(*grown_, tool, reach.cutter);
        const double own_z_mm = grown_->feature().top_z_mm - access::freeReachMm(tool);
        return std::max(limit.floor_z_mm + tol_.linear_mm, own_z_mm);
    }

    const PlannedFeature& planned_;
    const DepthPlanning& from_;
    const Tolerances& tol_;
    double all_s_ = 0;
    // Made when first asked for.
    std::optional<FeatureGround> grown_;
    std::optional<LevelTimes> times_;
};

}  // namespace

std::vector<CommonGround> proposeDepths(const std::vector<PlannedFeature>& nest, const DepthPlanning& from,
                                        const std::string& ids, const Tolerances& tol) {
    std::optional<DepthProposal> best;
    const Feature* feature = nullptr;
    std::size_t known = 0;
    for (const PlannedFeature& planned : nest) {
        if (!planned.feature.ground_of.empty()) ++known;
        std::optional<DepthProposal> proposal = DepthSearch(planned, from, tol).best();
        if (!proposal || (best && proposal->gain_s <= best->gain_s)) continue;
        best = std::move(proposal);
        feature = &planned.feature;
    }
    std::vector<CommonGround> grounds;
    if (!best) return grounds;
    const auto add = [&](Region region, double floor_z_mm) {
        grounds.push_back({fmt::format("{}.{}", ids, ++known), {feature->id}, std::move(region), floor_z_mm});
    };
    if (!best->bulk.empty()) add(std::move(best->bulk), feature->floor_z_mm);
    add(std::move(best->rest), best->floor_z_mm);
    return grounds;
}

}  // namespace stepmill
