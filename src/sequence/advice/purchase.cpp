#include "stepmill/sequence/advice/purchase.h"

#include <tuple>

#include "sequence/advice/trial_tools.h"
#include "sequence/dag/candidate.h"
#include "sequence/holder/tool_areas.h"
#include "stepmill/core/parallel.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/sequence/advice/area_models.h"

namespace stepmill {
namespace {

/// A tool that saves less of a feature's time or cost is not worth talking about.
constexpr double kWorthBuyingShare = 0.01;

/// Nor is one for what is less of the feature's volume: every smaller cutter gets farther into corners.
constexpr double kWorthReachingShare = 0.01;

/// What the area model expects of a library: what its cutters reach together and how long the best sequence
/// takes.
struct Forecast {
    double volume_mm3 = 0;
    double time_s = 0;
};

ToolLibrary withTool(ToolLibrary library, const ToolAssembly& tool) {
    library.tools.push_back(tool);
    return library;
}

/// Areas over the feature's whole depth, by falling diameter. (A plan that ends higher tells areas up there.)
std::vector<ToolReach> reachesOf(const FeatureGround& ground, const ToolLibrary& library,
                                 const SequenceOptions& options) {
    const std::vector<const ToolAssembly*> tools = byFallingDiameter(library);
    std::vector<ToolReach> reaches(tools.size());
    parallelFor(tools.size(), [&](std::size_t i) { reaches[i] = reachFor(ground, *tools[i], options); });
    return reaches;
}

/// What a tool may do: all it reaches, or what its holder leaves of that.
ToolReach usableReach(const FeatureGround& ground, const ToolAssembly& tool, const ToolReach& reach) {
    if (tool.isDrill()) {
        ToolReach drill = reach;
        drill.use = Unhindered{};  // usableTools() knows which holes it fits
        return drill;
    }
    auto clear = collisionFreeArea(ground, tool, reach);
    return clear ? limitedTo(reach, std::move(*clear)) : reach;
}

class Adviser {
  public:
    Adviser(const Feature& feature, const ToolLibrary& library, const Machine& machine,
            const SequenceOptions& options, const Tolerances& tol)
        : feature_(feature),
          library_(library),
          machine_(machine),
          options_(options),
          tol_(tol),
          ground_(feature, tol),
          known_(sequenceTools(feature, library, machine, options, tol)),
          reaches_(reachesOf(ground_, library, options)) {
        for (const ToolReach& reach : reaches_)
            usable_.push_back(usableReach(ground_, library.tool(reach.tool_id), reach));
    }

    PurchaseAdvice advise() const {
        PurchaseAdvice advice;
        advice.feature_id = feature_.id;
        advice.time_s = known_.time_s;
        advice.cost = known_.cost;
        advice.stays_mm3 = residualVolumeMm3(known_);
        const std::vector<TrialTool> trials = promising(candidates());
        advice.trials = static_cast<int>(trials.size());
        for (Purchase& purchase : helpful(trials))
            if (!advice.best || helpsMore(purchase, *advice.best)) advice.best = std::move(purchase);
        return advice;
    }

    /// Those of some tools that help, the most promising tried.
    std::vector<Purchase> among(const std::vector<ToolAssembly>& offers) const {
        std::vector<TrialTool> trials;
        for (const ToolAssembly& offer : offers)
            if (!isInLibrary(offer.id)) trials.push_back({offer, "offered"});
        return helpful(promising(std::move(trials)));
    }

  private:
    std::vector<Purchase> helpful(const std::vector<TrialTool>& trials) const {
        std::vector<std::optional<Purchase>> tried(trials.size());
        parallelFor(trials.size(), [&](std::size_t i) { tried[i] = tryOut(trials[i]); });
        std::vector<Purchase> helpful;
        for (std::optional<Purchase>& purchase : tried)
            if (purchase) helpful.push_back(std::move(*purchase));
        return helpful;
    }

    /// Tools that may help, made for the feature.
    std::vector<TrialTool> candidates() const {
        std::vector<TrialTool> trials = trialMills(ground_, library_, options_.material);
        if (auto drill = trialDrill(ground_, library_, options_.material))
            trials.push_back(std::move(*drill));
        if (auto drill = trialPreDrill(ground_, library_, options_.material))
            trials.push_back(std::move(*drill));
        for (TrialTool& longer : longerTools(ground_, library_, reaches_))
            trials.push_back(std::move(longer));
        for (TrialTool& trial : trials)
            while (isInLibrary(trial.tool.id))
                trial.tool.id += "*";
        return trials;
    }

