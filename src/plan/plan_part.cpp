#include <map>
#include <mutex>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "plan/plan_steps.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

/// Shares of a setup's work at which its stages start, by rough experience; only the progress bar sees them.
constexpr double kFeaturesShare = 0.3;
constexpr double kSequencesShare = 0.35;

/// A residual of which less than this lies outside earlier ones is not new.
constexpr double kNewResidualShare = 0.1;

/// The libraries of the features that do without some tools, by feature id.
using SmallerLibraries = std::map<std::string, ToolLibrary>;

SmallerLibraries smallerLibraries(const Cautions& cautions, const ToolLibrary& library) {
    SmallerLibraries smaller;
    for (const auto& [feature, caution] : cautions) {
        if (caution.without_tools.empty()) continue;
        ToolLibrary left = library;
        std::erase_if(left.tools,
                      [&](const ToolAssembly& tool) { return caution.without_tools.count(tool.id) > 0; });
        smaller.emplace(feature, std::move(left));
    }
    return smaller;
}

struct Request {
    const PlanRequest& options;
    const ToolLibrary& library;
    const SmallerLibraries& smaller;
    const Machine& machine;
    const Tolerances& tol;
    const Progress& progress;

    const ToolLibrary& libraryOf(const std::string& feature) const {
        const auto found = smaller.find(feature);
        return found != smaller.end() ? found->second : library;
    }
    /// Of the feature; one that asks for nothing where there is none.
    const FeatureCaution& cautionOf(const std::string& feature) const {
        static const FeatureCaution kNone;
        const auto found = options.cautions.find(feature);
        return found != options.cautions.end() ? found->second : kNone;
    }

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

/// A part this many times larger than the machine's travel is a unit gone wrong, not a job.
constexpr double kLargestTravelMultiple = 10;

void requireMachinableSize(const Part& part, const std::vector<Setup>& setups, const Machine& machine) {
    for (const Setup& setup : setups) {
        for (int axis = 0; axis < 3; ++axis) {
            const double size_mm = setup.stock_bbox_mm.sizes()[axis];
            const double travel_mm = machine.travel_mm[axis];
            if (travel_mm <= 0 || size_mm <= kLargestTravelMultiple * travel_mm) continue;
            throw Error(
                ErrorCode::ImplausibleSize, part.file,
                fmt::format("the stock is {:.4g} mm long where {} travels {:.4g} mm; the file's unit is {}: "
                            "if that is wrong, say --unit mm",
                            size_mm, machine.name, travel_mm, part.unit_in_file));
        }
    }
}

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
    FeaturePlanner(std::vector<Feature>&& features, const Setup& setup, const Request& request,
                   double start_share, double end_share)
        : setup_(setup), request_(request), start_share_(start_share), end_share_(end_share) {
        generations_ = generations(features);
        planned_.resize(features.size());
        failures_.resize(features.size());
        for (std::size_t i = 0; i < features.size(); ++i) {
            planned_[i].feature = std::move(features[i]);
            number_[planned_[i].feature.id] = i;
        }
    }

    std::vector<PlannedFeature> plan(std::vector<Warning>& warnings) {
        for (const std::vector<std::size_t>& generation : generations_) {
            tbb::parallel_for(std::size_t{0}, generation.size(), [&](std::size_t i) {
                reportStart(planned_[generation[i]].feature.id);
                planOne(generation[i]);
            });
        }
        for (std::size_t i = 0; i < planned_.size(); ++i) {
            if (!failures_[i].empty())
                warnings.push_back({"feature-failed", planned_[i].feature.id, failures_[i]});
        }
        return std::move(planned_);
    }

  private:
    void reportStart(const std::string& id) {
        const std::lock_guard lock(progress_mutex_);
        const double done = static_cast<double>(started_++) / static_cast<double>(planned_.size());
        request_.report(id, start_share_ + (end_share_ - start_share_) * done);
    }

