// From a part to its plan: the stages of docs/architecture.md in their order.

#include <fmt/format.h>

#include "plan/assignment/propose_reserve.h"
#include "plan/cutting_feeds.h"
#include "plan/earlier_operations.h"
#include "plan/feature_planner.h"
#include "plan/form_finishing.h"
#include "plan/make_operations.h"
#include "plan/plan_warnings.h"
#include "plan/residual_prisms.h"
#include "plan/retract.h"
#include "plan/share_tools.h"
#include "plan/stick_outs.h"
#include "plan/threads.h"
#include "plan/totals.h"
#include "stepmill/core/error.h"
#include "stepmill/plan/books.h"
#include "stepmill/plan/deep_bands.h"
#include "stepmill/plan/plan.h"
#include "stepmill/plan/removed.h"
#include "stepmill/plan/roughing.h"
#include "stepmill/plan/setup_fixtures.h"
#include "stepmill/plan/stages.h"
#include "stepmill/plan/usable_library.h"
#include "stepmill/plan/warning_order.h"

namespace stepmill {
namespace {

using Warnings = std::vector<Warning>;

/// Shares of a setup's work at which its stages start, by rough experience; only the progress bar sees them.
constexpr double kFeaturesShare = 0.3;
constexpr double kSequencesShare = 0.35;

/// Sine of the angle below which two axes are parallel.
constexpr double kSameAxis = 1e-6;

/// A residual of which less than this lies outside earlier ones is not new.
constexpr double kNewResidualShare = 0.1;

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

/// Roughing takes of the setups that were chosen for the part those along the first one's axis: from other
/// sides it would see no more than the allowance and the stairs of the first.
std::vector<Setup> setupsFor(const Part& part, const PlanRequest& request) {
    std::vector<Setup> setups = chooseSetups(part, request.setup);
    if (!request.roughing || !request.setup.axes.empty() || setups.empty()) return setups;
    const Vec3 first = setups.front().axis;
    std::erase_if(setups, [&](const Setup& setup) { return setup.axis.cross(first).norm() > kSameAxis; });
    return setups;
}

/// The share of the whole work that one setup is, for the progress bar.
class SetupProgress {
  public:
    SetupProgress(const Progress& progress, std::size_t setup, std::size_t setups)
        : progress_(progress),
          share_(1.0 / static_cast<double>(setups)),
          start_(share_ * static_cast<double>(std::min(setup, setups - 1))) {}

    void tell(const std::string& stage, double share_of_setup) const {
        if (progress_) progress_(stage, start_ + share_ * share_of_setup);
    }

