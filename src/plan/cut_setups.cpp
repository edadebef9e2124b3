// Setups as mills and drills cut them in flat layers.

#include "plan/cut_setups.h"

#include <utility>

#include "plan/features/threads.h"
#include "plan/operations/make_operations.h"
#include "plan/operations/stick_outs.h"
#include "plan/plan_warnings.h"
#include "plan/totals.h"

namespace stepmill {
namespace {

/// The setups move out of the stages.
std::vector<PlannedSetup> setupsOf(std::vector<PlannedStage>& stages) {
    std::vector<PlannedSetup> setups;
    setups.reserve(stages.size());
    for (PlannedStage& stage : stages)
        setups.push_back(std::move(stage.setup));
    return setups;
}

}  // namespace

PlanBooks booksOf(const std::vector<PlannedSetup>& setups, const std::vector<PlannedStage>& stages,
                  double stock_minus_part_mm3, const Tolerances& tol) {
    std::vector<SetupAccount> accounts;
    for (std::size_t i = 0; i < stages.size(); ++i)
        accounts.push_back(
            {&setups[i], &stages[i].layers, stages[i].stock, stages[i].air, stages[i].removed});
    return booksOf(accounts, stock_minus_part_mm3, tol);
}

CutSetups cutSetups(const std::vector<Setup>& setups, const std::vector<CutPrisms>& reserves,
                    const PlanningShop& shop, const Progress& progress) {
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
    return cut;
}

}  // namespace stepmill
