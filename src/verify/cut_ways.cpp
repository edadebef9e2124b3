#include "verify/cut_ways.h"

#include <algorithm>
#include <cmath>

namespace stepmill::verify {
namespace {

/// A way across everything is in so many cells of a row at most.
constexpr double kMostCellsInARow = 32;

}  // namespace

CutWays::CutWays(const Box2& over_mm, double cell_mm)
    : over_mm_(over_mm), cell_mm_(std::max(cell_mm, over_mm.sizes().maxCoeff() / kMostCellsInARow)) {}

/// Ways beyond the area are in the cells at its rim.
int CutWays::cellOf(double value_mm, int axis) const {
    const double low_mm = over_mm_.min()[axis];
    const double high_mm = std::max(low_mm, over_mm_.max()[axis]);
    return static_cast<int>(std::floor((std::clamp(value_mm, low_mm, high_mm) - low_mm) / cell_mm_));
}

template <typename Visit>
void CutWays::forEachCell(const Box2& box, const Visit& visit) const {
    for (int i = cellOf(box.min().x(), 0); i <= cellOf(box.max().x(), 0); ++i)
        for (int j = cellOf(box.min().y(), 1); j <= cellOf(box.max().y(), 1); ++j)
            visit(Cell(i, j));
}

void CutWays::add(double level_mm, Path way) {
    const Box2 box = boundingBox(way);
    forEachCell(box, [&](const Cell& cell) { cells_[cell].push_back(ways_.size()); });
    ways_.push_back({level_mm, box, std::move(way)});
}

std::vector<Path> CutWays::below(double highest_mm, const Box2& around) const {
    std::vector<std::size_t> found;
    forEachCell(around, [&](const Cell& cell) {
        const auto in = cells_.find(cell);
        if (in == cells_.end()) return;
        for (const std::size_t i : in->second)
            if (ways_[i].level_mm <= highest_mm && ways_[i].box.intersects(around)) found.push_back(i);
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::stable_sort(found.begin(), found.end(),
                     [&](std::size_t i, std::size_t k) { return ways_[i].level_mm > ways_[k].level_mm; });
    std::vector<Path> ways;
    ways.reserve(found.size());
    for (const std::size_t i : found)
        ways.push_back(ways_[i].way);
    return ways;
}

}  // namespace stepmill::verify