  private:
    const Progress& progress_;
    double share_;
    double start_;
};

/// A setup that is planned, with what its books ask for.
struct PlannedStage {
    PlannedSetup setup;
    std::size_t place = 0;  ///< of the setup among those that were chosen
    LayerStack layers;
    StageAir air;
    std::vector<Prism> removed;
    StockStep stock;
    Stock left;  ///< after its feature operations
    std::vector<Warning> warnings;
};

/// All but the layers and the stock's step: both are known once the stage is cut.
/// \param stage  with its fixtures
PlannedStage planStage(const Stage& stage, const PlanningShop& shop, const SetupProgress& progress) {
    progress.tell("features of " + stage.setup.id, kFeaturesShare);
    std::vector<Feature> bands = inBands(stage.found.features, shop.library, shop.request.sequence.material);
    PlannedFeatures planned =
        planFeatures(std::move(bands), stage.setup, shop, [&](const std::string& feature, double share) {
            progress.tell(feature, kSequencesShare + (1 - kSequencesShare) * share);
        });
    PlannedStage result;
    result.removed = removedBy(planned.features, shop.tol);
    result.setup.setup = stage.setup;
    result.place = stage.place;
    result.setup.clamping = stage.clamping;
    result.setup.unplanned = stage.found.unplanned;
    result.setup.reserve = stage.reserve;
    result.setup.features = std::move(planned.features);
    result.air = airOf(stage);
    result.warnings = std::move(planned.warnings);
    append(result.warnings, remarksOf(stage.layers));
    return result;
}

/// Does the setup cut nothing and only name again what earlier ones left standing?
bool repeatsResiduals(const PlannedSetup& setup, const std::vector<PlannedStage>& earlier) {
    const bool cuts =
        std::any_of(setup.features.begin(), setup.features.end(),
                    [](const PlannedFeature& planned) { return !planned.sequence.steps.empty(); });
    if (cuts) return false;
    std::vector<SetupPrism> known;
    for (const PlannedStage& stage : earlier)
        for (const ResidualPrism& residual : residualPrisms(stage.setup.features))
            known.push_back({&stage.setup.setup, residual.prism});
    const std::vector<ResidualPrism> own = residualPrisms(setup.features);
    return std::all_of(own.begin(), own.end(), [&](const ResidualPrism& residual) {
        return residual.volume_mm3 < kVolumeRoundingMm3 ||
               shareOutside(setup.setup, residual.prism, known) < kNewResidualShare;
    });
}

/// Every setup on the stock that the paths of those before it leave. What setups would cut that there is no
/// time for stays out of reach. \param late  warned of these
std::vector<PlannedStage> planStages(const std::vector<Setup>& setups, const std::vector<CutPrisms>& reserves,
                                     const PlanningShop& shop, const Progress& progress, Warnings& late) {
    std::vector<PlannedStage> stages;
    SetupWalk walk(setups, shop.request.slicing, shop.tol, reserves);
    const auto no_time = [&] { return !stages.empty() && shop.request.patience.few_tools.passed(); };
    while (!no_time()) {
        std::optional<Stage> stage = walk.next();
        if (!stage) break;
        setFixtures(*stage, shop.request.fixtures, shop.tol);
        if (const auto& leaves = shop.request.roughing)
            stage->found = withAllowance(std::move(stage->found), *leaves, shop.library,
                                         shop.request.sequence.material, shop.tol);
        FeatureNames names;
        if (const EarlierSetup* before = earlierOf(stage->setup, shop.request.earlier))
            names = namesFrom(*before, stage->found, shop.tol);
        stage->found = renamed(std::move(stage->found), names);
        PlannedStage planned = planStage(*stage, shop, SetupProgress(progress, stages.size(), setups.size()));
        const bool optional = !stages.empty() && stage->setup.chosen;
        if (optional && repeatsResiduals(planned.setup, stages)) continue;
        planned.setup.names = std::move(names);
        planned.stock = walk.cut(*stage, planned.removed);
        planned.left = walk.left();
        planned.layers = std::move(stage->layers);
        stages.push_back(std::move(planned));
    }
    if (walk.setupsLeft() > 0)
        late.push_back({"time-limit", stages.back().setup.setup.id,
                        fmt::format("no time was left for {} more setups (--timeout)", walk.setupsLeft())});
    return stages;
}

/// The setups move out of the stages.
std::vector<PlannedSetup> setupsOf(std::vector<PlannedStage>& stages) {
    std::vector<PlannedSetup> setups;
    setups.reserve(stages.size());
    for (PlannedStage& stage : stages)
        setups.push_back(std::move(stage.setup));
    return setups;
}

/// What keeps form cutters from a setup must not lose the plan: the walls stay as flat layers leave them.
std::optional<FormFinishing> formsOf(const FormSources& sources, const FormShop& shop, Warnings& warnings) {
    try {
        return finishForms(sources, shop);
    } catch (const Error& error) {
        warnings.push_back({"planning-failed", formGroundId(sources.setup.id),
                            fmt::format("leaning walls stay as flat layers leave them: {}", error.what())});
        return std::nullopt;
    }
}

/// The setups with form operations after all others, where the library has cutters for them.
std::vector<PlannedSetup> withForms(std::vector<PlannedSetup> setups, const std::vector<PlannedStage>& stages,
                                    const PlanningShop& shop, const Progress& progress, Warnings& warnings) {
    const PlanRequest& request = shop.request;
    const std::string& material = request.sequence.material;
    const bool finishes = request.scallop_mm > 0 && !request.roughing;
    if (!finishes || !hasFormCutters(shop.library, material)) return setups;
    // A wall that leans to two setups is finished in the first.
    Stock at_end = stages.back().left;
    for (std::size_t i = 0; i < setups.size(); ++i) {
        PlannedSetup& setup = setups[i];
        if (progress) progress("leaning walls of " + setup.setup.id, 1);
        const FormShop forms{shop.library,
                             shop.machine,
                             material,
                             request.scallop_mm,
                             retractMm(setup.setup, request.sequence.retract_mm, shop.machine),
                             shop.cautionOf(formGroundId(setup.setup.id)),
                             request.patience.few_tools,
                             shop.tol};
        std::optional<FormFinishing> finishing =
            formsOf({setup.setup, stages[i].layers, stages[i].left, at_end}, forms, warnings);
        if (!finishing) continue;
        setup.form = std::move(finishing->ground);
        at_end.cuts.push_back({setup.setup.part_to_setup, std::move(finishing->removed)});
        EarlierOperations before(setup, request.earlier);
        for (Operation& operation : finishing->operations) {
            operation.id = before.idOf(operation);
            setup.operations.push_back(std::move(operation));
        }
        linkOperations(setup.operations, shop.machine);
    }
    return setups;
}

PlanBooks booksOf(const std::vector<PlannedSetup>& setups, const std::vector<PlannedStage>& stages,
                  double stock_minus_part_mm3, const Tolerances& tol) {
    std::vector<SetupAccount> accounts;
    for (std::size_t i = 0; i < stages.size(); ++i)
        accounts.push_back(
            {&setups[i], &stages[i].layers, stages[i].stock, stages[i].air, stages[i].removed});
    return booksOf(accounts, stock_minus_part_mm3, tol);
}

bool booksClose(const PlanBooks& books, const Tolerances& tol) {
    return books.part.gapShare() <= tol.volume_share &&
           std::all_of(books.setups.begin(), books.setups.end(), [&](const VolumeBalance& setup) {
               return closes(setup, books.part.stock_minus_part_mm3, tol);
           });
}

/// Form operations that take what the books do not have, such as stairs that a later setup cuts at a slant,
/// are not believed: without them all is as flat layers leave it.
std::vector<PlannedSetup> withFormsOfTheBooks(std::vector<PlannedSetup> setups,
                                              const std::vector<PlannedStage>& stages,
                                              double stock_minus_part_mm3, const PlanningShop& shop,
                                              Warnings& warnings) {
    const auto has_form = [](const PlannedSetup& setup) { return setup.form.has_value(); };
    if (std::none_of(setups.begin(), setups.end(), has_form) ||
        booksClose(booksOf(setups, stages, stock_minus_part_mm3, shop.tol), shop.tol))
        return setups;
    for (PlannedSetup& setup : setups) {
        if (!setup.form) continue;
        warnings.push_back(
            {"planning-failed", setup.form->id,
             "leaning walls stay as flat layers leave them: what form cutters would take there "
             "is not all in the volume books"});
        setup.form.reset();
        std::erase_if(setup.operations, [](const Operation& one) { return one.role == Role::Form; });
        linkOperations(setup.operations, shop.machine);
    }
    return setups;
}

/// Says of every residual what of it is there at the end. \param staying  of the setups' own residuals
void nameWhatStays(std::vector<PlannedSetup>& setups, const StayingResiduals& staying) {
    for (PlannedSetup& setup : setups)
        for (PlannedFeature& planned : setup.features)
            for (Residual& residual : planned.sequence.residual) {
                const auto found = staying.find(&residual);
                const StayingResidual entry = found != staying.end() ? found->second : StayingResidual{};
                residual.stays_mm3 = entry.stays_mm3;
                residual.taken_by = entry.taken_by;
            }
}

ToolLibrary drillsOf(ToolLibrary library) {
    std::erase_if(library.tools, [](const ToolAssembly& tool) { return !tool.isDrill() && !tool.isSpot(); });
    return library;
}

/// The plan of these setups and no operation yet.
Plan planOf(const Part& part, const PlanRequest& request, const Machine& machine, const Stock& stock) {
    Plan plan;
    plan.request = request;
    plan.part = part;
    plan.stock = stock;
    plan.machine = machine;
    plan.material = request.sequence.material;
    plan.objective = request.sequence.objective;
    plan.cost_model = request.sequence.cost_model;
    return plan;
}

/// Setups with all that mills and drills cut in flat layers, at the library's feeds, and the stages they came
/// from.
struct CutSetups {
    std::vector<PlannedStage> stages;
    std::vector<PlannedSetup> setups;  ///< moved out of the stages
    ToolSharing sharing;
    int threads_missing = 0;
    PlanTotals totals;
    VolumeBalance balance;
    Warnings warnings;  ///< of time that was short, then of threads

