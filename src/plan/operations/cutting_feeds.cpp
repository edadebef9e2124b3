// Feeds by what the operations cut, once all their moves are final.

#include "plan/operations/cutting_feeds.h"

#include <algorithm>
#include <map>

#include "stepmill/feature/whole_feature.h"
#include "stepmill/plan/grown_feature.h"
#include "stepmill/sequence/machine_limits.h"
#include "stepmill/setup/stock_growth.h"
#include "stepmill/toolpath/adaptive_cutting.h"

namespace stepmill {
namespace {

/// Speed and feeds as many times lower: the chips stay as thick.
void slowDown(Operation& operation, double pace) {
    operation.speed_rpm *= pace;
    Toolpath& path = operation.path;
    for (double* feed : {&path.feed_mm_per_min, &path.plunge_feed_mm_per_min, &path.ramp_feed_mm_per_min,
                         &path.slot_feed_mm_per_min})
        *feed *= pace;
    for (Move& move : path.moves)
        move.feed_mm_per_min *= pace;
}

/// Goes through a setup's operations in their order and keeps what stands of each feature.
class SetupFeeds {
  public:
    SetupFeeds(PlannedSetup& setup, const CuttingFeedSettings& settings, const Paces& paces)
        : setup_(setup),
          settings_(settings),
          paces_(paces),
          growth_(growthOf(setup.setup.stock, setup.setup.part_to_setup)) {
        for (const PlannedFeature& planned : setup.features)
            features_[planned.feature.id] = &planned;
    }

    void set() {
        const bool by_cut =
            settings_.request.sequence.cut_material && !settings_.machine.spindle_curve.empty();
        for (Operation& operation : setup_.operations) {
            const double pace = paceOf(operation);
            if (pace < 1) slow(operation, pace);
            if (!by_cut || operation.role == Role::Form || operation.role == Role::Tap ||
                operation.role == Role::Spot)
                continue;
            CutGround& ground = groundOf(operation.feature_id);
            if (isClearing(operation.role)) feed(operation, ground, pace);
            if (operation.role == Role::Finish) slowInCorners(operation, ground);
            ground.add(operation.path.start, operation.path.moves,
                       settings_.library.tool(operation.tool_id).radius_mm());
        }
    }

  private:
    double paceOf(const Operation& operation) const {
        const auto band = features_.find(operation.feature_id);
        const std::string& whole =
            band != features_.end() ? wholeOf(band->second->feature) : operation.feature_id;
        return paces_.of(setup_.setup.id, whole);
    }

    void slow(Operation& operation, double pace) const {
        // Their speeds and feeds are what threads and fits are proven with on the machine.
        if (operation.role == Role::Tap || isSizing(operation.role)) return;
        slowDown(operation, pace);
        operation.pace = pace;
        operation.path.totals = measure(operation.path, settings_.machine);
    }

    /// What the operation's path was made by.
    static std::optional<CuttingData> cuttingOf(const Operation& operation, const ToolAssembly& tool,
                                                const CuttingData& cutting) {
        const Toolpath& path = operation.path;
        if (path.engagement_rad <= 0) return cutting;
        return adaptiveCutting(tool, cutting, path.depths * path.step_down_mm);
    }

    void feed(Operation& operation, const CutGround& ground, double pace) const {
        const ToolAssembly& tool = settings_.library.tool(operation.tool_id);
        const CuttingData* cutting = tool.cuttingFor(settings_.request.sequence.material);
        if (cutting == nullptr) return;
        const std::optional<CuttingData> used = cuttingOf(operation, tool, *cutting);
        if (!used) return;
        const CuttingData limited = limitedBy(settings_.machine, *used);
        operation.rating =
            CutRating{limited.step_over_mm, limited.step_down_mm, slotStepDownMm(tool, limited),
                      ratedRemovalMm3PerMin(limited) * std::min(1.0, pace)};
        operation.pace = pace;
        const auto model = cuttingModelOf(sheetOf(operation, settings_.library),
                                          *settings_.request.sequence.cut_material, settings_.machine);
        if (!model) {
            operation.pace = std::min(1.0, pace);
            return;
        }
        FedPath fed = withCutFeeds(std::move(operation.path), ground, *model);
        operation.cuts = fed.cuts;
        take(std::move(fed), operation);
    }

    /// A finishing pass is thin enough for its feed but where a corner is hardly rounder than the cutter: the
    /// strip lies all before its front there.
    void slowInCorners(Operation& operation, const CutGround& ground) const {
        const ToolAssembly& tool = settings_.library.tool(operation.tool_id);
        const CuttingData* cutting = tool.cuttingFor(settings_.request.sequence.material);
        if (cutting == nullptr) return;
        std::optional<CuttingFacts> facts =
            cuttingFacts(tool, limitedBy(settings_.machine, *cutting),
                         *settings_.request.sequence.cut_material, settings_.machine);
        if (!facts) return;
        // Thin as it is, it goes no faster than it was told: that makes its surface.
        facts->feed_mm_per_min = facts->max_feed_mm_per_min = operation.path.feed_mm_per_min;
        take(withCutFeeds(std::move(operation.path), ground, CuttingModel(*facts)), operation);
    }

    void take(FedPath fed, Operation& operation) const {
        operation.path = std::move(fed.path);
        operation.path.totals = measure(operation.path, settings_.machine);
        operation.loads = std::move(fed.loads);
    }

    CutGround& groundOf(const std::string& feature_id) {
        const auto known = grounds_.find(feature_id);
        if (known != grounds_.end()) return known->second;
        const CutById by_id = [this](const std::string& id) { return asCut(*features_.at(id)); };
        const GrownTarget found = targetAsFound(features_.at(feature_id)->feature, by_id,
                                                setup_.setup.fixtures, growth_, settings_.tol);
        return grounds_.emplace(feature_id, CutGround(found.region, found.top_z_mm)).first->second;
    }

    PlannedSetup& setup_;
    const CuttingFeedSettings& settings_;
    const Paces& paces_;
    StockGrowth growth_;
    std::map<std::string, const PlannedFeature*> features_;
    std::map<std::string, CutGround> grounds_;
};

}  // namespace

double Paces::of(const std::string& setup, const std::string& feature) const {
    for (const std::string& scope : {feature, setup, std::string()})
        if (const auto found = by_scope_.find(scope); found != by_scope_.end()) return found->second;
    return 1;
}

std::vector<PlannedSetup> withCuttingFeeds(std::vector<PlannedSetup> setups,
                                           const CuttingFeedSettings& settings, const Paces& paces) {
    for (PlannedSetup& setup : setups)
        SetupFeeds(setup, settings, paces).set();
    return setups;
}

}  // namespace stepmill
