#include <mutex>
#include <set>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "plan/plan_steps.h"
#include "stepmill/core/error.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// Shares of a setup's work at which its stages start, by rough experience; only the progress bar sees them.
constexpr double kSlicingShare = 0.05;
constexpr double kFeaturesShare = 0.3;
constexpr double kSequencesShare = 0.35;

struct Request {
    const PlanRequest& options;
    const ToolLibrary& library;
    const Machine& machine;
    const Tolerances& tol;
    const Progress& progress;

    void report(const std::string& stage, double share) const {
        if (progress) progress(stage, share);
    }
};

void requireMaterial(const ToolLibrary& library, const std::string& material) {
    for (const ToolAssembly& tool : library.tools) {
        if (tool.cuttingFor(material) != nullptr) return;
    }
    std::string known;
    for (const std::string& name : library.materials())
        known += (known.empty() ? "" : ", ") + name;
    throw Error(ErrorCode::Usage, "material '" + material + "'",
                "no tool of " + library.file + " has cutting data for it; the library knows: " + known);
}

Residual wholeAsResidual(const Feature& feature, std::string reason, std::string advice) {
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
ToolSequence sequenceOrResidual(const Feature& feature, const Request& request, std::string& failure) {
    try {
        return sequenceTools(feature, request.library, request.machine, request.options.sequence,
                             request.tol);
    } catch (const Error& error) {
        if (error.code() == ErrorCode::TimedOut) throw;
        failure = error.what();
    } catch (const std::exception& error) {
        failure = error.what();
    }
    ToolSequence sequence;
    sequence.feature_id = feature.id;
    sequence.residual.push_back(
        wholeAsResidual(feature, "planning failed: " + failure, "a report of this part"));
    return sequence;
}

std::vector<PlannedFeature> sequenceAll(FeatureSet&& found, const Request& request, double start_share,
                                        double end_share, std::vector<Warning>& warnings) {
    std::vector<PlannedFeature> planned(found.features.size());
    std::vector<std::string> failures(planned.size());
    std::mutex progress_mutex;
    std::size_t started = 0;
    tbb::parallel_for(std::size_t{0}, planned.size(), [&](std::size_t i) {
        planned[i].feature = std::move(found.features[i]);
        {
            const std::lock_guard lock(progress_mutex);
            const double done = static_cast<double>(started++) / static_cast<double>(planned.size());
            request.report(planned[i].feature.id, start_share + (end_share - start_share) * done);
        }
        planned[i].sequence = sequenceOrResidual(planned[i].feature, request, failures[i]);
    });
    for (std::size_t i = 0; i < planned.size(); ++i) {
        if (!failures[i].empty()) warnings.push_back({"feature-failed", planned[i].feature.id, failures[i]});
    }
    return planned;
}

/// A feature below one that is not machined lies under solid material: it stays as well.
void dropBuriedFeatures(std::vector<PlannedFeature>& features) {
    std::set<std::string> not_machined;
    for (PlannedFeature& planned : features) {
        const std::vector<std::string>& parents = planned.feature.parents;
        const auto buried = std::find_if(parents.begin(), parents.end(),
                                         [&](const std::string& id) { return not_machined.count(id) > 0; });
        if (buried != parents.end()) {
            planned.sequence.steps.clear();
            planned.sequence.time_s = planned.sequence.cost = 0;
            planned.sequence.residual = {wholeAsResidual(planned.feature,
                                                         "below " + *buried + ", which cannot be machined",
                                                         "what " + *buried + " needs")};
        }
        if (planned.sequence.steps.empty()) not_machined.insert(planned.feature.id);
    }
}

/// Where a parent leaves material over a child, the child's cutter meets more than its own depth.
void warnOfMaterialAbove(const std::vector<PlannedFeature>& features, const Tolerances& tol,
                         std::vector<Warning>& warnings) {
    std::map<std::string, const PlannedFeature*> by_id;
    for (const PlannedFeature& planned : features)
        by_id[planned.feature.id] = &planned;
    for (const PlannedFeature& planned : features) {
        if (planned.sequence.steps.empty()) continue;
        for (const std::string& parent : planned.feature.parents) {
            double above_mm2 = 0;
            for (const Residual& left : by_id.at(parent)->sequence.residual)
                above_mm2 += area(intersect(left.region, planned.feature.target, tol));
            if (above_mm2 <= tol.area_mm2) continue;
            warnings.push_back(
                {"material-above", planned.feature.id,
                 fmt::format("{} leaves {:.3g} mm2 of material standing over it", parent, above_mm2)});
        }
    }
}

/// The steps of all features become operations, in machining order and numbered in it.
std::vector<Operation> makeOperations(PlannedSetup& setup, const Machine& machine) {
    std::vector<Operation> operations;
    std::vector<Feature> features;
    for (PlannedFeature& planned : setup.features) {
        features.push_back(planned.feature);
        for (SequenceStep& step : planned.sequence.steps) {
            Operation operation;
            operation.setup_id = setup.setup.id;
            operation.feature_id = planned.feature.id;
            operation.tool_id = step.tool_id;
            operation.role = step.role;
            operation.path = std::move(step.path);
            operation.proof = step.proof;
            operation.z_top_mm = planned.feature.top_z_mm;
            operation.z_floor_mm = planned.feature.floor_z_mm;
            operation.speed_rpm = step.speed_rpm;
            step.path = Toolpath{};
            operations.push_back(std::move(operation));
        }
    }
    std::vector<Operation> ordered;
    for (const int index : orderOperations(operations, features)) {
        ordered.push_back(std::move(operations[index]));
        ordered.back().id = fmt::format("{}.O{}", setup.setup.id, ordered.size());
    }
    linkOperations(ordered, machine);
    return ordered;
}

struct PlannedStage {
    PlannedSetup setup;
    LayerStack layers;
    std::vector<Warning> warnings;
};

PlannedStage planSetup(const Setup& setup, const Request& request, double start_share, double end_share) {
    const auto at = [&](double share) { return start_share + (end_share - start_share) * share; };
    PlannedStage stage;
    request.report("slicing " + setup.id, at(kSlicingShare));
    stage.layers = slice(setup, request.tol, request.options.slicing);
    request.report("features of " + setup.id, at(kFeaturesShare));
    FeatureSet found = recogniseFeatures(stage.layers, request.tol);
    stage.setup.setup = setup;
    stage.setup.unplanned = std::move(found.unplanned);
    stage.setup.features =
        sequenceAll(std::move(found), request, at(kSequencesShare), end_share, stage.warnings);
    dropBuriedFeatures(stage.setup.features);
    warnOfMaterialAbove(stage.setup.features, request.tol, stage.warnings);
    stage.setup.operations = makeOperations(stage.setup, request.machine);
    return stage;
}

void warnOfPart(Plan& plan) {
    if (plan.part.unit_in_file == "none")
        plan.warnings.push_back(
            {"unit-doubt", plan.part.file, "the file names no unit of length; read as mm"});
    for (const std::string& remark : plan.part.remarks)
        plan.warnings.push_back({"part", plan.part.file, remark});
}

}  // namespace

