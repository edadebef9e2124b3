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

/// The proposals of one feature.
class DepthSearch {
  public:
    /// \param ids   of its grounds, but for a number
    /// \param next  the first of these numbers
    DepthSearch(const PlannedFeature& planned, const DepthPlanning& from, const std::string& ids,
                std::size_t next, const Tolerances& tol)
        : planned_(planned), from_(from), ids_(ids), next_(next), tol_(tol) {
        for (const SequenceStep& step : planned.sequence.steps)
            all_s_ += step.path.totals.motion_time_s;
    }

    std::vector<DepthProposal> run() {
        std::vector<DepthProposal> found;
        if (!mayBeParted()) return found;
        for (const ToolReach& reach : planned_.sequence.tools)
            propose(reach, found);
        return found;
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

    /// With what wider mills clear cut by itself, or by this mill as well.
    void propose(const ToolReach& reach, std::vector<DepthProposal>& found) {
        const ToolAssembly& tool = from_.library.tool(reach.tool_id);
        if (tool.cuttingFor(from_.material) == nullptr || tool.isForHoles() || !isTooShort(reach)) return;
        if (auto proposal = proposalBeside({}, reach)) found.push_back(std::move(*proposal));
        const Region bulk = coveredByWider(tool);
        if (bulk.empty()) return;
        if (auto proposal = proposalBeside(bulk, reach)) found.push_back(std::move(*proposal));
    }

    /// \param bulk  what of the target other mills clear all the way down before
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
        DepthProposal proposal;
        proposal.gain_s = replaced_s * part_mm / cutMm() - takes_s - from_.change_s;
        if (proposal.gain_s <= leastGainS()) return std::nullopt;
        const Region rest = without(feature().target, bulk);
        if (feature::isSliver(rest, tol_)) return std::nullopt;
        const auto add = [&](const Region& region, double to_z_mm) {
            const std::string id = fmt::format("{}.{}", ids_, next_ + proposal.grounds.size());
            proposal.grounds.push_back({id, {feature().id}, region, to_z_mm});
        };
        if (!bulk.empty()) add(bulk, feature().floor_z_mm);
        add(rest, floor_z_mm);
        return proposal;
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
    const std::string& ids_;
    const std::size_t next_;
    const Tolerances& tol_;
    double all_s_ = 0;
    // Made when first asked for.
    std::optional<FeatureGround> grown_;
    std::optional<LevelTimes> times_;
};

}  // namespace

std::vector<DepthProposal> proposeDepths(const std::vector<PlannedFeature>& nest, const DepthPlanning& from,
                                         const std::string& ids, const Tolerances& tol) {
    const auto known = std::count_if(nest.begin(), nest.end(), [](const PlannedFeature& planned) {
        return !planned.feature.ground_of.empty();
    });
    const std::size_t next = static_cast<std::size_t>(known) + 1;
    std::vector<DepthProposal> all;
    for (const PlannedFeature& planned : nest)
        for (DepthProposal& proposal : DepthSearch(planned, from, ids, next, tol).run())
            all.push_back(std::move(proposal));
    std::stable_sort(all.begin(), all.end(),
                     [](const DepthProposal& a, const DepthProposal& b) { return a.gain_s > b.gain_s; });
    return all;
}

}  // namespace stepmill
