// Roughing that leaves an allowance, and the steps that take it off.

#include "sequence/steps/finishing.h"

#include <fmt/format.h>

#include "sequence/dag/step_paths.h"
#include "sequence/holder/holder_limits.h"
#include "sequence/holder/tool_areas.h"
#include "stepmill/access/collision.h"
#include "stepmill/access/slivers.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/toolpath/finish_walls.h"
#include "stepmill/toolpath/step_over.h"

namespace stepmill {
namespace {

/// The feature with its walls moved in.
Feature movedIn(const FeatureGround& ground, double walls_mm) {
    Feature feature = ground.feature();
    if (walls_mm <= 0) return feature;
    feature.obstruction = ground.obstructionOffset(walls_mm);
    feature.target = ground.walledIn() ? ground.targetOffset(-walls_mm)
                                       : subtract(feature.target, feature.obstruction, ground.tolerances());
    feature.area_mm2 = area(feature.target);
    feature.volume_mm3 = feature.area_mm2 * feature.depth_mm();
    return feature;
}

/// The feature as roughing sees it: the floor raised too.
Feature raised(const Feature& feature, double floors_mm) {
    return floors_mm > 0 ? withFloor(feature, feature.floor_z_mm + floors_mm) : feature;
}

/// The layer that stays on the floor of a roughed feature.
Feature layerUnder(Feature roughed, const Feature& whole) {
    roughed.top_z_mm = roughed.floor_z_mm;
    roughed.floor_z_mm = whole.floor_z_mm;
    return roughed;
}

/// Steps with one allowance; `trouble` says why there cannot be any.
class AllowanceTrial {
  public:
    AllowanceTrial(const DagTask& task, const std::vector<const Candidate*>& used,
                   const FinishAllowance& allowance)
        : task_(task),
          feature_(task.ground.feature()),
          tol_(task.ground.tolerances()),
          used_(used),
          allowance_(allowance),
          moved_in_(movedIn(task.ground, allowance.walls_mm), tol_),
          rough_(raised(moved_in_.feature(), allowance.floors_mm), tol_),
          layer_(layerUnder(rough_.feature(), feature_), tol_) {}

    std::vector<SequenceStep> make() {
        if (!findAreas() || !findStrip()) return {};
        std::vector<SequenceStep> steps;
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
            const Candidate* before = i == 0 ? nullptr : &candidates_[i - 1];
            addStep(steps, roughStep(before, candidates_[i]), i);
            if (allowance_.floors_mm <= 0) continue;
            SequenceStep floor = floorStep(before, candidates_[i]);
            floor_residual_ = toolpath::leftBy(floor.path, floor_residual_, feature_.floor_z_mm,
                                               candidates_[i].tool->radius_mm(), tol_);
            addStep(steps, std::move(floor), i);
        }
        if (isMuch(floor_residual_)) {
            trouble_ = "passes over the floor leave some of it";
            return {};
        }
        if (!strip_.empty()) {
            SequenceStep walls = wallStep();
            if (!trouble_.empty()) return {};
            if (isMuch(toolpath::leftBy(walls.path, strip_, feature_.floor_z_mm, last().tool->radius_mm(),
                                        tol_))) {
                trouble_ = fmt::format("a pass along the walls by {} leaves some of it", last().tool->id);
                return {};
            }
            addStep(steps, std::move(walls), candidates_.size() - 1);
        }
        if (steps.empty()) trouble_ = "there is nothing to rough beside one";
        return steps;
    }

    const std::string& trouble() const { return trouble_; }

  private:
    const Candidate& last() const { return *used_.back(); }

    /// What the tools reach beside the allowance on walls, down to the floor: shank and holder go there too.
    bool findAreas() {
        if (moved_in_.feature().target.empty()) {
            trouble_ = "it is too narrow for one";
            return false;
        }
        reaches_.reserve(used_.size());
        for (const Candidate* tool : used_) {
            reaches_.push_back(reachFor(moved_in_, *tool->tool, task_.options));
            ToolReach& reach = reaches_.back();
            if (const Exclusion* excluded = reach.exclusion()) {
                trouble_ = fmt::format("with one {} would not do: {}", tool->tool->id, excluded->text);
                return false;
            }
            candidates_.push_back(*tool);
            candidates_.back().reach = &reach;
            candidates_.back().cleared = candidates_.back().own = &reach.cutter;
            candidates_.back().coverable_mm2 = reach.cutter.coverable_area_mm2;
        }
        return true;
    }

