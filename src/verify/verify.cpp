// Posted programs against the plan they belong to.

#include "stepmill/verify/verify.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <map>
#include <set>

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/core/parallel.h"
#include "stepmill/plan/books.h"
#include "stepmill/plan/grown_feature.h"
#include "stepmill/plan/hold_stage.h"
#include "stepmill/plan/reduced_feature.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/advice/area_models.h"
#include "stepmill/toolpath/swept_region.h"
#include "verify/prove_form.h"
#include "verify/prove_holding.h"
#include "verify/prove_operation.h"
#include "verify/prove_state.h"
#include "verify/read_path.h"

namespace stepmill {
namespace {

using verify::FeatureState;

/// Numbers in plan.json have six decimals.
constexpr double kWrittenDecimals = 1e-6;

/// Features and what is done, while a setup's program runs.
class SetupProver {
  public:
    SetupProver(const PlanRecord& record, const RecordedSetup& setup, const Tolerances& tol,
                Verification& into)
        : record_(record),
          setup_(setup),
          growth_(growthOf(record.stock, setup.part_to_setup)),
          file_(setup.program),
          tol_(tol),
          into_(into) {}

    void prove(const std::vector<ReadProgram>& programs) {
        if (programs.empty() && !setup_.within_travel) return;
        verify::TravelProver travel(record_.machine,
                                    farthestBackMm(setup_.stock_size_mm.y(), growth_, setup_.fixtures),
                                    into_.failures);
        for (const ReadProgram& program : programs) {
            program_ = &program;
            file_ = program.file;
            if (setup_.within_travel) travel.prove(program);
            verify::proveLeaps(program, safeZ(), record_.machine.home_by != HomeBy::Nothing, into_.failures);
            verify::proveTools(program, toolNumbers(), into_.failures);
            for (const ReadOperation& operation : program.operations)
                proveOne(verify::withGlidesAsRapids(operation, plannedOf(operation), record_.machine));
        }
        for (const std::string& id : setup_.operation_ids)
            if (done_.count(id) == 0)
                into_.failures.push_back({file_, 0, id, "the program does not have this operation"});
    }

  private:
    /// Neither stock, as high as it may be, nor fixture stands higher.
    double safeZ() const { return std::max(growth_.top_mm, highestFixtureMm(setup_.fixtures)); }

    std::set<int> toolNumbers() const {
        std::set<int> numbers;
        for (const std::string& id : setup_.operation_ids)
            numbers.insert(record_.operations.at(id).tool.number);
        return numbers;
    }

    void proveOne(const ReadOperation& operation) {
        const RecordedOperation& planned = plannedOf(operation);
        OperationProof proof{operation.id, planned.feature_id, planned.tool.id, file_, operation.line};
        const verify::Findings findings{file_, proof, into_.failures};
        verify::proveStates(*program_, operation, planned, findings);
        verify::proveFeeds(*program_, operation, planned, record_.machine.max_feed_mm_per_min, findings);
        if (planned.role == Role::Form)
            proveForm(operation, planned, findings);
        else
            proveInFeature(operation, planned, findings);
        into_.operations.push_back(proof);
    }

    void proveForm(const ReadOperation& operation, const RecordedOperation& planned,
                   const verify::Findings& findings) {
        for (const std::string& id : setup_.operation_ids)
            if (record_.operations.at(id).role != Role::Form && done_.count(id) == 0)
                findings.add(operation.line,
                             fmt::format("runs before {}, which clears what it counts on", id));
        const FormGround& ground = record_.forms.at(planned.feature_id);
        StandingStairs& stairs = stairs_.try_emplace(ground.id, ground, tol_).first->second;
        verify::proveFormMoves(operation, planned, ground, tol_, findings);
        verify::proveFormCut(operation, planned, tol_, stairs, findings);
        if (planned.holes > 0)
            verify::proveDwells(operation, planned, planned.z_floor_mm,
                                static_cast<std::size_t>(planned.holes), findings);
        done_.insert(operation.id);
    }

