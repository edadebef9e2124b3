// From areas to a path over all depths of cut.

#include <algorithm>
#include <cmath>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/toolpath/toolpath.h"
#include "toolpath/emit.h"
#include "toolpath/layer_script.h"
#include "toolpath/passes.h"
#include "toolpath/ring_family.h"

namespace stepmill {

namespace {

/// Where the cutting data name no ramp angle.
constexpr double kDefaultRampAngleDeg = 3;
/// Less of a ring than this is not worth a move of its own [mm].
constexpr double kLeastLevelMm = 0.01;
/// A depth that exceeds whole steps by no more than this share of a step takes no further layer.
constexpr double kLayerExcess = 1e-9;

int layersFor(double depth_mm, double step_down_mm) {
    if (step_down_mm <= 0) return 1;
    return std::max(1, static_cast<int>(std::ceil(depth_mm / step_down_mm - kLayerExcess)));
}

double rampAngle(const CuttingData& cutting) {
    return degToRad(cutting.ramp_angle_deg > 0 ? cutting.ramp_angle_deg : kDefaultRampAngleDeg);
}

Toolpath emptyPath(const ClearingTask& task, double radius_mm, const CuttingData& cutting,
                   const Machine& machine) {
    Toolpath path;
    path.pattern = "contour-parallel";
    path.step_over_mm = toolpath::usedStepOver(cutting, radius_mm);
    const double depth_mm = task.top_z_mm - task.floor_z_mm;
    path.layers = layersFor(depth_mm, cutting.step_down_mm);
    path.step_down_mm = depth_mm / path.layers;
    const double limit = machine.max_feed_mm_per_min;
    const auto limited = [&](double feed) { return limit > 0 ? std::min(feed, limit) : feed; };
    path.feed_mm_per_min = limited(cutting.feed_mm_per_min);
    path.plunge_feed_mm_per_min = limited(cutting.plunge_feed_mm_per_min > 0 ? cutting.plunge_feed_mm_per_min
                                                                             : cutting.feed_mm_per_min);
    path.ramp_feed_mm_per_min =
        rampFeed(path.feed_mm_per_min, path.plunge_feed_mm_per_min, rampAngle(cutting));
    return path;
}

/// Writes component after component, each over all depths of cut.
class ComponentWriter {
  public:
    ComponentWriter(const ClearingTask& task, const toolpath::PassSet& set, double radius_mm,
                    double angle_rad, const Machine& machine, const Tolerances& tol, Toolpath& path)
        : task_(task),
          set_(set),
          radius_mm_(radius_mm),
          angle_rad_(angle_rad),
          tol_(tol),
          path_(path),
          writer_(path),
          rates_{(path.step_down_mm + toolpath::kDescentStartMm) / std::tan(angle_rad),
                 path.feed_mm_per_min,
                 path.plunge_feed_mm_per_min,
                 machine.rapid_mm_per_min,
                 path.step_down_mm + toolpath::kApproachMm,
                 toolpath::kApproachMm} {}

    void write() {
        for (int i = 0; i < static_cast<int>(set_.components.size()); ++i) {
            const bool has_passes =
                std::any_of(set_.passes.begin(), set_.passes.end(),
                            [&](const toolpath::Pass& pass) { return pass.component == i; });
            if (!has_passes) continue;
            const toolpath::LayerScript layer =
                scriptLayer(task_, set_, i, last_, radius_mm_, path_.step_over_mm, rates_, tol_);
            if (layer.steps.empty()) continue;
            if (!writeLoneRing(layer)) writeLayers(layer);
            last_ = writer_.at();
        }
        if (!path_.moves.empty()) writer_.retract();
    }

  private:
    double levelOf(int layer) const {
        return layer == path_.layers ? task_.floor_z_mm : task_.top_z_mm - layer * path_.step_down_mm;
    }

    toolpath::LayerHeights heights(int from_layer, int to_layer) const {
        return {levelOf(from_layer), levelOf(to_layer), task_.top_z_mm, task_.retract_z_mm, angle_rad_};
    }

    void writeLayers(const toolpath::LayerScript& layer) {
        for (int i = 1; i <= path_.layers; ++i) {
            writer_.writeLayer(layer.steps, i == 1 ? layer.first_over : layer.next_over, heights(i - 1, i));
        }
    }

    /// A lone ring is cut on the way down, one depth of cut a turn at most, and levelled on the floor.
    bool writeLoneRing(const toolpath::LayerScript& layer) {
        const auto* ramp =
            layer.steps.size() == 1 ? std::get_if<toolpath::RampAlong>(&layer.steps[0]) : nullptr;
        if (ramp == nullptr || !ramp->closed) return false;
        const double turn_mm = length(ramp->curve);
        if (turn_mm > rates_.descent_mm + kLeastLevelMm) {
            std::vector<toolpath::LayerHeights> layers;
            for (int i = 1; i <= path_.layers; ++i)
                layers.push_back(heights(i - 1, i));
            writer_.writeRing(ramp->curve, rates_.descent_mm, layers);
            return true;
        }
        // A turn at the ramp angle goes no deeper than one depth of cut.
        const double depth_mm = task_.top_z_mm - task_.floor_z_mm + toolpath::kDescentStartMm;
        const double slope = std::min(std::tan(angle_rad_), path_.step_down_mm / turn_mm);
        writer_.writeLayer({toolpath::rampAlong(ramp->curve, true, depth_mm / slope)},
                           toolpath::Over::Retract, heights(0, path_.layers));
        return true;
    }

    const ClearingTask& task_;
    const toolpath::PassSet& set_;
    double radius_mm_;
    double angle_rad_;
    const Tolerances& tol_;
    Toolpath& path_;
    toolpath::MoveWriter writer_;
    toolpath::LinkRates rates_;
    std::optional<Vec2> last_;
};

}  // namespace

Toolpath clearArea(const ClearingTask& task, const ToolAssembly& tool, const CuttingData& cutting,
                   const Machine& machine, const Tolerances& tol) {
    STEPMILL_CHECK(tool.radius_mm() > 0, "a cutter has a diameter");
    STEPMILL_CHECK(cutting.feed_mm_per_min > 0 && machine.rapid_mm_per_min > 0, "feeds are positive");
    STEPMILL_CHECK(task.retract_z_mm >= task.top_z_mm, "retract height below the material");
    Toolpath path = emptyPath(task, tool.radius_mm(), cutting, machine);
    if (task.centres.empty() || task.free_centres.empty() || task.top_z_mm <= task.floor_z_mm) return path;

    using namespace toolpath;
    const std::shared_ptr<const RingFamily> rings =
        task.rings ? task.rings : makeRings(task, tool, cutting, tol);
    STEPMILL_CHECK(rings->radiusMm() == tool.radius_mm() && rings->stepOverMm() == path.step_over_mm,
                   "rings of another tool or step-over");
    const PassSet set = contourParallel(task, *rings, tol);
    if (set.passes.empty()) return path;
    ComponentWriter(task, set, tool.radius_mm(), rampAngle(cutting), machine, tol, path).write();
    path.totals = measure(path, machine);
    return path;
}

}  // namespace stepmill
