#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"
#include "support/raster_simulator.h"

namespace stepmill::test {

/// Measures how much of a cutter's rim stands in material, on cells that the same moves clear: it knows
/// neither edges nor discs of the planner's.
///
/// The rim is looked at `skin_mm` outside, so that one that only touches what lies beyond counts for nothing.
class EngagementMeter {
  public:
    EngagementMeter(const ClearingTask& task, double radius_mm, double cell_mm, double skin_mm)
        : raster_(grown(boundingBox(task.target), 2.5 * radius_mm), cell_mm),
          radius_mm_(radius_mm),
          skin_mm_(skin_mm),
          material_(raster_.cellsOf(task.target)) {
        if (task.cleared_centres.empty()) return;
        const std::vector<double> distance = raster_.distanceTo(raster_.cellsOf(task.cleared_centres));
        for (std::size_t i = 0; i < material_.size(); ++i)
            if (distance[i] <= radius_mm) material_[i] = 0;
    }

    /// Moves the cutter along an edge at depth. \return  the greatest angle of the front half of its rim that
    /// stands in material anywhere on the way [rad]
    double follow(const Edge& edge, bool measures) {
        const double step_mm = raster_.cellMm();
        const int steps = std::max(1, static_cast<int>(std::ceil(length(edge) / step_mm)));
        double greatest = 0;
        for (int i = 0; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            const Vec2 at = pointAt(edge, share);
            if (measures) greatest = std::max(greatest, angleAt(at, tangentAt(edge, share)));
            raster_.forDisc(at, radius_mm_, [&](std::size_t cell) { material_[cell] = 0; });
        }
        return greatest;
    }

  private:
    double angleAt(const Vec2& at, const Vec2& along) const {
        int engaged = 0;
        for (int i = 0; i < kRays; ++i) {
            const double angle = kPi * ((i + 0.5) / kRays - 0.5);
            const Vec2 out = std::cos(angle) * along + std::sin(angle) * leftOf(along);
            if (standsAt(at + (radius_mm_ + skin_mm_) * out)) ++engaged;
        }
        return kPi * engaged / kRays;
    }

    bool standsAt(const Vec2& p) const {
        bool stands = false;
        raster_.forBox(Box2(p - Vec2(0.5, 0.5) * raster_.cellMm(), p + Vec2(0.5, 0.5) * raster_.cellMm()),
                       [&](int column, int row) { stands = material_[raster_.index(column, row)] != 0; });
        return stands;
    }

    static constexpr int kRays = 180;

    Raster raster_;
    double radius_mm_;
    double skin_mm_;
    std::vector<char> material_;
};

}  // namespace stepmill::test