    bool isMuch(const Region& residual) const {
        return area(access::withoutSliverComponents(residual, tol_)) > sameArea(feature_, tol_);
    }

    /// What roughing leaves on the floor, and along the walls where the last tool can reach.
    bool findStrip() {
        std::vector<Region> coverable;
        for (const ToolReach& reach : reaches_)
            coverable.push_back(reach.cutter.coverable);
        const Region roughed = unite(coverable, tol_);
        if (allowance_.floors_mm > 0) floor_residual_ = roughed;
        if (allowance_.walls_mm <= 0) return true;
        strip_ = access::withoutSliverComponents(subtract(last().cleared->coverable, roughed, tol_), tol_);
        if (strip_.empty()) return true;
        const auto widest = ClearanceDiagram(strip_, tol_).largestInscribedDisc();
        if (!widest || 2 * widest->radius_mm <= kWidestFinishAllowances * allowance_.walls_mm) return true;
        trouble_ =
            fmt::format("{} does not pass X{:.2f} Y{:.2f} with one: {:.3g} mm would stay there",
                        last().tool->id, widest->centre.x(), widest->centre.y(), 2 * widest->radius_mm);
        return false;
    }

    void addStep(std::vector<SequenceStep>& steps, SequenceStep step, std::size_t tool) const {
        if (step.path.moves.empty()) return;
        // Proven against walls moved in.
        step.proof.least_clearance_mm += step.leaves.walls_mm;
        step.least_stick_out_mm = stickOut(tool);
        steps.push_back(std::move(step));
    }

    double stickOut(std::size_t tool) const {
        return std::max(leastStickOutMm(task_.ground, *used_[tool]->tool, *used_[tool]->own),
                        leastStickOutMm(moved_in_, *used_[tool]->tool, reaches_[tool].cutter));
    }

    DagTask on(const FeatureGround& ground) const {
        return {ground,        candidates_,   task_.ends,         task_.around,
                task_.options, task_.machine, task_.retract_z_mm, nullptr};
    }

    SequenceStep roughStep(const Candidate* before, const Candidate& tool) const {
        SequenceStep step = makeStep(on(rough_), before, tool);
        step.leaves = allowance_;
        return step;
    }

    /// The tool's own ground down to the floor. What it has not roughed may stand up to the feature's top.
    SequenceStep floorStep(const Candidate* before, Candidate tool) const {
        CutterArea beside = *tool.own;
        const Region& stays = beside.obstructionIn(rough_.feature());
        const Region stands =
            access::withoutSliverComponents(subtract(rough_.feature().target, beside.accessible, tol_), tol_);
        if (!stands.empty()) beside.wider_obstruction = unite(stays, stands, tol_);
        tool.cleared = tool.own = &beside;
        SequenceStep step = makeStep(on(layer_), before, tool);
        step.role = Role::Finish;
        step.path.pattern = "floor, " + step.path.pattern;
        step.leaves.walls_mm = allowance_.walls_mm;
        return step;
    }

    /// Sets `trouble_` where the moves are not proven.
    SequenceStep wallStep() {
        const CutterArea& reached = *last().own;
        ClearingTask clearing = clearingTaskOf(feature_, task_.around, reached, task_.retract_z_mm);
        clearing.cleared_centres = reaches_.back().cutter.free_centres;
        SequenceStep step;
        step.tool_id = last().tool->id;
        step.role = Role::Finish;
        step.speed_rpm = last().cutting.speed_rpm;
        step.area.area = strip_;
        step.area.new_area_mm2 = area(strip_);
        // Set out farther, a tool only has more room.
        const ToolAssembly shortest = setTo(*last().tool, stickOut(used_.size() - 1));
        for (const access::Blocker& blocker : access::blockers(feature_, shortest))
            clearing.kept_off.push_back({feature_.obstacles[blocker.obstacle].section, blocker.radius_mm});
        step.path = toolpath::finishWalls({clearing, strip_, allowance_.walls_mm}, *last().tool,
                                          last().cutting, task_.machine, tol_);
        step.proof = prove(step.path, clearing, last().tool->radius_mm(), tol_);
        if (step.proof.least_clearance_mm < -tol_.gouge_mm || !step.proof.rapids_clear)
            trouble_ =
                fmt::format("a pass along the walls by {} is not clear of what stands", last().tool->id);
        return step;
    }

