#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"
#include "support/raster_simulator.h"

namespace stepmill::test {

/// Measures how much of a cutter's rim stands in material, on cells that the same moves clear: it knows
/// neither edges nor discs of the planner's. What it finds is surely so, whatever cells at an edge hold.
///
/// A stretch of the rim that is nowhere farther than `graze_mm` from what earlier passes have swept counts
/// for nothing.
class EngagementMeter {
  public:
    EngagementMeter(const ClearingTask& task, double radius_mm, double cell_mm, double graze_mm)
        : raster_(grown(boundingBox(task.target), 2.5 * radius_mm), cell_mm),
          radius_mm_(radius_mm),
          graze_mm_(graze_mm) {
        const std::vector<char> target = raster_.cellsOf(task.target);
        cells_.assign(target.size(), Cell::Empty);
        for (std::size_t i = 0; i < target.size(); ++i)
            if (target[i] != 0) cells_[i] = Cell::Material;
        if (task.cleared_centres.empty()) return;
        const std::vector<double> distance = raster_.distanceTo(raster_.cellsOf(task.cleared_centres));
        for (std::size_t i = 0; i < cells_.size(); ++i)
            if (distance[i] <= radius_mm) cells_[i] = Cell::Swept;
    }

    /// What has been swept so far counts for grazes from now on.
    void beginPass() {
        for (Cell& cell : cells_)
            if (cell == Cell::Fresh) cell = Cell::Swept;
    }

    /// Moves the cutter along an edge at depth.
    /// \return  the greatest angle of the front half of its rim that surely stands in material anywhere on the
    ///          way [rad]
    double follow(const Edge& edge, bool measures) {
        const double step_mm = raster_.cellMm();
        const int steps = std::max(1, static_cast<int>(std::ceil(length(edge) / step_mm)));
        double greatest = 0;
        for (int i = 0; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            const Vec2 at = pointAt(edge, share);
            if (measures) greatest = std::max(greatest, angleAt(at, tangentAt(edge, share)));
            raster_.forDisc(at, radius_mm_, [&](std::size_t cell) {
                if (cells_[cell] == Cell::Material) cells_[cell] = Cell::Fresh;
            });
        }
        return greatest;
    }

    /// So far outside the rim it is asked what stands: what the cutter itself has swept is nearer.
    double skinMm() const { return 2.2 * raster_.cellMm(); }

    static constexpr int kRays = 180;
    static constexpr double kRayRad = kPi / kRays;

  private:
    enum class Cell : char { Empty, Material, Fresh, Swept };

    double angleAt(const Vec2& at, const Vec2& along) const {
        int engaged = 0;
        int stretch = 0;
        bool deep = false;
        for (int i = 0; i <= kRays; ++i) {
            const double angle = kPi * ((i + 0.5) / kRays - 0.5);
            const Vec2 out = std::cos(angle) * along + std::sin(angle) * leftOf(along);
            const Vec2 rim = at + (radius_mm_ + skinMm()) * out;
            if (i < kRays && standsAt(rim)) {
                ++stretch;
                deep = deep || isDeep(rim);
                continue;
            }
            if (deep) engaged += stretch;
            stretch = 0;
            deep = false;
        }
        return kRayRad * engaged;
    }

    /// All cells around hold material.
    bool standsAt(const Vec2& p) const {
        bool stands = true;
        const Vec2 around = Vec2(1.5, 1.5) * raster_.cellMm();
        raster_.forBox(Box2(p - around, p + around), [&](int column, int row) {
            stands = stands && cells_[raster_.index(column, row)] == Cell::Material;
        });
        return stands;
    }

    /// No earlier pass has swept anything as near as a graze.
    bool isDeep(const Vec2& p) const {
        bool deep = true;
        raster_.forDisc(p, graze_mm_ + skinMm() + 1.5 * raster_.cellMm(),
                        [&](std::size_t cell) { deep = deep && cells_[cell] != Cell::Swept; });
        return deep;
    }

    Raster raster_;
    double radius_mm_;
    double graze_mm_;
    std::vector<Cell> cells_;
};

}  // namespace stepmill::test
