#include "study/cheaper_features.h"

#include <algorithm>
#include <limits>
#include <set>

#include "stepmill/core/error.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/plan/deep_bands.h"

namespace stepmill {
namespace {

using Whole = WholeFeature<PlannedFeature>;

constexpr std::size_t kMostCostly = 3;
/// Of its depth that a floor is raised by.
constexpr double kDepthShare = 0.2;
/// Of the time that is left after the plan: pages are to be written yet.
constexpr double kTimeShare = 0.8;
/// What a change must save to be worth a word [s].
constexpr double kWorthSavingS = 0.5;

/// What the tools of a feature take alone, its bands together.
struct AloneCost {
    double time_s = 0;
    double cost = 0;
    double stays_mm3 = 0;
    double corners_mm3 = 0;  ///< of what stays: in inner corners
    double smallest_diameter_mm = std::numeric_limits<double>::infinity();
    std::vector<std::string> tools;
    bool cuts = true;  ///< every band is cut
};

/// All that features are sequenced with.
struct QuotingShop {
    const Machine& machine;
    SequenceOptions options;
    const Tolerances& tol;
};

void add(const ToolSequence& sequence, const ToolLibrary& library, AloneCost& to) {
    to.time_s += sequence.time_s;
    to.cost += sequence.cost;
    to.cuts = to.cuts && !sequence.steps.empty();
    for (const Residual& residual : sequence.residual) {
        to.stays_mm3 += residual.volume_mm3;
        if (residual.reason == Reason::CornerRadius) to.corners_mm3 += residual.volume_mm3;
    }
    for (const SequenceStep& step : sequence.steps) {
        to.smallest_diameter_mm = std::min(to.smallest_diameter_mm, library.tool(step.tool_id).diameter_mm);
        if (std::find(to.tools.begin(), to.tools.end(), step.tool_id) == to.tools.end())
            to.tools.push_back(step.tool_id);
    }
}

std::vector<Feature> bandsOf(const Whole& whole) {
    std::vector<Feature> bands;
    for (const PlannedFeature* band : whole.bands)
        bands.push_back(band->feature);
    return bands;
}

AloneCost costOf(const std::vector<Feature>& bands, const ToolLibrary& library, const QuotingShop& shop) {
    AloneCost cost;
    for (const Feature& band : bands)
        add(sequenceTools(band, library, shop.machine, shop.options, shop.tol), library, cost);
    return cost;
}

CheaperChange changeFrom(CheaperChange::Kind kind, const AloneCost& as_is, const AloneCost& changed) {
    CheaperChange change;
    change.kind = kind;
    change.saves_s = as_is.time_s - changed.time_s;
    change.saves_cost = as_is.cost - changed.cost;
    change.tools = changed.tools;
    return change;
}

/// Without the smallest tool and those below it: what stays more must be corners alone.
std::optional<CheaperChange> largerCorners(const std::vector<Feature>& bands, const AloneCost& as_is,
                                           const ToolLibrary& library, const QuotingShop& shop) {
    ToolLibrary larger = library;
    std::erase_if(larger.tools,
                  [&](const ToolAssembly& tool) { return tool.diameter_mm <= as_is.smallest_diameter_mm; });
    const AloneCost changed = costOf(bands, larger, shop);
    const double elsewhere_mm3 =
        (changed.stays_mm3 - changed.corners_mm3) - (as_is.stays_mm3 - as_is.corners_mm3);
    if (!changed.cuts || elsewhere_mm3 > kVolumeRoundingMm3) return std::nullopt;
    if (changed.corners_mm3 <= as_is.corners_mm3) return std::nullopt;
    CheaperChange change = changeFrom(CheaperChange::Kind::LargerCorners, as_is, changed);
    change.from_mm = as_is.smallest_diameter_mm / 2;
    change.to_mm = changed.smallest_diameter_mm / 2;
    return change;
}

/// The lowest band ends higher.
std::optional<CheaperChange> lessDepth(std::vector<Feature> bands, double depth_mm, const AloneCost& as_is,
                                       const ToolLibrary& library, const QuotingShop& shop) {
    Feature& lowest = bands.back();
    const double raise_mm = kDepthShare * depth_mm;
    if (lowest.through || lowest.depth_mm() <= raise_mm) return std::nullopt;
    lowest.volume_mm3 *= 1 - raise_mm / lowest.depth_mm();
    lowest.floor_z_mm += raise_mm;
    const AloneCost changed = costOf(bands, library, shop);
    if (!changed.cuts || changed.stays_mm3 > as_is.stays_mm3 + kVolumeRoundingMm3) return std::nullopt;
    CheaperChange change = changeFrom(CheaperChange::Kind::LessDepth, as_is, changed);
    change.from_mm = depth_mm;
    change.to_mm = depth_mm - raise_mm;
    return change;
}

std::vector<CheaperChange> changesOf(const Whole& whole, const Plan& plan, const QuotingShop& shop) {
    const std::vector<Feature> bands = bandsOf(whole);
    const AloneCost as_is = costOf(bands, plan.library, shop);
    if (!as_is.cuts) return {};
    std::vector<CheaperChange> changes;
    for (const std::optional<CheaperChange>& change :
         {largerCorners(bands, as_is, plan.library, shop),
          lessDepth(bands, whole.depth_mm(), as_is, plan.library, shop)})
        if (change && change->saves_s >= kWorthSavingS) changes.push_back(*change);
    std::stable_sort(changes.begin(), changes.end(),
                     [](const CheaperChange& a, const CheaperChange& b) { return a.saves_s > b.saves_s; });
    return changes;
}

/// Of the band that takes longest.
FeatureBreakEven breakEvenOf(const Feature& band, const Plan& plan, const QuotingShop& shop,
                             Parameter parameter) {
    FeatureBreakEven found;
    found.parameter = parameter;
    found.now = parameter == Parameter::ToolChange ? plan.machine.tool_change_s : plan.machine.hourly_rate;
    for (const BestSequence& best : bestSequences(
             cheapestBySequencing(band, plan.library, plan.machine, shop.options, shop.tol, parameter))) {
        if (best.from > 0 && best.from <= found.now) found.below = best.from;
        if (best.from > found.now && !found.above) found.above = best.from;
    }
    return found;
}

const Feature& longestBand(const Whole& whole) {
    const auto longest = std::max_element(whole.bands.begin(), whole.bands.end(),
                                          [](const PlannedFeature* a, const PlannedFeature* b) {
                                              return a->sequence.time_s < b->sequence.time_s;
                                          });
    return (*longest)->feature;
}

CostlyFeature costlyFeature(const Whole& whole, const Plan& plan, const QuotingShop& shop) {
    CostlyFeature costly;
    costly.id = whole.id();
    costly.feature_class = whole.featureClass();
    costly.depth_mm = whole.depth_mm();
    costly.time_s = whole.sum([](const PlannedFeature& band) { return band.sequence.time_s; });
    costly.cost = whole.sum([](const PlannedFeature& band) { return band.sequence.cost; });
    costly.changes = changesOf(whole, plan, shop);
    for (const Parameter parameter : {Parameter::ToolChange, Parameter::HourlyRate})
        costly.break_evens.push_back(breakEvenOf(longestBand(whole), plan, shop, parameter));
    return costly;
}

std::vector<Whole> costliest(const Plan& plan) {
    std::vector<Whole> all;
    for (const PlannedSetup& setup : plan.setups)
        for (Whole& whole : wholeFeatures(setup.features))
            if (!whole.bands.front()->sequence.steps.empty()) all.push_back(std::move(whole));
    const auto cost = [](const Whole& whole) {
        return whole.sum([](const PlannedFeature& band) { return band.sequence.cost; });
    };
    std::stable_sort(all.begin(), all.end(),
                     [&](const Whole& a, const Whole& b) { return cost(a) > cost(b); });
    all.resize(std::min(all.size(), kMostCostly));
    return all;
}

}  // namespace

std::vector<CostlyFeature> costlyFeatures(const Plan& plan, const Tolerances& tol, const Progress& progress) {
    QuotingShop shop{plan.machine, asPlanned(plan.request.sequence), tol};
    shop.options.deadline = Deadline::in(kTimeShare * plan.request.patience.end.secondsLeft());
    std::vector<CostlyFeature> features;
    for (const Whole& whole : costliest(plan)) {
        if (progress) progress("what would make " + whole.id() + " cheaper", 1);
        try {
            features.push_back(costlyFeature(whole, plan, shop));
        } catch (const Error& error) {
            if (error.code() != ErrorCode::TimedOut) throw;
            break;
        }
    }
    return features;
}

}  // namespace stepmill