    void planOne(std::size_t index) {
        PlannedFeature& planned = planned_[index];
        std::string& failure = failures_[index];
        planned.sequence = sequenceOrResidual(planned.feature, failure, [&] {
            const PlannedById by_id = [&](const std::string& id) -> const PlannedFeature& {
                return planned_[number_.at(id)];
            };
            const ReducedFeature free =
                reduced(planned.feature, parentsOf(planned.feature, by_id),
                        ancestorsOf(planned.feature, by_id), setup_.fixtures, request_.tol);
            ToolSequence sequence = sequenceOf(free.feature, planned.feature);
            sequence.residual.insert(sequence.residual.end(), free.blocked.begin(), free.blocked.end());
            return sequence;
        });
    }

    /// \param free  what of the feature is free to be cut
    ToolSequence sequenceOf(const Feature& free, const Feature& feature) const {
        const FeatureCaution& caution = request_.cautionOf(feature.id);
        ToolSequence sequence;
        sequence.feature_id = feature.id;
        sequence.floor_z_mm = feature.floor_z_mm;
        if (free.target.empty()) return sequence;
        if (caution.dropped) {
            sequence.residual.push_back(
                wholeAsResidual(free, {Reason::NotProven, {}}, "a report of this part"));
            return sequence;
        }
        sequence = sequenceTools(free, request_.libraryOf(feature.id), request_.machine,
                                 sequenceOptions(feature), request_.tol);
        sequence.residual.insert(sequence.residual.end(), caution.left.begin(), caution.left.end());
        return sequence;
    }

    SequenceOptions sequenceOptions(const Feature& feature) const {
        SequenceOptions options = asPlanned(request_.options.sequence);
        if (feature.band && feature.band->isUpper()) options.finish.floors_mm = 0;
        if (request_.cautionOf(feature.id).plain_ways) options.pattern = Pattern::ContourInsideOut;
        const double fixture_mm = highestFixtureMm(setup_.fixtures);
        if (fixture_mm > 0) options.retract_mm = fixture_mm + request_.machine.safe_height_mm;
        return options;
    }

    const Setup& setup_;
    const Request& request_;
    double start_share_;
    double end_share_;
    std::vector<std::vector<std::size_t>> generations_;
    std::vector<PlannedFeature> planned_;
    std::vector<std::string> failures_;
    std::map<std::string, std::size_t> number_;
    std::mutex progress_mutex_;
    std::size_t started_ = 0;
};

/// Setups that the fixture file names and the plan does not have.
void warnOfUnusedFixtures(Plan& plan, const FixtureFile& given) {
    for (const auto& [id, fixtures] : given.setups) {
        const bool used = std::any_of(plan.setups.begin(), plan.setups.end(),
                                      [&](const PlannedSetup& setup) { return setup.setup.id == id; });
        if (!used)
            plan.warnings.push_back(
                {"fixtures-unused", id,
                 fmt::format("{} has fixtures for it; the plan has no such setup", given.file)});
    }
}

struct PlannedStage {
    PlannedSetup setup;
    LayerStack layers;
    StageAir air;
    std::vector<Prism> removed;
    std::vector<Warning> warnings;
};

PlannedStage planStage(Stage found, const Request& request, double start_share, double end_share) {
    PlannedStage stage;
    setFixtures(found, request.options.fixtures, request.tol);
    stage.air = airOf(found);
    stage.layers = std::move(found.layers);
    stage.setup.setup = found.setup;
    stage.setup.clamping = found.clamping;
    stage.setup.unplanned = found.found.unplanned;
    FeaturePlanner planner(inBands(found.found.features, request.library, request.options.sequence.material),
                           found.setup, request, start_share, end_share);
    stage.setup.features = planner.plan(stage.warnings);
    stage.removed = removedBy(stage.setup.features, request.tol);
    return stage;
}

/// Plans stage after stage; later ones see what the earlier ones' tools left.
class StagePlanner {
  public:
    StagePlanner(const Request& request, std::size_t setups) : request_(request), setups_(setups) {}

    std::optional<std::vector<Prism>> plan(const Stage& found) {
        const double share = 1.0 / static_cast<double>(setups_);
        const double start = share * static_cast<double>(std::min(stages_.size(), setups_ - 1));
        request_.report("features of " + found.setup.id, start + share * kFeaturesShare);
        PlannedStage stage = planStage(found, request_, start + share * kSequencesShare, start + share);
        if (!stages_.empty() && found.setup.chosen && repeatsResiduals(stage)) return std::nullopt;
        stages_.push_back(std::move(stage));
        return stages_.back().removed;
    }

