#include "plan/feature_planner.h"

#include <mutex>

#include <tbb/parallel_for.h>

#include "stepmill/core/error.h"
#include "stepmill/plan/deep_bands.h"
#include "stepmill/plan/reduced_feature.h"
#include "stepmill/plan/setup_fixtures.h"

namespace stepmill {
namespace {

Residual wholeAsResidual(const Feature& feature, StayReason reason, std::string advice) {
    Residual residual;
    residual.region = feature.target;
    residual.area_mm2 = feature.area_mm2;
    residual.volume_mm3 = feature.volume_mm3;
    residual.reason = std::move(reason);
    residual.advice = std::move(advice);
    return residual;
}

/// The feature's sequence, or the feature as a residual with the reason when its planning fails: one bad
/// pocket must not lose the plan.
ToolSequence sequenceOrResidual(const Feature& feature, std::string& failure,
                                const std::function<ToolSequence()>& work) {
    try {
        return work();
    } catch (const Error& error) {
        if (error.code() == ErrorCode::TimedOut) throw;
        failure = error.what();
    } catch (const std::exception& error) {
        failure = error.what();
    }
    ToolSequence sequence;
    sequence.feature_id = feature.id;
    sequence.residual.push_back(
        wholeAsResidual(feature, {Reason::PlanningFailed, failure}, "a report of this part"));
    return sequence;
}

/// Parents come first, so one pass finds how many generations lie above each feature.
std::vector<std::vector<std::size_t>> generations(const std::vector<Feature>& features) {
    std::map<std::string, std::size_t> depth;
    std::vector<std::vector<std::size_t>> result;
    for (std::size_t i = 0; i < features.size(); ++i) {
        std::size_t own = 0;
        for (const std::string& parent : features[i].parents)
            own = std::max(own, depth.at(parent) + 1);
        depth[features[i].id] = own;
        if (own >= result.size()) result.resize(own + 1);
        result[own].push_back(i);
    }
    return result;
}

/// Plans features generation by generation: one has to know what those above it leave.
class FeaturePlanner {
  public:
    FeaturePlanner(std::vector<Feature>&& features, const Setup& setup, const PlanningShop& shop,
                   const Progress& progress)
        : setup_(setup), shop_(shop), progress_(progress) {
        generations_ = generations(features);
        planned_.resize(features.size());
        failures_.resize(features.size());
        for (std::size_t i = 0; i < features.size(); ++i) {
            planned_[i].feature = std::move(features[i]);
            number_[planned_[i].feature.id] = i;
        }
    }

    PlannedFeatures plan() {
        for (const std::vector<std::size_t>& generation : generations_) {
            tbb::parallel_for(std::size_t{0}, generation.size(), [&](std::size_t i) {
                reportStart(planned_[generation[i]].feature.id);
                planOne(generation[i]);
            });
        }
        PlannedFeatures found;
        for (std::size_t i = 0; i < planned_.size(); ++i) {
            if (!failures_[i].empty())
                found.warnings.push_back({"feature-failed", planned_[i].feature.id, failures_[i]});
        }
        found.features = std::move(planned_);
        return found;
    }

  private:
    void reportStart(const std::string& id) {
        const std::lock_guard lock(progress_mutex_);
        const double done = static_cast<double>(started_++) / static_cast<double>(planned_.size());
        if (progress_) progress_(id, done);
    }

    void planOne(std::size_t index) {
        PlannedFeature& planned = planned_[index];
        std::string& failure = failures_[index];
        planned.sequence = sequenceOrResidual(planned.feature, failure, [&] {
            const CutById by_id = [&](const std::string& id) { return asCut(planned_[number_.at(id)]); };
            const ReducedFeature free =
                reduced(planned.feature, parentsOf(planned.feature, by_id),
                        ancestorsOf(planned.feature, by_id), setup_.fixtures, shop_.tol);
            ToolSequence sequence = sequenceOf(free.feature, planned.feature);
            sequence.residual.insert(sequence.residual.end(), free.blocked.begin(), free.blocked.end());
            return sequence;
        });
    }

    /// \param free  what of the feature is free to be cut
    ToolSequence sequenceOf(const Feature& free, const Feature& feature) const {
        const FeatureCaution& caution = shop_.cautionOf(feature.id);
        ToolSequence sequence;
        sequence.feature_id = feature.id;
        sequence.floor_z_mm = feature.floor_z_mm;
        if (free.target.empty()) return sequence;
        if (caution.dropped) {
            sequence.residual.push_back(
                wholeAsResidual(free, {Reason::NotProven, {}}, "a report of this part"));
            return sequence;
        }
        sequence = sequenceTools(free, shop_.libraryOf(feature.id), shop_.machine, sequenceOptions(feature),
                                 shop_.tol);
        sequence.residual.insert(sequence.residual.end(), caution.left.begin(), caution.left.end());
        return sequence;
    }

    SequenceOptions sequenceOptions(const Feature& feature) const {
        SequenceOptions options = asPlanned(shop_.request.sequence);
        if (feature.band && feature.band->isUpper()) options.finish.floors_mm = 0;
        if (shop_.cautionOf(feature.id).plain_ways) options.pattern = Pattern::ContourInsideOut;
        const double fixture_mm = highestFixtureMm(setup_.fixtures);
        if (fixture_mm > 0) options.retract_mm = fixture_mm + shop_.machine.safe_height_mm;
        return options;
    }

    const Setup& setup_;
    const PlanningShop& shop_;
    const Progress& progress_;
    std::vector<std::vector<std::size_t>> generations_;
    std::vector<PlannedFeature> planned_;
    std::vector<std::string> failures_;
    std::map<std::string, std::size_t> number_;
    std::mutex progress_mutex_;
    std::size_t started_ = 0;
};

}  // namespace

SmallerLibraries smallerLibraries(const Cautions& cautions, const ToolLibrary& library) {
    SmallerLibraries smaller;
    for (const auto& [feature, caution] : cautions) {
        if (caution.without_tools.empty()) continue;
        const std::set<std::string>& without = caution.without_tools;
        ToolLibrary left = library;
        std::erase_if(left.tools, [&](const ToolAssembly& tool) { return without.count(tool.id) > 0; });
        smaller.emplace(feature, std::move(left));
    }
    return smaller;
}

const ToolLibrary& PlanningShop::libraryOf(const std::string& feature) const {
    const auto found = smaller.find(feature);
    return found != smaller.end() ? found->second : library;
}

const FeatureCaution& PlanningShop::cautionOf(const std::string& feature) const {
    static const FeatureCaution kNone;
    const auto found = request.cautions.find(feature);
    return found != request.cautions.end() ? found->second : kNone;
}

PlannedFeatures planFeatures(std::vector<Feature> features, const Setup& setup, const PlanningShop& shop,
                             const Progress& progress) {
    return FeaturePlanner(std::move(features), setup, shop, progress).plan();
}

}  // namespace stepmill