    double leftMm3() const { return balance.residual_mm3 + balance.unreachable_mm3; }
};

/// Plans the setups as they stand, each on what those before it leave.
CutSetups cutSetups(const std::vector<Setup>& setups, const std::vector<CutPrisms>& reserves,
                    double stock_minus_part_mm3, const PlanningShop& shop, const Progress& progress) {
    const PlanRequest& request = shop.request;
    CutSetups cut;
    shop.memory.beginPlan();
    cut.stages = planStages(setups, reserves, shop, progress, cut.warnings);
    SharedSetups shared =
        withSharedTools(setupsOf(cut.stages), shop.library, shop.machine, request.sequence.objective);
    cut.sharing = shared.sharing;
    ThreadedSetups threaded = withThreads(std::move(shared.setups), shop, shop.wishes);
    cut.threads_missing = threaded.missing;
    append(cut.warnings, threaded.warnings);
    std::vector<PlannedSetup> operating = withOperations(
        std::move(threaded.setups),
        {shop.library, shop.machine, request.sequence.material, request.earlier, request.cautions, shop.tol});
    const ToolLibrary set_out = withStickOuts(shop.library, operating);
    TimedSetups timed = withTimes(std::move(operating), set_out, shop.machine);
    cut.setups = std::move(timed.setups);
    cut.totals = timed.totals;
    cut.balance = booksOf(cut.setups, cut.stages, stock_minus_part_mm3, shop.tol).part;
    return cut;
}

/// The plan of these setups: leaning walls finished, feeds by what is cut, times and books.
Plan finished(CutSetups cut, const Part& part, const Stock& stock, const UsableLibrary& usable,
              const PlanningShop& shop, const Progress& progress) {
    const PlanRequest& request = shop.request;
    const Machine& machine = shop.machine;
    const Tolerances& tol = shop.tol;
    const std::vector<PlannedStage>& stages = cut.stages;
    Warnings form_warnings;
    const double stock_minus_part_mm3 = stock.volume_mm3 - part.volume_mm3;
    std::vector<PlannedSetup> operating =
        withForms(std::move(cut.setups), stages, shop, progress, form_warnings);
    operating = withFormsOfTheBooks(std::move(operating), stages, stock_minus_part_mm3, shop, form_warnings);
    Plan plan = planOf(part, request, machine, stock);
    plan.sharing = cut.sharing;
    plan.threads_missing = cut.threads_missing;
    plan.library = withStickOuts(usable.library, operating);
    operating = withCuttingFeeds(std::move(operating), {request, plan.library, machine, tol});
    TimedSetups timed = withTimes(std::move(operating), plan.library, machine);
    plan.setups = std::move(timed.setups);
    plan.totals = timed.totals;
    const PlanBooks books = booksOf(plan.setups, stages, stock_minus_part_mm3, tol);
    nameWhatStays(plan.setups, books.staying);
    for (std::size_t i = 0; i < plan.setups.size(); ++i)
        plan.setups[i].balance = books.setups[i];
    plan.balance = books.part;

    plan.warnings = remarksOf(part);
    append(plan.warnings, usable.warnings);
    for (const PlannedStage& stage : stages)
        append(plan.warnings, stage.warnings);
    append(plan.warnings, form_warnings);
    append(plan.warnings, cut.warnings);
    append(plan.warnings, shop.wishes.unused(plan.setups));
    append(plan.warnings, unusedFixtures(request.fixtures, plan.setups));
    append(plan.warnings, warningsOf(plan, books.largest_gap, tol));
    plan.warnings = byConsequence(std::move(plan.warnings));
    return plan;
}

// Which setup cuts what ----------------------------------------------------------------------------------

/// Two plans' books differ by so much of stock minus part where cuts are seen from the side, whatever stays.
constexpr double kBooksNoiseShare = 1e-6;
/// Where something stays anyway, so much more of it may: other tools reach a little less of a corner or more.
constexpr double kMoreMayStayShare = 0.005;
/// A plan must be shorter by so much to be taken: feeds and leaning walls, which come later, are not in it.
constexpr double kWorthChanging = 0.99;

/// Is it clearly shorter, or cheaper if plans are made by cost, with no more setups and no more that stays?
bool isBetter(const CutSetups& cut, const CutSetups& than, Objective objective) {
    const auto weight = [&](const PlanTotals& totals) {
        return objective == Objective::Time ? totals.motion_s : totals.cost;
    };
    const double noise_mm3 =
        std::max(kVolumeRoundingMm3, kBooksNoiseShare * than.balance.stock_minus_part_mm3);
    const double may_stay_mm3 = than.leftMm3() + std::max(noise_mm3, kMoreMayStayShare * than.leftMm3());
    return cut.setups.size() <= than.setups.size() &&
           weight(cut.totals) < kWorthChanging * weight(than.totals) && cut.leftMm3() <= may_stay_mm3 &&
           std::abs(cut.balance.gapMm3()) <= std::abs(than.balance.gapMm3()) + noise_mm3;
}

/// Every setup first cuts all it reaches; then, setup after setup, what later ones would do for less is left
/// to them, as long as all gets better by it. \param assignment  what is known of it, and gets known
CutSetups cutWhereCheapest(const std::vector<Setup>& setups, double stock_minus_part_mm3,
                           const PlanningShop& shop, const Progress& progress, Assignment& assignment) {
    const PlanRequest& request = shop.request;
    assignment.reserves.resize(setups.size());
    CutSetups best = cutSetups(setups, assignment.reserves, stock_minus_part_mm3, shop, progress);
    if (request.assignment || !request.assign || request.roughing) return best;
    for (std::size_t i = 0; i < best.stages.size() && !request.patience.all_tools.passed(); ++i) {
        const std::size_t place = best.stages[i].place;
        if (progress) progress("what " + best.setups[i].setup.id + " might leave for later setups", 1);
        std::optional<ReserveProposal> proposal =
            proposeReserve(best.setups[i], best.stages[i].layers, setups, place, shop);
        if (!proposal) continue;
        std::vector<CutPrisms> reserves = assignment.reserves;
        reserves[place] = proposal->reserve;
        CutSetups trial = cutSetups(setups, reserves, stock_minus_part_mm3, shop, progress);
        const bool taken = isBetter(trial, best, request.sequence.objective);
        assignment.tried.push_back({best.setups[i].setup.id, std::move(*proposal), best.totals.motion_s,
                                    trial.totals.motion_s, trial.leftMm3() - best.leftMm3(), taken});
        if (!taken) continue;
        best = std::move(trial);
        assignment.reserves = std::move(reserves);
    }
    return best;
}

}  // namespace

Plan planPart(const Part& part, const PlanRequest& request, const ToolLibrary& library,
              const Machine& machine, const Tolerances& tol, const Progress& progress) {
    SequenceMemory memory;
    return planPart(part, request, library, machine, tol, progress, memory);
}

Plan planPart(const Part& part, const PlanRequest& request, const ToolLibrary& library,
              const Machine& machine, const Tolerances& tol, const Progress& progress,
              SequenceMemory& memory) {
    requireMaterial(library, request.sequence.material);
    if (progress) progress("setups", 0);
    const std::vector<Setup> setups = setupsFor(part, request);
    STEPMILL_CHECK(!setups.empty(), "a part has at least one setup");
    requireMachinableSize(part, setups, machine);
    const UsableLibrary usable = usableLibrary(library, request.sequence, machine, tallestStockMm(setups));
    const SmallerLibraries smaller = smallerLibraries(request.cautions, usable.library);
    const HoleWishes wishes(request.holes, part, tol);
    const ToolLibrary drills = drillsOf(usable.library);
    const PlanningShop shop{request, usable.library, smaller, wishes, drills, machine, tol, memory};
    const Stock& stock = setups.front().stock;
    Assignment assignment = request.assignment.value_or(Assignment{});
    CutSetups cut = cutWhereCheapest(setups, stock.volume_mm3 - part.volume_mm3, shop, progress, assignment);
    Plan plan = finished(std::move(cut), part, stock, usable, shop, progress);
    plan.assignment = std::move(assignment);
    if (progress) progress("done", 1);
    return plan;
}

}  // namespace stepmill