    std::vector<PlannedStage>& stages() { return stages_; }

  private:
    /// Does the setup cut nothing and only name again what earlier ones left standing?
    bool repeatsResiduals(const PlannedStage& stage) const {
        const bool cuts =
            std::any_of(stage.setup.features.begin(), stage.setup.features.end(),
                        [](const PlannedFeature& planned) { return !planned.sequence.steps.empty(); });
        if (cuts) return false;
        std::vector<SetupPrism> known;
        for (const PlannedStage& earlier : stages_)
            for (const ResidualPrism& residual : residualPrisms(earlier.setup.features))
                known.push_back({&earlier.setup.setup, residual.prism});
        const std::vector<ResidualPrism> own = residualPrisms(stage.setup.features);
        return std::all_of(own.begin(), own.end(), [&](const ResidualPrism& residual) {
            return residual.volume_mm3 < kVolumeRoundingMm3 ||
                   shareOutside(stage.setup.setup, residual.prism, known) < kNewResidualShare;
        });
    }

    const Request& request_;
    std::size_t setups_;
    std::vector<PlannedStage> stages_;
};

std::vector<SetupAccount> accountsOf(Plan& plan, const std::vector<PlannedStage>& stages,
                                     const WalkedSetups& walked) {
    std::vector<SetupAccount> accounts;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        SetupAccount account{&plan.setups[i], &stages[i].layers, walked.steps[i], stages[i].air,
                             stages[i].removed};
        plan.setups[i].balance = setupBooks(account);
        accounts.push_back(std::move(account));
    }
    return accounts;
}

void warnOfPart(Plan& plan) {
    for (const Remark& remark : plan.part.remarks)
        plan.warnings.push_back({remark.code, plan.part.file, remark.text});
}

}  // namespace

Plan planPart(const Part& part, const PlanRequest& request, const ToolLibrary& library,
              const Machine& machine, const Tolerances& tol, const Progress& progress) {
    requireMaterial(library, request.sequence.material);
    Plan plan;
    plan.request = request;
    plan.part = part;
    plan.machine = machine;
    plan.material = request.sequence.material;
    plan.objective = request.sequence.objective;
    plan.cost_model = request.sequence.cost_model;
    warnOfPart(plan);

    if (progress) progress("setups", 0);
    const std::vector<Setup> setups = chooseSetups(part, request.setup);
    STEPMILL_CHECK(!setups.empty(), "a part has at least one setup");
    requireMachinableSize(part, setups, machine);
    plan.library = usableLibrary(library, request.sequence, machine, tallestStockMm(setups), plan.warnings);
    plan.stock = setups.front().stock;
    const SmallerLibraries smaller = smallerLibraries(request.cautions, plan.library);
    const Request job{request, plan.library, smaller, machine, tol, progress};

    StagePlanner planner(job, setups.size());
    const WalkedSetups walked =
        walkSetups(setups, request.slicing, tol, [&](const Stage& stage) { return planner.plan(stage); });
    std::vector<PlannedStage>& stages = planner.stages();
    for (PlannedStage& stage : stages) {
        plan.warnings.insert(plan.warnings.end(), stage.warnings.begin(), stage.warnings.end());
        warnOfInput(plan, stage.layers);
        plan.setups.push_back(std::move(stage.setup));
    }
    warnOfUnusedFixtures(plan, request.fixtures);
    shareTools(plan);
    makeOperations(plan, request.cautions);
    setStickOuts(plan);
    addUpTotals(plan);
    const double removable_mm3 = plan.stock.volume_mm3 - part.volume_mm3;
    const std::vector<SetupAccount> accounts = accountsOf(plan, stages, walked);
    plan.balance = partBooks(accounts, removable_mm3);
    warnOfUnreachable(plan);
    for (const PlannedSetup& setup : plan.setups)
        warnOfSetup(plan, setup);
    warnOfCautions(plan, request.cautions);
    warnOfMagazine(plan);
    warnOfShape(plan);
    warnOfBooks(plan, accounts, tol);
    job.report("done", 1);
    return plan;
}

}  // namespace stepmill