    void proveInFeature(const ReadOperation& operation, const RecordedOperation& planned,
                        const verify::Findings& findings) {
        FeatureState& state = stateOf(planned.feature_id);
        proveOnStock(operation, planned, state, findings);
        proveCuts(operation, planned, state, findings);
        const Region cleared = verify::cleared(operation, planned, state.feature, tol_);
        const double down_to_mm = verify::clearedDownTo(planned, state.feature);
        for (verify::StandingAbove& above : state.standing)
            if (!cleared.empty() && above.z_mm >= down_to_mm - verify::kSamePostedHeightMm)
                above.region = subtract(above.region, cleared, tol_);
        done_.insert(operation.id);
        const bool last = isLastOfFeature(planned);
        // At the end what roughing left on the floor must be gone too.
        const double floor_z_mm = last ? state.standing.front().z_mm : planned.z_floor_mm;
        const std::vector<Region> left = leftOf(planned.feature_id, floor_z_mm, state);
        for (const Region& piece : left)
            findings.proof.left_mm2 += area(piece);
        if (last) checkLeft(operation, planned.feature_id, floor_z_mm, state, left, findings);
    }

    /// The cuts on what the setup's operations have left of the feature so far; then these are gone too.
    void proveCuts(const ReadOperation& operation, const RecordedOperation& planned, FeatureState& state,
                   const verify::Findings& findings) const {
        if (!state.ground) return;
        if (planned.rating)
            verify::proveCuts(*program_, operation, planned, *state.ground, *record_.cut_material,
                              record_.machine, findings);
        if (planned.engagement_deg > 0)
            verify::proveEngagement(operation, planned, *state.ground, state.feature.top_z_mm, findings);
        if (planned.tool.isTap() || planned.tool.isSpot()) return;
        std::vector<Move> moves;
        for (const ReadMove& read : operation.moves)
            moves.push_back(read.fed.move);
        state.ground->add(operation.start, moves, planned.tool.radius_mm());
    }

    /// Is it asked of some operation what its moves cut? Plans that rate operations tell the material that
    /// is cut; see record/plan_rules.h.
    bool asksWhatMovesCut(const std::string& feature_id) const {
        return std::any_of(record_.operations.begin(), record_.operations.end(), [&](const auto& entry) {
            return entry.second.feature_id == feature_id &&
                   (entry.second.rating || entry.second.engagement_deg > 0);
        });
    }

    const RecordedOperation& plannedOf(const ReadOperation& operation) const {
        const auto found = record_.operations.find(operation.id);
        const bool ours = found != record_.operations.end() && found->second.setup_id == setup_.id;
        if (!ours)
            throw Error(ErrorCode::InvalidCatalog, fmt::format("{}, line {}", file_, operation.line),
                        fmt::format("the plan has no operation '{}' in {}", operation.id, setup_.id));
        if (done_.count(operation.id) > 0)
            throw Error(ErrorCode::InvalidCatalog, fmt::format("{}, line {}", file_, operation.line),
                        fmt::format("operation '{}' stands twice in the program", operation.id));
        return found->second;
    }

    /// Down to where the operation's height matters to what stands: a tap's tip goes on below the floor of a
    /// through hole.
    static double lowestStanding(const RecordedOperation& operation, const Feature& feature) {
        return operation.tool.isTap() ? std::max(operation.z_floor_mm, feature.floor_z_mm)
                                      : operation.z_floor_mm;
    }

    FeatureState& stateOf(const std::string& id) {
        const auto found = states_.find(id);
        if (found != states_.end()) return found->second;
        const Feature& feature = record_.features.at(id).feature;
        FeatureState state;
        state.feature = asFound(feature, by_id_, setup_.fixtures, growth_, tol_);
        if (asksWhatMovesCut(id)) state.ground.emplace(state.feature.target, state.feature.top_z_mm);
        state.safe_z_mm = safeZ();
        std::set<double> heights;
        for (const auto& [operation_id, operation] : record_.operations)
            if (operation.feature_id == id) {
                const double floor_z_mm = lowestStanding(operation, feature);
                heights.insert({floor_z_mm, floor_z_mm - operation.leaves.floors_mm});
                // Over a flat floor a drill alone clears its whole width down to where its point begins.
                if (operation.tool.isDrill()) heights.insert(verify::clearedDownTo(operation, state.feature));
            }
        for (const double z_mm : heights)
            if (state.standing.empty() || z_mm > state.standing.back().z_mm + verify::kSamePostedHeightMm)
                state.standing.push_back({z_mm, state.feature.target});
        return states_.emplace(id, std::move(state)).first->second;
    }

