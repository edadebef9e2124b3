#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "stepmill/toolpath/toolpath.h"

namespace stepmill::test {

/// Square cells over a box; a region as the cells whose centres it holds. Knows regions only as points
/// along their boundary: independent of planar's offsets, booleans and containment.
class Raster {
  public:
    Raster(const Box2& box, double cell_mm)
        : box_(box),
          cell_mm_(cell_mm),
          columns_(static_cast<int>(std::ceil(box.sizes().x() / cell_mm))),
          rows_(static_cast<int>(std::ceil(box.sizes().y() / cell_mm))) {}

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    double cellMm() const { return cell_mm_; }
    std::size_t count() const { return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_); }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    Vec2 centre(int column, int row) const { return box_.min() + cell_mm_ * Vec2(column + 0.5, row + 0.5); }

    Vec2 centre(std::size_t cell) const {
        const auto columns = static_cast<std::size_t>(columns_);
        return centre(static_cast<int>(cell % columns), static_cast<int>(cell / columns));
    }

    /// Cells inside the region, by the even-odd rule along each row.
    std::vector<char> cellsOf(const Region& region) const {
        std::vector<std::vector<double>> crossings(static_cast<std::size_t>(rows_));
        for (const Loop& loop : region.loops) {
            const std::vector<Vec2> points = tessellate(loop, cell_mm_ / 50);
            for (std::size_t i = 1; i < points.size(); ++i)
                addCrossings(points[i - 1], points[i], crossings);
        }
        std::vector<char> cells(count(), 0);
        for (int row = 0; row < rows_; ++row) {
            std::vector<double>& xs = crossings[static_cast<std::size_t>(row)];
            std::sort(xs.begin(), xs.end());
            for (std::size_t i = 1; i < xs.size(); i += 2)
                for (int column = firstAt(xs[i - 1]); column < std::min(firstAt(xs[i]), columns_); ++column)
                    cells[index(column, row)] = 1;
        }
        return cells;
    }

    /// Distance from every cell to the nearest cell that is set, centre to centre [mm]: two passes of
    /// parabolas' lower envelopes.
    std::vector<double> distanceTo(const std::vector<char>& cells) const {
        std::vector<double> field(count());
        for (std::size_t i = 0; i < field.size(); ++i)
            field[i] = cells[i] ? 0 : kFar;
        for (int row = 0; row < rows_; ++row)
            envelope(field, index(0, row), 1, columns_);
        for (int column = 0; column < columns_; ++column)
            envelope(field, index(column, 0), static_cast<std::size_t>(columns_), rows_);
        for (double& value : field)
            value = std::sqrt(value) * cell_mm_;
        return field;
    }

    /// Calls visit(cell index) for the cells whose centres lie in the disc.
    template <typename Visit>
    void forDisc(const Vec2& centre, double radius_mm, Visit visit) const {
        const double middle_y = (centre.y() - box_.min().y()) / cell_mm_ - 0.5;
        const double reach = radius_mm / cell_mm_;
        const int low = std::max(0, static_cast<int>(std::ceil(middle_y - reach)));
        const int high = std::min(rows_ - 1, static_cast<int>(std::floor(middle_y + reach)));
        const double middle_x = (centre.x() - box_.min().x()) / cell_mm_ - 0.5;
        for (int row = low; row <= high; ++row) {
            const double half = std::sqrt(std::max(0.0, reach * reach - (row - middle_y) * (row - middle_y)));
            const int left = std::max(0, static_cast<int>(std::ceil(middle_x - half)));
            const int right = std::min(columns_ - 1, static_cast<int>(std::floor(middle_x + half)));
            for (int column = left; column <= right; ++column)
                visit(index(column, row));
        }
    }

    /// Calls visit(column, row) for the cells whose centres lie in the box.
    template <typename Visit>
    void forBox(const Box2& box, Visit visit) const {
        const Vec2 low = (box.min() - box_.min()) / cell_mm_ - Vec2(0.5, 0.5);
        const Vec2 high = (box.max() - box_.min()) / cell_mm_ - Vec2(0.5, 0.5);
        for (int row = std::max(0, static_cast<int>(std::ceil(low.y())));
             row <= std::min(rows_ - 1, static_cast<int>(std::floor(high.y()))); ++row)
            for (int column = std::max(0, static_cast<int>(std::ceil(low.x())));
                 column <= std::min(columns_ - 1, static_cast<int>(std::floor(high.x()))); ++column)
                visit(column, row);
    }

  private:
    static constexpr double kFar = 1e12;

    int firstAt(double x) const {
        return std::max(0, static_cast<int>(std::ceil((x - box_.min().x()) / cell_mm_ - 0.5)));
    }

    void addCrossings(const Vec2& a, const Vec2& b, std::vector<std::vector<double>>& crossings) const {
        const Vec2& low = a.y() < b.y() ? a : b;
        const Vec2& high = a.y() < b.y() ? b : a;
        const int first =
            std::max(0, static_cast<int>(std::ceil((low.y() - box_.min().y()) / cell_mm_ - 0.5)));
        for (int row = first; row < rows_; ++row) {
            const double y = centre(0, row).y();
            if (y >= high.y()) break;
            const double x = low.x() + (y - low.y()) / (high.y() - low.y()) * (high.x() - low.x());
            crossings[static_cast<std::size_t>(row)].push_back(x);
        }
    }

