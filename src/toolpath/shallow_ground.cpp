// Ground that is too flat for passes along its levels.

#include "stepmill/toolpath/shallow_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stepmill/core/parallel.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/indexed_region.h"

namespace stepmill::toolpath {
namespace {

/// Cells are so many radii wide, but no narrower than bands that hold on flat ground are wide [mm].
constexpr double kCellRadii = 1.0 / 6;
constexpr double kLeastCellMm = 0.5;
/// Slopes are taken over this way to either side: bands make steps of shorter ones [mm].
constexpr double kSlopeOverMm = 1.0;
constexpr double kBulgeOverMm = 3.0;
/// Ground narrower than this many radii either way is gone round, not over.
constexpr double kNarrowestRadii = 1.5;
/// Patches of fewer cells than are in a square of so many radii are no work for lines.
constexpr double kSmallestRadii = 1.0;
/// The rim of the ground is so wide [mm].
constexpr double kRimMm = 0.5;
/// Tangent of the steepest slope that counts as shallow, 15 degrees.
constexpr double kSteepest = 0.268;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

Region opened(const Region& region, double by_mm, const Tolerances& tol) {
    const Region core = region.empty() ? Region{} : offset(region, -by_mm, tol);
    return core.empty() ? Region{} : offset(core, by_mm, tol);
}

}  // namespace

ShallowGround::ShallowGround(const FormFloor& floor, const CutterForm& form, const Region& stairs,
                             const Region& slopes, const Region& centres, const Tolerances& tol)
    : cell_mm_(std::max(kLeastCellMm, kCellRadii * form.fullRadiusMm())) {
    const Region wide = opened(stairs, kNarrowestRadii / 2 * form.fullRadiusMm(), tol);
    if (wide.empty()) return;
    centres_ = intersect(offset(wide, form.fullRadiusMm(), tol), centres, tol);
    if (centres_.empty()) return;
    box_ = boundingBox(centres_);
    columns_ = static_cast<int>(std::ceil(box_.sizes().x() / cell_mm_));
    rows_ = static_cast<int>(std::ceil(box_.sizes().y() / cell_mm_));
    findHeights(floor, tol);
    findShallow(form, wide, offset(slopes, -kRimMm, tol));
    dropNarrow();
    findRollingOff(form.fullRadiusMm());
    findPatches();
    std::erase_if(patches_, [&](const Patch& patch) {
        const double side_mm = kSmallestRadii * form.fullRadiusMm();
        return static_cast<double>(patch.size()) * cell_mm_ * cell_mm_ < side_mm * side_mm;
    });
}

bool ShallowGround::isUnder(const Vec2& tip) const {
    return isMarked(shallow_, tip);
}

bool ShallowGround::isUnderOrRollsOff(const Vec2& tip) const {
    return isMarked(rolls_off_, tip);
}

bool ShallowGround::isMarked(const std::vector<char>& marks, const Vec2& tip) const {
    if (marks.empty() || !box_.contains(tip)) return false;
    const Vec2 cells = (tip - box_.min()) / cell_mm_;
    const Place place{std::min(static_cast<int>(cells.x()), columns_ - 1),
                      std::min(static_cast<int>(cells.y()), rows_ - 1)};
    return marks[indexOf(place)] != 0;
}

double ShallowGround::levelsMm(double step_mm) const {
    double sum = 0;
    for (const Patch& patch : patches_)
        for (const Cell& cell : patch)
            sum += cell.rise.norm();
    return sum * cell_mm_ * cell_mm_ / step_mm;
}

Vec2 ShallowGround::middleOf(const Place& place) const {
    return box_.min() + cell_mm_ * Vec2(place.column + 0.5, place.row + 0.5);
}

std::size_t ShallowGround::indexOf(const Place& place) const {
    return static_cast<std::size_t>(place.row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(place.column);
}

bool ShallowGround::isIn(const Place& place) const {
    return place.column >= 0 && place.row >= 0 && place.column < columns_ && place.row < rows_;
}

double ShallowGround::heightAt(const Place& place) const {
    return isIn(place) ? heights_[indexOf(place)] : kUnknown;
}

/// Row by row, where a whole cell's width of the row lies in the centres.
void ShallowGround::findHeights(const FormFloor& floor, const Tolerances& tol) {
    heights_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kUnknown);
    parallelFor(rows_, [&](int row) {
        const double y_mm = middleOf({0, row}).y();
        const Path whole{{box_.min().x(), y_mm}, {{Vec2(box_.max().x(), y_mm), std::nullopt}}};
        for (const Path& piece : split(whole, centres_, tol).inside) {
            const auto [left, right] = std::minmax(piece.start.x(), piece.segments.back().to.x());
            const int first = static_cast<int>(std::ceil((left - box_.min().x()) / cell_mm_));
            const int last =
                std::min(columns_, static_cast<int>(std::floor((right - box_.min().x()) / cell_mm_)));
            if (last <= first) continue;
            const Vec2 from(box_.min().x() + first * cell_mm_, y_mm);
            const std::vector<double> lowest_mm =
                floor.over(equalPieces(from, from + Vec2((last - first) * cell_mm_, 0), last - first));
            std::copy(lowest_mm.begin(), lowest_mm.end(),
                      heights_.begin() + static_cast<std::ptrdiff_t>(indexOf({first, row})));
        }
    });
}

/// NaN where a neighbour is not known.
Vec2 ShallowGround::riseAt(const Place& place) const {
    const int by = std::max(1, static_cast<int>(std::lround(kSlopeOverMm / cell_mm_)));
    const auto rise = [&](const Place& before, const Place& after) {
        return (heightAt(after) - heightAt(before)) / (2 * by * cell_mm_);
    };
    return {rise({place.column - by, place.row}, {place.column + by, place.row}),
            rise({place.column, place.row - by}, {place.column, place.row + by})};
}

/// Towards either side of a place, in that direction; 0 where the ground is hollow or not known.
double ShallowGround::bulgeAt(const Place& place, const Place& step) const {
    const int by = std::max(1, static_cast<int>(std::lround(kBulgeOverMm / cell_mm_)));
    const double before_mm = heightAt({place.column - by * step.column, place.row - by * step.row});
    const double after_mm = heightAt({place.column + by * step.column, place.row + by * step.row});
    const double over_mm = by * cell_mm_;
    const double bulge = (2 * heightAt(place) - before_mm - after_mm) / (over_mm * over_mm);
    return bulge > 0 ? bulge : 0;
}

/// Cells that are no steeper, where the cutter touches ground that stairs lie over.
void ShallowGround::findShallow(const CutterForm& form, const Region& stairs, const Region& within_rim) {
    shallow_.assign(heights_.size(), 0);
    on_rim_.assign(heights_.size(), 0);
    const double corner_mm = form.heightMm();
    const double flat_mm = form.fullRadiusMm() - corner_mm;
    const IndexedRegion under(stairs);
    const IndexedRegion within(within_rim);
    parallelFor(rows_, [&](int row) {
        for (int column = 0; column < columns_; ++column) {
            const Place place{column, row};
            const Vec2 rise = riseAt(place);
            const double slope = rise.norm();
            if (!std::isfinite(slope)) continue;
            Vec2 touched = middleOf(place);
            if (slope > 0)
                touched += (flat_mm + corner_mm * slope / std::sqrt(1 + slope * slope)) * rise / slope;
            on_rim_[indexOf(place)] = static_cast<char>(!within.contains(touched));
            shallow_[indexOf(place)] = static_cast<char>(slope <= kSteepest && under.contains(touched));
        }
    });
}

/// Leaves out strips of one or two cells.
void ShallowGround::dropNarrow() {
    const auto spread = [&](const std::vector<char>& before, char value) {
        std::vector<char> after = before;
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column)
                for (const Place& by : {Place{-1, 0}, Place{1, 0}, Place{0, -1}, Place{0, 1}}) {
                    const Place next{column + by.column, row + by.row};
                    const char there = isIn(next) ? before[indexOf(next)] : char{0};
                    if (there == value) after[indexOf({column, row})] = value;
                }
        return after;
    };
    shallow_ = spread(spread(shallow_, 0), 1);
}