    const DagTask& task_;
    const Feature& feature_;
    const Tolerances& tol_;
    const std::vector<const Candidate*>& used_;
    FinishAllowance allowance_;
    FeatureGround moved_in_;
    FeatureGround rough_;
    FeatureGround layer_;
    std::vector<ToolReach> reaches_;  ///< on moved_in_, of each tool; candidates point into it
    std::vector<Candidate> candidates_;
    Region floor_residual_;  ///< until the floor steps are made: all of it
    Region strip_;
    std::string trouble_;
};

/// What the feature can have of what was asked for, as far as numbers tell.
FinishAllowance allowanceFor(const DagTask& task, const std::vector<const Candidate*>& used,
                             std::string& less) {
    const Feature& feature = task.ground.feature();
    FinishAllowance allowance = task.options.finish;
    if (feature.closed_length_mm <= task.ground.tolerances().sliver_mm) allowance.walls_mm = 0;
    if (feature.through) allowance.floors_mm = 0;
    // Counted from the blank as drawn (Z0): what it may stand out more is roughed away, but may not be there.
    const double depth_mm = std::min(feature.top_z_mm, 0.0) - feature.floor_z_mm;
    if (allowance.floors_mm > 0 && depth_mm <= 2 * allowance.floors_mm) {
        less = fmt::format("none on the floor: the feature is {:.3g} mm deep", depth_mm);
        allowance.floors_mm = 0;
    }
    for (const Candidate* tool : used) {
        const double step_over_mm = toolpath::usedStepOver(tool->cutting, tool->tool->radius_mm());
        if (allowance.walls_mm > step_over_mm) {
            less = fmt::format("none on walls: it is more than the step-over of {}", tool->tool->id);
            allowance.walls_mm = 0;
        }
        if (tool->cutting.step_down_mm > 0 && allowance.floors_mm > tool->cutting.step_down_mm) {
            less = fmt::format("none on the floor: it is more than the step-down of {}", tool->tool->id);
            allowance.floors_mm = 0;
        }
    }
    return allowance;
}

/// Do all tools do alone what they reach, so that the last one reaches all?
std::string othersNeeded(const std::vector<const Candidate*>& used) {
    for (const Candidate* tool : used) {
        if (tool->drill()) return fmt::format("none: {} drills it first", tool->tool->id);
        if (tool->hasSurrogates())
            return fmt::format("none: other tools clear what the holder keeps {} from", tool->tool->id);
        if (tool->isLimited()) return fmt::format("none: the holder keeps {} off part of it", tool->tool->id);
    }
    return {};
}

}  // namespace

AllowanceSteps stepsWithAllowance(const DagTask& task, const std::vector<const Candidate*>& used) {
    AllowanceSteps made;
    if (!task.options.finish.any() || used.empty() || used.back()->drill()) return made;
    made.less = othersNeeded(used);
    if (!made.less.empty()) return made;
    FinishAllowance allowance = allowanceFor(task, used, made.less);
    while (allowance.any()) {
        AllowanceTrial trial(task, used, allowance);
        made.steps = trial.make();
        if (!made.steps.empty()) break;
        const bool of_walls = allowance.walls_mm > 0;
        made.less = fmt::format("none on {}: {}", of_walls ? "walls" : "the floor", trial.trouble());
        (of_walls ? allowance.walls_mm : allowance.floors_mm) = 0;
    }
    return made;
}

}  // namespace stepmill
