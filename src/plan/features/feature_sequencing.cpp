#include "plan/features/feature_sequencing.h"

#include <algorithm>
#include <optional>

#include "plan/features/few_tools.h"
#include "plan/features/sized_holes.h"
#include "plan/operations/retract.h"
#include "stepmill/core/error.h"
#include "stepmill/plan/deep_bands.h"
#include "stepmill/toolpath/adaptive_cutting.h"

namespace stepmill {
namespace {

/// What the turns of a mill take off the walls of a bore at last, where there is no boring head [mm].
constexpr double kTurnedMm = 0.2;

Residual wholeAsResidual(const Feature& feature, StayReason reason, std::string advice) {
    Residual residual;
    residual.region = feature.target;
    residual.area_mm2 = feature.area_mm2;
    residual.volume_mm3 = feature.volume_mm3;
    residual.reason = std::move(reason);
    residual.advice = std::move(advice);
    return residual;
}

/// One feature's way to its sequence.
class FeatureSequencing {
  public:
    FeatureSequencing(const Feature& feature, const Setup& setup, const StockGrowth& growth,
                      const PlanningShop& shop)
        : feature_(feature), setup_(setup), growth_(growth), shop_(shop) {}

    /// \param free  what of the feature is free to be cut
    ToolSequence run(const Feature& free) {
        if (free.target.empty()) return nothingBut({});
        if (shop_.cautionOf(feature_.id).dropped)
            return nothingBut({wholeAsResidual(free, {Reason::NotProven, {}}, "a report of this part")});
        const HoleEntry* entry = shop_.wishes.entryOf(feature_, setup_);
        if (entry != nullptr && entry->make == HoleMaking::Leave)
            return nothingBut({wholeAsResidual(free, {Reason::AsAsked, {}}, "another hole table")});
        const Feature grown = onGrownStock(free, growth_, shop_.tol);
        std::optional<ToolSequence> made = entry != nullptr && entry->fit
                                               ? fittedInTime(grown, *entry)
                                               : sequenceInTime(grown, libraryFor(entry));
        if (!made)
            return nothingBut(
                {wholeAsResidual(free, {Reason::TimeLimit, {}}, "more time (--timeout), or fewer tools")});
        made->residual = onNominalStock(std::move(made->residual), free, grown, shop_.tol);
        const std::vector<Residual>& left = shop_.cautionOf(feature_.id).left;
        made->residual.insert(made->residual.end(), left.begin(), left.end());
        return std::move(*made);
    }

    bool isHasty() const { return hasty_; }

  private:
    ToolSequence nothingBut(std::vector<Residual> residual) const {
        ToolSequence sequence;
        sequence.feature_id = feature_.id;
        sequence.floor_z_mm = feature_.floor_z_mm;
        sequence.residual = std::move(residual);
        return sequence;
    }

    /// \param entry  of the hole table, if it has one for the feature
    const ToolLibrary& libraryFor(const HoleEntry* entry) const {
        const bool drills = entry != nullptr && entry->make == HoleMaking::Drill;
        return drills ? shop_.drills : shop_.libraryOf(feature_.id);
    }

    /// Brought to its fit where some tool can; as without the hole table where none can.
    std::optional<ToolSequence> fittedInTime(const Feature& grown, const HoleEntry& entry) {
        const ToolLibrary& library = shop_.libraryOf(feature_.id);
        SizedSequence sized;
        if (feature_.band)
            sized.trouble = "the hole is cut in several bands";
        else if (isHole(grown.feature_class))
            sized = sizedSequence(
                grown, entry, shop_, library, retract_mm(),
                [&](const Feature& holes, const ToolLibrary& tools) { return sequenceInTime(holes, tools); });
        if (sized.sequence) return sized.sequence;
        std::optional<ToolSequence> made = sequenceInTime(grown, library);
        if (!made) return made;
        if (entry.make == HoleMaking::Bore) {
            std::optional<ToolSequence> turned = turnedInTime(grown, library);
            if (turned && residualVolumeMm3(*turned) <= residualVolumeMm3(*made) + kVolumeRoundingMm3)
                return turned;
        }
        made->not_sized = std::move(sized.trouble);
        return made;
    }