    /// Those of the trials that the area model expects something of, the best first.
    std::vector<TrialTool> promising(std::vector<TrialTool> trials) const {
        const Forecast now = forecast(library_, usable_);
        std::vector<Forecast> forecasts(trials.size());
        parallelFor(trials.size(), [&](std::size_t i) { forecasts[i] = forecastWith(trials[i].tool); });
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < trials.size(); ++i)
            if (trials[i].unforeseen || isBetter(forecasts[i], now)) order.push_back(i);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return isBetter(forecasts[a], forecasts[b]); });
        // What the model cannot tell of comes first among equals: it is tried.
        std::stable_partition(order.begin(), order.end(),
                              [&](std::size_t i) { return trials[i].unforeseen; });
        if (order.size() > kPurchaseTrials) order.resize(kPurchaseTrials);
        std::vector<TrialTool> chosen;
        chosen.reserve(order.size());
        for (const std::size_t i : order)
            chosen.push_back(std::move(trials[i]));
        return chosen;
    }

    bool isInLibrary(const std::string& id) const {
        return std::any_of(library_.tools.begin(), library_.tools.end(),
                           [&](const ToolAssembly& tool) { return tool.id == id; });
    }

    double worthReachingMm3() const { return kWorthReachingShare * feature_.volume_mm3; }

    bool isBetter(const Forecast& a, const Forecast& b) const {
        // Counted in whole steps, so that the order is a true one.
        const auto steps = [&](const Forecast& f) { return std::round(f.volume_mm3 / worthReachingMm3()); };
        return std::tuple(-steps(a), a.time_s) < std::tuple(-steps(b), b.time_s);
    }

    Forecast forecastWith(const ToolAssembly& tool) const {
        const ToolLibrary library = withTool(library_, tool);
        std::vector<ToolReach> reaches;
        auto known = usable_.begin();
        for (const ToolAssembly* each : byFallingDiameter(library)) {
            if (each == &library.tools.back())
                reaches.push_back(usableReach(ground_, tool, reachFor(ground_, tool, options_)));
            else
                reaches.push_back(*known++);
        }
        return forecast(library, reaches);
    }

    Forecast forecast(const ToolLibrary& library, const std::vector<ToolReach>& reaches) const {
        std::vector<AreaModelTool> tools;
        Forecast forecast;
        for (const Candidate& usable : usableTools(feature_, reaches, library, options_, machine_, tol_)) {
            // What it saves the mill after it, no area tells.
            if (usable.predrills) continue;
            AreaModelTool tool;
            if (usable.drill()) {
                tool.volume_mm3 = usable.coverable_mm2 * feature_.depth_mm();
                tool.rate_mm3_per_s = usable.volume_rate_mm3_per_s;
            } else {
                tool = areaModelTool(usable.tool->radius_mm(), usable.coverable_mm2, feature_.depth_mm(),
                                     usable.cutting);
            }
            forecast.volume_mm3 = std::max(forecast.volume_mm3, tool.volume_mm3);
            tools.push_back(tool);
        }
        const CheapestPath path = cheapestByLim(tools, machine_.tool_change_s);
        forecast.time_s = path.cost;
        return forecast;
    }

    /// What the feature gains by it; nothing when the best sequence does without it or gains nothing.
    std::optional<Purchase> tryOut(const TrialTool& trial) const {
        const ToolSequence sequence =
            sequenceTools(feature_, withTool(library_, trial.tool), machine_, options_, tol_);
        Purchase purchase;
        bool used = false;
        for (const SequenceStep& step : sequence.steps) {
            purchase.tools.push_back(step.tool_id);
            used = used || step.tool_id == trial.tool.id;
        }
        purchase.tool = trial.tool;
        purchase.why = trial.why;
        if (isHole(feature_.feature_class)) purchase.holes = static_cast<int>(holeCentres(feature_).size());
        purchase.saved_s = known_.time_s - sequence.time_s;
        purchase.saved_cost = known_.cost - sequence.cost;
        purchase.more_mm3 = residualVolumeMm3(known_) - residualVolumeMm3(sequence);
        const bool reaches_more = purchase.more_mm3 > worthReachingMm3();
        const bool as_much = purchase.more_mm3 >= -sameArea(feature_, tol_) * feature_.depth_mm();
        const bool saves = saved(purchase) > kWorthBuyingShare * weight(known_);
        if (!used || !(reaches_more || (as_much && saves))) return std::nullopt;
        if (!reaches_more) purchase.more_mm3 = 0;
        return purchase;
    }

    double weight(const ToolSequence& sequence) const {
        return options_.objective == Objective::Time ? sequence.time_s : sequence.cost;
    }

    double saved(const Purchase& purchase) const {
        return options_.objective == Objective::Time ? purchase.saved_s : purchase.saved_cost;
    }

    bool helpsMore(const Purchase& a, const Purchase& b) const {
        if (std::abs(a.more_mm3 - b.more_mm3) > worthReachingMm3()) return a.more_mm3 > b.more_mm3;
        return saved(a) > saved(b);
    }

    const Feature& feature_;
    const ToolLibrary& library_;
    const Machine& machine_;
    const SequenceOptions& options_;
    const Tolerances& tol_;
    FeatureGround ground_;
    ToolSequence known_;
    std::vector<ToolReach> reaches_;  ///< of the library, by falling diameter
    std::vector<ToolReach> usable_;   ///< the same tools, as far as their holders let them
};

}  // namespace

PurchaseAdvice whatToBuy(const Feature& feature, const ToolLibrary& library, const Machine& machine,
                         const SequenceOptions& options, const Tolerances& tol) {
    return Adviser(feature, library, machine, options, tol).advise();
}

std::vector<Purchase> purchasesFrom(const std::vector<ToolAssembly>& offers, const Feature& feature,
                                    const ToolLibrary& library, const Machine& machine,
                                    const SequenceOptions& options, const Tolerances& tol) {
    return Adviser(feature, library, machine, options, tol).among(offers);
}

}  // namespace stepmill