Plan planPart(const Part& part, const PlanRequest& request, const ToolLibrary& library,
              const Machine& machine, const Tolerances& tol, const Progress& progress) {
    requireMaterial(library, request.sequence.material);
    const Request job{request, library, machine, tol, progress};
    Plan plan;
    plan.part = part;
    plan.machine = machine;
    plan.library = library;
    plan.material = request.sequence.material;
    plan.objective = request.sequence.objective;
    warnOfPart(plan);

    job.report("setups", 0);
    const std::vector<Setup> setups = chooseSetups(part, request.setup);
    STEPMILL_CHECK(!setups.empty(), "a part has at least one setup");
    plan.stock = setups.front().stock;

    std::vector<LayerStack> stacks;
    for (std::size_t i = 0; i < setups.size(); ++i) {
        const double share = 1.0 / static_cast<double>(setups.size());
        PlannedStage stage =
            planSetup(setups[i], job, share * static_cast<double>(i), share * static_cast<double>(i + 1));
        plan.warnings.insert(plan.warnings.end(), stage.warnings.begin(), stage.warnings.end());
        warnOfInput(plan, stage.layers);
        warnOfSetup(plan, stage.setup);
        plan.setups.push_back(std::move(stage.setup));
        stacks.push_back(std::move(stage.layers));
    }
    addUpTotals(plan);
    balanceBooks(plan, plan.stock.volume_mm3 - part.volume_mm3);
    if (plan.balance.gapShare() > tol.volume_share) {
        for (std::size_t i = 0; i < stacks.size(); ++i) {
            plan.warnings.push_back(
                {"books", plan.setups[i].setup.id,
                 fmt::format("the volume books miss {:.3g} % of stock minus part; {}",
                             100 * plan.balance.gapShare(), largestGap(stacks[i], plan.setups[i], tol))});
        }
    }
    job.report("done", 1);
    return plan;
}

}  // namespace stepmill