/// From shallow cells outward, as far as the cutter touches the rim.
void ShallowGround::findRollingOff(double farthest_mm) {
    rolls_off_ = shallow_;
    for (int step = 0; step < static_cast<int>(farthest_mm / cell_mm_); ++step) {
        const std::vector<char> before = rolls_off_;
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column) {
                const std::size_t cell = indexOf({column, row});
                if (before[cell] != 0 || on_rim_[cell] == 0) continue;
                for (const Place& by : {Place{-1, 0}, Place{1, 0}, Place{0, -1}, Place{0, 1}}) {
                    const Place next{column + by.column, row + by.row};
                    if (isIn(next) && before[indexOf(next)] != 0) rolls_off_[cell] = 1;
                }
            }
    }
}

void ShallowGround::findPatches() {
    std::vector<char> seen(shallow_.size(), 0);
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column) {
            if (shallow_[indexOf({column, row})] == 0 || seen[indexOf({column, row})] != 0) continue;
            Patch& patch = patches_.emplace_back();
            std::vector<Place> open{{column, row}};
            seen[indexOf(open.front())] = 1;
            while (!open.empty()) {
                const Place place = open.back();
                open.pop_back();
                // Cells that only the spreading added have slopes of their own, if they are known.
                const Vec2 rise = riseAt(place);
                if (rise.allFinite())
                    patch.push_back({middleOf(place), rise, bulgeAt(place, {1, 0}), bulgeAt(place, {0, 1}),
                                     on_rim_[indexOf(place)] != 0});
                for (const Place& by : {Place{-1, 0}, Place{1, 0}, Place{0, -1}, Place{0, 1}}) {
                    const Place next{place.column + by.column, place.row + by.row};
                    if (!isIn(next) || shallow_[indexOf(next)] == 0 || seen[indexOf(next)] != 0) continue;
                    seen[indexOf(next)] = 1;
                    open.push_back(next);
                }
            }
        }
}

}  // namespace stepmill::toolpath
