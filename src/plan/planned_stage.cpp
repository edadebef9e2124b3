// The setups of a plan in their order: what each finds in the stock, and how it cuts that.

#include "plan/planned_stage.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "plan/forms/form_finishing.h"
#include "plan/forms/form_setups.h"
#include "plan/holding/loose_pieces.h"
#include "plan/operations/earlier_operations.h"
#include "plan/plan_warnings.h"
#include "plan/residual_prisms.h"
#include "stepmill/plan/deep_bands.h"
#include "stepmill/plan/hold_stage.h"
#include "stepmill/plan/removed.h"
#include "stepmill/plan/roughing.h"

namespace stepmill {
namespace {

/// Shares of a setup's work at which its stages start, by rough experience; only the progress bar sees them.
constexpr double kFeaturesShare = 0.3;
constexpr double kSequencesShare = 0.35;

/// A residual of which less than this lies outside earlier ones is not new.
constexpr double kNewResidualShare = 0.1;

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

bool cutsNothing(const PlannedSetup& setup) {
    return std::all_of(setup.features.begin(), setup.features.end(),
                       [](const PlannedFeature& planned) { return planned.sequence.steps.empty(); });
}

/// Do the setup's residuals only name again what earlier ones left standing?
bool repeatsResiduals(const PlannedSetup& setup, const std::vector<PlannedStage>& earlier) {
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

/// Is the part turned over for it, as for the lower edges of a block?
bool turnsOverAny(const Setup& setup, const std::vector<PlannedStage>& earlier) {
    return std::any_of(earlier.begin(), earlier.end(), [&](const PlannedStage& stage) {
        return isSameAxis(stage.setup.setup.axis, -setup.axis);
    });
}

}  // namespace

std::vector<PlannedStage> planStages(const std::vector<Setup>& setups, const std::vector<CutPrisms>& reserves,
                                     const PlanningShop& shop, const Progress& progress,
                                     std::vector<Warning>& late) {
    std::vector<PlannedStage> stages;
    SetupWalk walk(setups, shop.request.slicing, shop.tol, reserves);
    const auto no_time = [&] { return !stages.empty() && shop.request.patience.few_tools.passed(); };
    const bool forms = finishesForms(shop);
    bool last_in_vain = false;
    while (!no_time()) {
        std::optional<Stage> stage = walk.next(forms);
        if (!stage) break;
        holdStage(*stage, shop.request.fixtures, shop.hold, shop.tol);
        if (const auto& leaves = shop.request.roughing)
            stage->found = withAllowance(std::move(stage->found), *leaves, shop.library,
                                         shop.request.sequence.material, shop.tol);
        FeatureNames names;
        if (const EarlierSetup* before = earlierOf(stage->setup, shop.request.earlier))
            names = namesFrom(*before, stage->found, shop.tol);
        stage->found = renamed(std::move(stage->found), names);
        PlanRequest in_time = shop.request;
        in_time.patience = in_time.patience.ofOneSetup(walk.setupsLeft());
        PlannedStage planned =
            planStage(*stage, shop.with(in_time), SetupProgress(progress, stages.size(), setups.size()));
        const bool in_vain = !stages.empty() && stage->setup.chosen && cutsNothing(planned.setup);
        // Its features would be a long list of what there was no time for.
        last_in_vain = in_vain && no_time();
        if (last_in_vain) break;
        planned.for_forms = in_vain && repeatsResiduals(planned.setup, stages);
        if (planned.for_forms && !(forms && turnsOverAny(stage->setup, stages))) continue;
        planned.setup.names = std::move(names);
        planned.loose = loosePieces(*stage, planned.removed, shop.tol);
        append(planned.warnings, looseWarnings(planned.loose, stage->setup.id));
        planned.stock = walk.cut(*stage, planned.removed);
        planned.left = walk.left();
        planned.layers = std::move(stage->layers);
        stages.push_back(std::move(planned));
    }
    const std::size_t left_out = walk.setupsLeft() + (last_in_vain ? 1 : 0);
    if (left_out > 0)
        late.push_back({"time-limit", stages.back().setup.setup.id,
                        fmt::format("no time was left for {} more setups (--timeout)", left_out)});
    return stages;
}

}  // namespace stepmill
