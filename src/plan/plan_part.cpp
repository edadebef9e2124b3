// From a part to its plan: the stages of docs/architecture.md in their order.

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "plan/assignment/best_setups.h"
#include "plan/assignment/cut_where_cheapest.h"
#include "plan/cycle_time/cycle_paces.h"
#include "plan/forms/form_finishing.h"
#include "plan/forms/form_setups.h"
#include "plan/forms/form_stairs.h"
#include "plan/holding/tab_reserve.h"
#include "plan/operations/make_operations.h"
#include "plan/operations/stick_outs.h"
#include "plan/plan_warnings.h"
#include "stepmill/core/error.h"
#include "stepmill/plan/plan.h"
#include "stepmill/plan/usable_library.h"
#include "stepmill/plan/warning_order.h"
#include "stepmill/setup/leaning_area.h"

namespace stepmill {
namespace {

using Warnings = std::vector<Warning>;

/// Of stock minus part so much more may stay with the setups of an earlier plan: what a revision's own
/// corners keep.
constexpr double kRevisionMayLeaveShare = 0.002;

/// Form cutters have little to finish where less of a part's surface leans than this share: broken edges.
constexpr double kLittleLeansShare = 0.1;
/// As many other setups are planned beside those chosen where these are no more than so many.
constexpr std::size_t kFewSetups = 3;

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

/// Along the axes of an assignment where there is one. Roughing takes of the setups that were chosen for the
/// part those along the first one's axis: from other sides it would see no more than the allowance and the
/// stairs of the first.
std::vector<Setup> setupsFor(const Part& part, const PlanRequest& request) {
    SetupRequest wanted = request.setup;
    const bool known = request.setup.axes.empty() && request.assignment;
    if (known) wanted.axes = request.assignment->axes;
    std::vector<Setup> setups = chooseSetups(part, wanted);
    for (Setup& setup : setups)
        setup.chosen = request.setup.axes.empty();
    if (!request.roughing || known || !request.setup.axes.empty() || setups.empty()) return setups;
    const Vec3 first = setups.front().axis;
    std::erase_if(setups, [&](const Setup& setup) {
        return !isSameAxis(setup.axis, first) && !isSameAxis(setup.axis, -first);
    });
    return setups;
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

/// Says of every residual what of it is there at the end.
/// \param staying  of the setups' own residuals
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

/// A plan of what was asked for, with no setups yet.
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

double takenByFormsMm3(const PlannedSetup& setup) {
    double sum = 0;
    for (const Operation& operation : setup.operations)
        for (const ReasonVolume& taken : operation.takes)
            sum += taken.volume_mm3;
    return sum;
}

/// Drops the last setups if they waited for form cutters which find next to nothing in them. One before
/// others stays, so that setups are numbered without a gap.
void dropIdle(std::vector<PlannedSetup>& setups, std::vector<PlannedStage>& stages,
              double stock_minus_part_mm3) {
    while (stages.back().for_forms &&
           takenByFormsMm3(setups.back()) < kPaysForASetupShare * stock_minus_part_mm3) {
        setups.pop_back();
        stages.pop_back();
    }
}

/// The plan of these setups: leaning walls finished, feeds by what is cut, times and books.
Plan finished(CutSetups cut, const Part& part, const Stock& stock, const UsableLibrary& usable,
              const PlanningShop& shop, const Progress& progress) {
    const PlanRequest& request = shop.request;
    const Machine& machine = shop.machine;
    const Tolerances& tol = shop.tol;
    std::vector<PlannedStage>& stages = cut.stages;
    Warnings form_warnings;
    const double stock_minus_part_mm3 = stock.volume_mm3 - part.volume_mm3;
    std::vector<PlannedSetup> operating =
        withForms(std::move(cut.setups), stages, shop, progress, form_warnings);
    dropIdle(operating, stages, stock_minus_part_mm3);
    operating = withFormsOfTheBooks(std::move(operating), stages, stock_minus_part_mm3, shop, form_warnings);
    operating = withBrokenEdges(std::move(operating), stages, shop, progress, form_warnings);
    Plan plan = planOf(part, request, machine, stock);
    plan.sharing = cut.sharing;
    plan.threads_missing = cut.threads_missing;
    plan.library = withStickOuts(usable.library, operating);
    PacedSetups paced = withCycleTimes(std::move(operating), {request, plan.library, machine, tol});
    plan.setups = std::move(paced.timed.setups);
    plan.totals = paced.timed.totals;
    plan.cycle.outcomes = std::move(paced.outcomes);
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

/// Where tabs are asked for, what they and their frame keep from the setup; else nothing.
Assignment heldByTabs(const std::vector<Setup>& setups, const ToolLibrary& library,
                      const PlanRequest& request, const Tolerances& tol) {
    if (request.hold != HoldKind::Tabs) return {};
    if (setups.size() > 1)
        throw Error(ErrorCode::Usage, "--hold tabs",
                    fmt::format("a frame lets one setup at its part, found {}: say which (--setup +z)",
                                setups.size()));
    Assignment assignment;
    assignment.reserves.push_back(
        tabbedFrame(setups.front(), request.slicing, library, request.sequence.material, tol));
    return assignment;
}

/// What a plan is made of beside its setups.
struct PlanSources {
    const Part& part;
    const ToolLibrary& library;
    const Machine& machine;
    const Tolerances& tol;
    const Progress& progress;
    SequenceMemory& memory;
};

/// Planning in flat layers is given up at a deadline, if there is one: no setup has to leave time to others.
PlanRequest flatBy(PlanRequest request, const Deadline& flat_by) {
    if (flat_by.isNever()) return request;
    request.patience.setup_share = 1;
    request.patience.all_tools = request.patience.all_tools.orEarlier(flat_by);
    request.patience.few_tools = request.patience.few_tools.orEarlier(flat_by);
    return request;
}

std::vector<Vec3> axesOf(const std::vector<Setup>& setups) {
    std::vector<Vec3> axes;
    axes.reserve(setups.size());
    for (const Setup& setup : setups)
        axes.push_back(setup.axis);
    return axes;
}

/// The plan of these setups, or of some of them.
/// \param flat_by  for flat layers alone
/// \throws Error(TimedOut) where they are not planned by then
Plan planOn(const std::vector<Setup>& setups, const PlanRequest& request, const PlanSources& from,
            const Deadline& flat_by) {
    const UsableLibrary usable =
        usableLibrary(from.library, request.sequence, from.machine, tallestStockMm(setups));
    const SmallerLibraries smaller = smallerLibraries(request, usable.library);
    const HoleWishes wishes(request.holes, from.part, from.tol);
    const ToolLibrary drills = drillsOf(usable.library);
    const HoldRequest hold{request.hold, request.break_edges_mm,
                           fixtureGrowthMm(request.fixtures, from.library)};
    const PlanningShop shop{request,      usable.library, smaller, wishes,     drills,
                            from.machine, from.tol,       hold,    from.memory};
    const Stock& stock = setups.front().stock;
    Assignment assignment =
        request.assignment ? *request.assignment : heldByTabs(setups, usable.library, request, from.tol);
    assignment.axes = axesOf(setups);
    const PlanRequest flat = flatBy(request, flat_by);
    CutSetups cut = cutWhereCheapest(setups, stock.volume_mm3 - from.part.volume_mm3, shop.with(flat),
                                     from.progress, assignment);
    flat_by.check(from.part.file);
    Plan plan = finished(std::move(cut), from.part, stock, usable, shop, from.progress);
    plan.assignment = std::move(assignment);
    return plan;
}

/// Setups are chosen by reach; may whole plans choose among others?
bool mayChooseSetups(const PlanRequest& request) {
    return request.setup.axes.empty() && !request.assignment && !request.roughing &&
           request.hold != HoldKind::Tabs && request.fixtures.setups.empty();
}

/// Form cutters may do without setups for faces that flat ones leave steps on, or with some that hold the
/// part better.
std::vector<Setup> setupsWithForms(const Part& part, const PlanRequest& request, const ToolLibrary& library) {
    if (request.scallop_mm <= 0 || !hasFormCutters(library, request.sequence.material)) return {};
    SetupRequest finished_in_steps = request.setup;
    finished_in_steps.steps_finished = true;
    return chooseSetups(part, finished_in_steps);
}

/// Fewer are quicker to set up. As many may be held better, or need no tilted one: of few, where little is
/// left to form cutters, that is tried.
bool areWorthPlanning(const std::vector<Setup>& setups, const std::vector<Setup>& others,
                      const LeaningArea& area) {
    if (setups.size() < others.size()) return true;
    const bool same =
        std::is_permutation(setups.begin(), setups.end(), others.begin(), others.end(),
                            [](const Setup& a, const Setup& b) { return isSameAxis(a.axis, b.axis); });
    return !same && setups.size() == others.size() && setups.size() <= kFewSetups &&
           area.leaning_mm2 < kLittleLeansShare * area.surface_mm2;
}

/// The sets of setups that are weighed.
/// \param chosen  by reach, the first of them
SetupSets setupSets(const Part& part, const PlanRequest& request, const ToolLibrary& library,
                    std::vector<Setup> chosen) {
    SetupSets sets;
    sets.chosen = std::move(chosen);
    sets.more_may_follow = mayChooseSetups(request);
    if (sets.chosen.size() < 2 || !sets.more_may_follow) return sets;
    sets.with_forms = setupsWithForms(part, request, library);
    const LeaningArea area = leaningArea(part, sets.with_forms);
    if (!areWorthPlanning(sets.with_forms, sets.chosen, area)) sets.with_forms.clear();
    sets.forms_leave_mm3 = leftOnLeaningMm(request.scallop_mm) * area.leaning_mm2;
    sets.others = otherSetups(part, request.setup, sets.chosen);
    return sets;
}

/// The axes along which sight, or whoever asks, wants setups; none where setups have no choice of what they
/// leave.
std::vector<Vec3> axesSeen(const PlanRequest& request, const std::vector<Setup>& chosen) {
    const bool free_to_leave = !request.roughing && request.hold != HoldKind::Tabs;
    return free_to_leave ? axesOf(chosen) : std::vector<Vec3>();
}

bool sameAxes(const std::vector<Vec3>& some, const std::vector<Vec3>& others) {
    return std::equal(some.begin(), some.end(), others.begin(), others.end(), isSameAxis);
}

/// The plan with the setups of an earlier one and what each leaves for later ones; nothing where sight asks
/// for others, or where more stays: others may take that.
std::optional<Plan> planAsBefore(const std::vector<Setup>& chosen, const PlanRequest& request,
                                 const PlanSources& from) {
    const EarlierAssignment& before = *request.as_before;
    if (!sameAxes(axesSeen(request, chosen), before.assignment.seen)) return std::nullopt;
    PlanRequest as_before = request;
    as_before.assignment = before.assignment;
    try {
        Plan plan = planOn(setupsFor(from.part, as_before), as_before, from, {});
        const double may_stay_mm3 =
            before.left_mm3 + kRevisionMayLeaveShare * plan.balance.stock_minus_part_mm3 + kVolumeRoundingMm3;
        if (plan.balance.leftMm3() <= may_stay_mm3) return plan;
    } catch (const Error&) {
        // What was right for another part must not lose the plan of this one.
    }
    return std::nullopt;
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
    std::vector<Setup> chosen = setupsFor(part, request);
    STEPMILL_CHECK(!chosen.empty(), "a part has at least one setup");
    requireMachinableSize(part, chosen, machine);
    const PlanSources from{part, library, machine, tol, progress, memory};
    std::optional<Plan> plan;
    if (request.as_before && !request.assignment) plan = planAsBefore(chosen, request, from);
    if (!plan) {
        const SetupSets sets = setupSets(part, request, library, std::move(chosen));
        plan =
            bestPlan(sets, request, machine, [&](const std::vector<Setup>& setups, const Deadline& flat_by) {
                return planOn(setups, request, from, flat_by);
            });
        if (!request.assignment) plan->assignment.seen = axesSeen(request, sets.chosen);
    }
    if (progress) progress("done", 1);
    return std::move(*plan);
}

}  // namespace stepmill