    /// Moves against what stands: where features above are not wholly cut yet, beside what is left of them.
    void proveOnStock(const ReadOperation& operation, const RecordedOperation& planned, FeatureState& state,
                      const verify::Findings& findings) {
        const std::vector<std::string> undone = undoneAbove(planned);
        FeatureState beside_standing;
        if (!undone.empty()) {
            beside_standing.standing = state.standing;
            beside_standing.safe_z_mm = state.safe_z_mm;
            beside_standing.feature = beside(state.feature, standingAbove(undone), tol_);
        }
        const FeatureState& now = undone.empty() ? state : beside_standing;
        const std::size_t failures = into_.failures.size();
        verify::proveMoves(operation, planned, now, tol_, findings);
        verify::proveDrilling(operation, planned, now, findings);
        verify::proveStarting(operation, planned, now, findings);
        verify::proveSizing(operation, planned, now, tol_, findings);
        verify::proveTapping(*program_, operation, planned, now, setup_.fixtures, tol_, findings);
        verify::proveHolder(operation, planned, now, tol_, findings);
        verify::proveDepths(operation, planned, now, tol_, findings);
        if (into_.failures.size() == failures) return;
        for (const std::string& id : undone)
            findings.add(operation.line, fmt::format("runs before {}, which clears {} above it", id,
                                                     record_.operations.at(id).feature_id));
    }

    /// Operations of features above that have not run yet.
    std::vector<std::string> undoneAbove(const RecordedOperation& planned) const {
        std::set<std::string> above;
        for (const CutFeature& ancestor :
             ancestorsOf(record_.features.at(planned.feature_id).feature, by_id_))
            above.insert(ancestor.feature->id);
        std::vector<std::string> undone;
        for (const std::string& id : setup_.operation_ids)
            if (above.count(record_.operations.at(id).feature_id) > 0 && done_.count(id) == 0)
                undone.push_back(id);
        return undone;
    }

    /// What the features of these operations still have over their floors; crumbs are cut in passing.
    std::vector<Standing> standingAbove(const std::vector<std::string>& undone) {
        std::set<std::string> features;
        for (const std::string& id : undone)
            features.insert(record_.operations.at(id).feature_id);
        std::vector<Standing> standing;
        for (const std::string& id : features) {
            const FeatureState& above = stateOf(id);
            for (Region& piece : leftOf(id, above.standing.front().z_mm, above))
                if (area(piece) > kCrumbMm2) standing.push_back({std::move(piece), above.feature.top_z_mm});
        }
        return standing;
    }

    bool isLastOfFeature(const RecordedOperation& planned) const {
        return std::all_of(
            setup_.operation_ids.begin(), setup_.operation_ids.end(), [&](const std::string& id) {
                return record_.operations.at(id).feature_id != planned.feature_id || done_.count(id) > 0;
            });
    }

    /// What stands over a height, less what the plan names as standing down to there; pieces too small to be
    /// anything left out, the largest first.
    std::vector<Region> leftOf(const std::string& feature_id, double floor_z_mm,
                               const FeatureState& state) const {
        std::vector<Region> named;
        const RecordedFeature& recorded = record_.features.at(feature_id);
        const double depth_mm = recorded.feature.top_z_mm - floor_z_mm;
        for (const Residual& residual : recorded.residual) {
            // Area, height and volume are rounded in the file.
            const double rounding_mm3 = kWrittenDecimals * (1 + depth_mm + 2 * residual.area_mm2);
            // A drill's point leaves the rim of the floor alone.
            if (residual.reason == Reason::DrillPoint ||
                residual.volume_mm3 >= residual.area_mm2 * depth_mm - rounding_mm3)
                named.push_back(residual.region);
        }
        const Region& found = state.standingAt(floor_z_mm);
        // What the stock has too much of is no work that the plan must do.
        const bool has_more = growth_.side_mm > 0 && !found.empty();
        const Region standing = has_more ? intersect(found, recorded.feature.target, tol_) : found;
        const bool all_named = standing.empty() || named.empty();
        std::vector<Region> pieces = toolpath::piecesBeyondSkins(
            all_named ? standing : subtract(standing, unite(named, tol_), tol_), tol_);
        std::stable_sort(pieces.begin(), pieces.end(),
                         [](const Region& one, const Region& other) { return area(one) > area(other); });
        return pieces;
    }

