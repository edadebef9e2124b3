#include "plan/features/sized_holes.h"

#include <fmt/format.h>

#include "stepmill/feature/describe_boundary.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/machine_limits.h"
#include "stepmill/sequence/sizing.h"
#include "stepmill/sequence/tapping.h"

namespace stepmill {
namespace {

/// The holes with walls that much nearer to their axes.
Feature narrower(Feature holes, double diameter_mm, const Tolerances& tol) {
    Region discs;
    for (const Vec2& axis : holeCentres(holes)) {
        const Region disc = makeCircle(axis, diameter_mm / 2);
        append(discs, disc);
    }
    holes.obstruction = unite(holes.obstruction, subtract(holes.target, discs, tol), tol);
    holes.target = std::move(discs);
    holes.area_mm2 = area(holes.target);
    holes.volume_mm3 = holes.area_mm2 * holes.depth_mm();
    describeBoundary(holes, tol);
    return holes;
}

class SizedHoles {
  public:
    SizedHoles(const Feature& holes, const HoleEntry& entry, const PlanningShop& shop,
               const ToolLibrary& library, double retract_z_mm, const PlanHoles& plan_holes)
        : holes_(holes),
          entry_(entry),
          shop_(shop),
          library_(library),
          retract_z_mm_(retract_z_mm),
          plan_holes_(plan_holes) {}

    SizedSequence plan() {
        const ToolType type = entry_.make == HoleMaking::Bore ? ToolType::Boring : ToolType::Reamer;
        best_.trouble =
            fmt::format("the library has no {} for {}", type == ToolType::Boring ? "boring head" : "reamer",
                        shop_.request.sequence.material);
        for (const ToolAssembly& sizer : library_.tools)
            if (sizer.type == type && sizer.cuttingFor(shop_.request.sequence.material) != nullptr)
                weigh(sizer);
        if (best_.sequence) best_.trouble.clear();
        return std::move(best_);
    }

  private:
    void weigh(const ToolAssembly& sizer) {
        const double bore_mm = 2 * holeRadiusMm(holes_);
        const DiameterRange before = boreBefore(sizer, bore_mm);
        Feature drilled = holes_;
        drilled.drilled = before;
        const bool any = weigh(sizer, plan_holes_(drilled, shop_.drills), bore_mm);
        // No mill makes the point that a drilled hole ends in.
        if (any && holes_.point_mm > 0) return;
        weigh(sizer, plan_holes_(narrower(holes_, before.most_mm, shop_.tol), library_), before.most_mm);
    }

    /// \param planned_mm  as wide as the holes were planned
    /// \return  is that a way?
    bool weigh(const ToolAssembly& sizer, std::optional<ToolSequence> made, double planned_mm) {
        if (!made || made->steps.empty()) return false;
        const SequenceStep& last = made->steps.back();
        const ToolAssembly& cutter = library_.tool(last.tool_id);
        const bool drilled = last.role == Role::Drill;
        const std::optional<double> bored_to_z = boredToZ(holes_, *made, library_);
        if (!bored_to_z) return false;
        const SizingTask task{holes_, *entry_.fit, *bored_to_z, retract_z_mm_};
        if (std::string trouble = sizingTrouble(task, sizer); !trouble.empty()) {
            best_.trouble = std::move(trouble);
            return false;
        }
        const CuttingData cutting =
            limitedBy(shop_.machine, *sizer.cuttingFor(shop_.request.sequence.material));
        SequenceStep step = sizingStep(task, sizer, cutting, shop_.machine);
        const double weight = weightOf(*made) + weightOf(edgeCost(step.path.totals, sizer, shop_.machine));
        if (best_.sequence && weight >= weight_) return true;
        made->residual = leftBelow(task, sizer, drilled ? cutter.diameter_mm : planned_mm);
        made->sizing.push_back(std::move(step));
        weight_ = weight;
        best_.sequence = std::move(made);
        return true;
    }

    std::vector<Residual> leftBelow(const SizingTask& task, const ToolAssembly& sizer,
                                    double before_mm) const {
        const double left_mm3 = leftByLeadMm3(task, sizer, before_mm);
        if (left_mm3 <= kVolumeRoundingMm3) return {};
        Residual ring;
        ring.region = holes_.target;
        ring.area_mm2 = holes_.area_mm2;
        ring.volume_mm3 = left_mm3;
        ring.reason = {Reason::DrillPoint, {}};
        ring.advice =
            fmt::format("a hole {:.4g} mm deeper: {} gets to its width that far over the end of the bore",
                        sizedToZ(holes_, sizer, task.bored_to_z_mm) - holes_.floor_z_mm, sizer.id);
        return {ring};
    }

    double weightOf(const EdgeCost& cost) const {
        return stepmill::weightOf(cost, shop_.request.sequence.objective);
    }
    double weightOf(const ToolSequence& sequence) const {
        return shop_.request.sequence.objective == Objective::Time ? sequence.motion_s : sequence.cost;
    }

    const Feature& holes_;
    const HoleEntry& entry_;
    const PlanningShop& shop_;
    const ToolLibrary& library_;
    double retract_z_mm_;
    const PlanHoles& plan_holes_;
    SizedSequence best_;
    double weight_ = 0;
};

}  // namespace

SizedSequence sizedSequence(const Feature& holes, const HoleEntry& entry, const PlanningShop& shop,
                            const ToolLibrary& library, double retract_z_mm, const PlanHoles& plan_holes) {
    return SizedHoles(holes, entry, shop, library, retract_z_mm, plan_holes).plan();
}

}  // namespace stepmill
