#include "stepmill/core/units.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/sequence/advice/ranking.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/machine_limits.h"

namespace stepmill {
namespace {

/// Adds what the drill does in one feature.
class DrillCount {
  public:
    DrillCount(const ToolAssembly& drill, const Machine& machine, const SequenceOptions& options,
               const Tolerances& tol)
        : drill_(drill),
          machine_(machine),
          cutting_(limitedBy(machine, *drill.cuttingFor(options.material))),
          retract_z_mm_(options.retract_mm > 0 ? options.retract_mm : machine.safe_height_mm),
          tol_(tol),
          row_{drill.id, drill.diameter_mm} {}

    void add(const Feature& feature) {
        if (!isHole(feature.feature_class)) return;
        const int holes = static_cast<int>(holeCentres(feature).size());
        const bool flat = hasFloor(feature.feature_class) && feature.point_mm <= 0;
        if (!flat && drillCheck(feature, drill_, tol_).fits) {
            row_.makes += holes;
            add(drillStep(feature, drill_, cutting_, retract_z_mm_, machine_), feature);
        } else if (preDrills(feature, drill_, tol_)) {
            row_.makes_room_in += holes;
            add(preDrillStep(feature, drill_, cutting_, retract_z_mm_, machine_, tol_), feature);
        }
    }

    const DrillRow& row() const { return row_; }

  private:
    void add(const SequenceStep& step, const Feature& feature) {
        const double depth_mm = feature.depth_mm() - step.leaves.floors_mm;
        row_.volume_cm3 += step.area.new_area_mm2 * depth_mm / kMm3PerCm3;
        row_.time_min += step.path.totals.time_s() / kSecondsPerMinute;
    }

    const ToolAssembly& drill_;
    const Machine& machine_;
    CuttingData cutting_;
    double retract_z_mm_;
    const Tolerances& tol_;
    DrillRow row_;
};

}  // namespace

std::vector<DrillRow> drillTable(const std::vector<Feature>& features, const ToolLibrary& library,
                                 const Machine& machine, const SequenceOptions& options,
                                 const Tolerances& tol) {
    std::vector<DrillRow> rows;
    for (const ToolAssembly& tool : library.tools) {
        if (!tool.isDrill() || tool.cuttingFor(options.material) == nullptr) continue;
        DrillCount count(tool, machine, options, tol);
        for (const Feature& feature : features)
            count.add(feature);
        rows.push_back(count.row());
    }
    return rows;
}

}  // namespace stepmill
