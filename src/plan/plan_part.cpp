// From a part to its plan: the stages of docs/architecture.md in their order.

#include <fmt/format.h>

#include "plan/cutting_feeds.h"
#include "plan/feature_planner.h"
#include "plan/form_setups.h"
#include "plan/make_operations.h"
#include "plan/plan_warnings.h"
#include "plan/residual_prisms.h"
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
    result.setup.clamping = stage.clamping;
    result.setup.unplanned = stage.found.unplanned;
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
std::vector<PlannedStage> planStages(const std::vector<Setup>& setups, const PlanningShop& shop,
                                     const Progress& progress, Warnings& late) {
    std::vector<PlannedStage> stages;
    SetupWalk walk(setups, shop.request.slicing, shop.tol);
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

std::vector<CutStage> cutStagesOf(const std::vector<PlannedStage>& stages) {
    std::vector<CutStage> cut;
    for (const PlannedStage& stage : stages)
        cut.push_back({&stage.layers, &stage.left});
    return cut;
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

}  // namespace

Plan planPart(const Part& part, const PlanRequest& request, const ToolLibrary& library,
              const Machine& machine, const Tolerances& tol, const Progress& progress) {
    requireMaterial(library, request.sequence.material);
    if (progress) progress("setups", 0);
    const std::vector<Setup> setups = setupsFor(part, request);
    STEPMILL_CHECK(!setups.empty(), "a part has at least one setup");
    requireMachinableSize(part, setups, machine);
    const UsableLibrary usable = usableLibrary(library, request.sequence, machine, tallestStockMm(setups));
    const SmallerLibraries smaller = smallerLibraries(request.cautions, usable.library);
    const HoleWishes wishes(request.holes, part, tol);
    const ToolLibrary drills = drillsOf(usable.library);
    const PlanningShop shop{request, usable.library, smaller, wishes, drills, machine, tol};

    Warnings late;
    std::vector<PlannedStage> stages = planStages(setups, shop, progress, late);
    SharedSetups shared =
        withSharedTools(setupsOf(stages), usable.library, machine, request.sequence.objective);
    ThreadedSetups threaded = withThreads(std::move(shared.setups), shop, wishes);
    std::vector<PlannedSetup> operating = withOperations(
        std::move(threaded.setups),
        {usable.library, machine, request.sequence.material, request.earlier, request.cautions, tol});
    Warnings form_warnings;
    const double stock_minus_part_mm3 = setups.front().stock.volume_mm3 - part.volume_mm3;
    const std::vector<CutStage> cut = cutStagesOf(stages);
    operating = withForms(std::move(operating), cut, shop, progress, form_warnings);
    operating = withFormsOfTheBooks(std::move(operating), stages, stock_minus_part_mm3, shop, form_warnings);
    operating = withBrokenEdges(std::move(operating), cut, shop, progress, form_warnings);
    Plan plan = planOf(part, request, machine, setups.front().stock);
    plan.sharing = shared.sharing;
    plan.threads_missing = threaded.missing;
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
    append(plan.warnings, late);
    append(plan.warnings, threaded.warnings);
    append(plan.warnings, wishes.unused(plan.setups));
    append(plan.warnings, unusedFixtures(request.fixtures, plan.setups));
    append(plan.warnings, warningsOf(plan, books.largest_gap, tol));
    plan.warnings = byConsequence(std::move(plan.warnings));
    if (progress) progress("done", 1);
    return plan;
}

}  // namespace stepmill