    void checkLeft(const ReadOperation& operation, const std::string& feature_id, double floor_z_mm,
                   const FeatureState& state, const std::vector<Region>& left,
                   const verify::Findings& findings) const {
        // As much as the planner takes for full access.
        if (left.empty() || findings.proof.left_mm2 <= kFullAccessShare * area(state.feature.target)) return;
        Leftover leftover{setup_.id,
                          feature_id,
                          {},
                          findings.proof.left_mm2,
                          state.feature.top_z_mm - floor_z_mm,
                          area(state.feature.target)};
        for (const Region& piece : left)
            append(leftover.region, piece);
        into_.leftovers.push_back(std::move(leftover));
        const Box2 box = boundingBox(left.front());
        findings.add(
            operation.line,
            fmt::format(
                "leaves {:.4g} mm2 of {} in {} places that the plan does not name, the largest X{:.3f} "
                "Y{:.3f} to X{:.3f} Y{:.3f}",
                findings.proof.left_mm2, state.feature.id, left.size(), box.min().x(), box.min().y(),
                box.max().x(), box.max().y()));
    }

    const PlanRecord& record_;
    const CutById by_id_ = [this](const std::string& id) {
        const RecordedFeature& recorded = record_.features.at(id);
        return CutFeature{&recorded.feature, &recorded.residual};
    };
    const RecordedSetup& setup_;
    const StockGrowth growth_;
    const ReadProgram* program_ = nullptr;
    std::string file_;
    const Tolerances& tol_;
    Verification& into_;
    std::map<std::string, FeatureState> states_;
    std::map<std::string, StandingStairs> stairs_;  ///< of form grounds whose operations have begun, by id
    std::set<std::string> done_;
};

}  // namespace

void verifySetup(const PlanRecord& record, const RecordedSetup& setup,
                 const std::vector<ReadProgram>& programs, const Tolerances& tol, Verification& into) {
    SetupProver(record, setup, tol, into).prove(programs);
    verify::proveHolding(record, setup, programs, tol, into);
}

bool leavesUnasked(const PlanRecord& record, const Tolerances& tol) {
    const bool roughing = record.request && record.request->roughing;
    return !leavesNothing(record.books, roughing, tol);
}

namespace {

/// The proof of one setup, or what ended it.
struct SetupProof {
    Verification verification;
    std::exception_ptr ended;
};

SetupProof proofOf(const RecordedPlan& plan, const RecordedSetup& setup, const Tolerances& tol) {
    SetupProof proof;
    try {
        verifySetup(plan.record, setup, readPrograms(plan.files, setup), tol, proof.verification);
    } catch (...) {
        proof.ended = std::current_exception();
    }
    return proof;
}

template <typename Value>
void append(std::vector<Value>& to, std::vector<Value>&& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// Setups side by side: none needs to know what was found in another.
Verification proofOfSetups(const RecordedPlan& plan, const Tolerances& tol) {
    const std::vector<RecordedSetup>& setups = plan.record.setups;
    std::vector<SetupProof> proofs(setups.size());
    parallelFor(setups.size(), [&](std::size_t i) { proofs[i] = proofOf(plan, setups[i], tol); });
    Verification whole;
    for (SetupProof& proof : proofs) {
        if (proof.ended) std::rethrow_exception(proof.ended);
        append(whole.operations, std::move(proof.verification.operations));
        append(whole.failures, std::move(proof.verification.failures));
        append(whole.leftovers, std::move(proof.verification.leftovers));
    }
    return whole;
}

}  // namespace

Verification verifyRecorded(const RecordedPlan& plan, const Tolerances& tol) {
    const PlanRecord& record = plan.record;
    Verification verification = proofOfSetups(plan, tol);
    std::vector<ReasonVolume> left = record.books.residual_by_reason;
    left.insert(left.end(), record.books.unreachable_by_reason.begin(),
                record.books.unreachable_by_reason.end());
    double left_mm3 = 0;
    for (const ReasonVolume& entry : left)
        left_mm3 += entry.volume_mm3;
    if (left_mm3 > record.rounding_mm3 || leavesUnasked(record, tol)) verification.left = std::move(left);
    verification.threads_missing = record.threads_missing;
    return verification;
}

Verification verifyPlan(const PlanFiles& files, const Tolerances& tol) {
    return verifyRecorded({files, planRecordFromText(files.plan_json, tol)}, tol);
}

}  // namespace stepmill