    static void envelope(std::vector<double>& field, std::size_t start, std::size_t stride, int n) {
        std::vector<double> f(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i)
            f[static_cast<std::size_t>(i)] = field[start + static_cast<std::size_t>(i) * stride];
        std::vector<int> at(static_cast<std::size_t>(n));
        std::vector<double> from(static_cast<std::size_t>(n) + 1);
        const auto meet = [&](int p, int q) {
            return (f[static_cast<std::size_t>(q)] + 1.0 * q * q - f[static_cast<std::size_t>(p)] -
                    1.0 * p * p) /
                   (2.0 * (q - p));
        };
        std::size_t top = 0;
        at[0] = 0;
        from[0] = -std::numeric_limits<double>::infinity();
        from[1] = std::numeric_limits<double>::infinity();
        for (int q = 1; q < n; ++q) {
            double x = meet(at[top], q);
            while (x <= from[top])
                x = meet(at[--top], q);
            at[++top] = q;
            from[top] = x;
            from[top + 1] = std::numeric_limits<double>::infinity();
        }
        std::size_t k = 0;
        for (int q = 0; q < n; ++q) {
            while (from[k + 1] < q)
                ++k;
            const int p = at[k];
            field[start + static_cast<std::size_t>(q) * stride] =
                1.0 * (q - p) * (q - p) + f[static_cast<std::size_t>(p)];
        }
    }

    Box2 box_;
    double cell_mm_;
    int columns_;
    int rows_;
};

/// What a simulated path did. Areas [mm2].
struct SimulatedCut {
    double gouged_mm2 = 0;     ///< obstruction touched, deeper than the margin
    double left_mm2 = 0;       ///< reachable target not down at the floor, but for the margin
    double reachable_mm2 = 0;  ///< target within the disc of some centre of the task
    int bad_rapids = 0;        ///< samples of rapids that go into material
};

/// Moves a flat cutter along the path, sampled finely, over a height map of the target's material.
///
/// Cells are `cell_mm` wide; `margin_mm` (at least a cell's diagonal) is what boundaries are uncertain by.
inline SimulatedCut simulate(const Toolpath& path, const ClearingTask& task, double radius_mm, double cell_mm,
                             double margin_mm) {
    Box2 box = boundingBox(task.target);
    box = grown(box, 2.5 * radius_mm + 2 * cell_mm);
    const Raster raster(box, cell_mm);
    const std::vector<char> target = raster.cellsOf(task.target);
    const std::vector<char> obstruction = raster.cellsOf(task.obstruction);
    const double air = -1e9;
    std::vector<double> height(raster.count(), air);
    for (std::size_t i = 0; i < height.size(); ++i)
        if (target[i] || obstruction[i]) height[i] = task.top_z_mm;
    if (!task.cleared_centres.empty()) {
        const std::vector<double> distance = raster.distanceTo(raster.cellsOf(task.cleared_centres));
        for (std::size_t i = 0; i < height.size(); ++i)
            if (distance[i] <= radius_mm && !obstruction[i]) height[i] = air;
    }

    SimulatedCut result;
    // Steps whose scallops stay under a tenth of a cell.
    const double step_mm = std::sqrt(0.8 * cell_mm * radius_mm);
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const Segment flat{move.to.head<2>(), move.arc};
        const double length_mm = std::hypot(length(Vec2(from.head<2>()), flat), move.to.z() - from.z());
        const int steps = std::max(1, static_cast<int>(std::ceil(length_mm / step_mm)));
        for (int i = 0; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            const double z = from.z() + share * (move.to.z() - from.z());
            const Vec2 at = pointAt(from.head<2>(), flat, share);
            if (move.kind == MoveKind::Rapid) {
                bool hit = false;
                if (z < task.top_z_mm)
                    raster.forDisc(at, radius_mm - margin_mm,
                                   [&](std::size_t c) { hit = hit || height[c] > z + 1e-9; });
                result.bad_rapids += hit ? 1 : 0;
            } else {
                raster.forDisc(at, radius_mm, [&](std::size_t c) { height[c] = std::min(height[c], z); });
            }
        }
        from = move.to;
    }

    std::vector<char> outside(raster.count());
    for (std::size_t i = 0; i < outside.size(); ++i)
        outside[i] = obstruction[i] ? 0 : 1;
    std::vector<char> beside(raster.count());
    for (std::size_t i = 0; i < beside.size(); ++i)
        beside[i] = target[i] ? 0 : 1;
    const std::vector<double> depth_in_obstruction = raster.distanceTo(outside);
    const std::vector<double> depth_in_target = raster.distanceTo(beside);
    const std::vector<double> from_centres = raster.distanceTo(raster.cellsOf(task.centres));
    const double cell_mm2 = cell_mm * cell_mm;
    for (std::size_t i = 0; i < height.size(); ++i) {
        if (obstruction[i] && depth_in_obstruction[i] > margin_mm && height[i] < task.top_z_mm)
            result.gouged_mm2 += cell_mm2;
        if (!target[i] || depth_in_target[i] <= margin_mm || from_centres[i] > radius_mm - margin_mm)
            continue;
        result.reachable_mm2 += cell_mm2;
        if (height[i] > task.floor_z_mm + 1e-9) result.left_mm2 += cell_mm2;
    }
    return result;
}

}  // namespace stepmill::test