    /// With a mill's turns along the walls at last; nothing where none takes them.
    std::optional<ToolSequence> turnedInTime(Feature bores, const ToolLibrary& library) {
        bores.drilled = DiameterRange{};  // a drill of their size would leave no wall to turn
        FinishAllowance finish = shop_.request.sequence.finish;
        finish.walls_mm = std::max(finish.walls_mm, kTurnedMm);
        std::optional<ToolSequence> made = sequenceInTime(bores, library, finish);
        const auto turns = [](const SequenceStep& step) { return step.role == Role::Finish; };
        const bool turned = made && std::any_of(made->steps.begin(), made->steps.end(), turns);
        return turned ? std::move(made) : std::nullopt;
    }

    /// Of all tools, of a few where these take too long, or nothing where the few do too.
    std::optional<ToolSequence> sequenceInTime(const Feature& grown, const ToolLibrary& library,
                                               std::optional<FinishAllowance> finish = std::nullopt) {
        SequenceOptions options = sequenceOptions();
        if (finish) options.finish = *finish;
        options.deadline = shop_.request.patience.allToolsOfOne();
        if (auto sequence = sequenceBefore(grown, library, options)) return sequence;
        hasty_ = true;
        options.surrogates = SurrogateRule::SingleOrLater;
        options.deadline = shop_.request.patience.fewToolsOfOne();
        auto sequence = sequenceBefore(grown, fewTools(library, options.material), options);
        // Nothing is known of what the other tools could do.
        if (sequence) {
            sequence->lower_bound_s = 0;
            sequence->least = {};
        }
        return sequence;
    }

    /// Nothing where the deadline passes.
    std::optional<ToolSequence> sequenceBefore(const Feature& grown, const ToolLibrary& library,
                                               const SequenceOptions& options) const {
        try {
            return shop_.memory.sequence(grown, library, options, [&] {
                options.deadline.check(grown.id);
                return sequenceTools(grown, library, shop_.machine, options, shop_.tol);
            });
        } catch (const Error& error) {
            if (error.code() != ErrorCode::TimedOut) throw;
            return std::nullopt;
        }
    }

    SequenceOptions sequenceOptions() const {
        SequenceOptions options = asPlanned(shop_.request.sequence);
        if (feature_.band && feature_.band->isUpper()) options.finish.floors_mm = 0;
        const FeatureCaution& caution = shop_.cautionOf(feature_.id);
        if (caution.not_adaptive) options.patterns = notAdaptive(std::move(options.patterns));
        if (caution.plain_ways) options.pattern = Pattern::ContourInsideOut;
        options.retract_mm = retract_mm();
        const auto wish = shop_.request.wishes.find(feature_.id);
        if (wish != shop_.request.wishes.end()) options.first_at_least_mm = wish->second.first_at_least_mm;
        return options;
    }

    double retract_mm() const { return retractMm(setup_, shop_.request.sequence.retract_mm, shop_.machine); }

    const Feature& feature_;
    const Setup& setup_;
    const StockGrowth& growth_;
    const PlanningShop& shop_;
    bool hasty_ = false;
};

}  // namespace

SequencedFeature sequenceFeature(const Feature& feature, const CutById& cut, const KnownSequence& known,
                                 const Setup& setup, const StockGrowth& growth, const PlanningShop& shop) {
    SequencedFeature made;
    try {
        made.free = reduced(feature, cut, setup.fixtures, shop.tol);
        if (const ToolSequence* same = known(made.free)) {
            made.sequence = *same;
            return made;
        }
        FeatureSequencing sequencing(feature, setup, growth, shop);
        made.sequence = sequencing.run(made.free.feature);
        made.hasty = sequencing.isHasty();
        made.sequence.residual.insert(made.sequence.residual.end(), made.free.blocked.begin(),
                                      made.free.blocked.end());
    } catch (const std::exception& error) {
        made.failure = error.what();
        made.sequence = {};
        made.sequence.feature_id = feature.id;
        made.sequence.residual.push_back(
            wholeAsResidual(feature, {Reason::PlanningFailed, made.failure}, "a report of this part"));
    }
    return made;
}

}  // namespace stepmill
