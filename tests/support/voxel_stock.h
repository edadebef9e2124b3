#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "support/height_map.h"

namespace stepmill::test {

/// Stock as small cubes, cut from several sides one after the other: it shares no geometry with the planner.
/// A cube stands for its centre, so rims and walls are uncertain by half a cube's diagonal, and by that again
/// each time the stock is turned.
class VoxelStock {
  public:
    /// A whole block.
    VoxelStock(const Box3& box, double cell_mm) : VoxelStock(box, cell_mm, true) {}

    /// The same stock in another setup.
    /// \param from_there  from its coordinates to this stock's
    VoxelStock turned(const Box3& box, const Eigen::Isometry3d& from_there) const {
        VoxelStock turned(box, raster_.cellMm(), false);
        for (std::size_t column = 0; column < turned.raster_.count(); ++column)
            for (int level = 0; level < turned.levels_; ++level) {
                const Vec2 at = turned.raster_.centre(column);
                if (isSolid(from_there * Vec3(at.x(), at.y(), turned.middle(level))))
                    turned.word(column, level) |= bitOf(level);
            }
        return turned;
    }

    /// Takes away what stands in or over a cutter.
    void cut(const Vec3& tip, const CutterProfile& cutter) {
        raster_.forDisc(tip.head<2>(), cutter.radius_mm, [&](std::size_t column) {
            const double off_axis_mm = (raster_.centre(column) - tip.head<2>()).norm();
            clearFrom(column, firstOver(tip.z() + cutter.heightAt(off_axis_mm)));
        });
    }

    /// Does an upright cylinder meet material? Sheets of two cubes and less do not count: they are what
    /// cubes leave at a wall that is cut from both its sides.
    bool meets(const Vec2& axis, double radius_mm, double bottom_mm, double top_mm) const {
        const int from = firstOver(bottom_mm);
        const int to = std::min(levels_, firstOver(top_mm));
        if (from >= to) return false;
        bool met = false;
        raster_.forDisc(axis, radius_mm, [&](std::size_t column) {
            met = met || (!isRim(column) && hasThick(column, from, to));
        });
        return met;
    }

    double topMm() const { return bottom_mm_ + levels_ * raster_.cellMm(); }
    double volumeMm3() const {
        double count = 0;
        for (const std::uint64_t bits : words_)
            count += __builtin_popcountll(bits);
        return count * std::pow(raster_.cellMm(), 3);
    }

  private:
    static constexpr int kBits = 64;

    VoxelStock(const Box3& box, double cell_mm, bool solid)
        : raster_(Box2(box.min().head<2>(), box.max().head<2>()), cell_mm),
          bottom_mm_(box.min().z()),
          levels_(static_cast<int>(std::lround(box.sizes().z() / cell_mm))),
          words_a_column_((levels_ + kBits - 1) / kBits),
          words_(raster_.count() * words_a_column_, 0) {
        if (!solid) return;
        for (std::size_t column = 0; column < raster_.count(); ++column)
            for (int level = 0; level < levels_; ++level)
                word(column, level) |= bitOf(level);
    }

    static std::uint64_t bitOf(int level) { return std::uint64_t{1} << (level % kBits); }
    std::uint64_t& word(std::size_t column, int level) {
        return words_[column * words_a_column_ + level / kBits];
    }
    double middle(int level) const { return bottom_mm_ + (level + 0.5) * raster_.cellMm(); }

    /// The lowest level whose middle is over this height.
    int firstOver(double z_mm) const {
        const double level = std::ceil((z_mm - bottom_mm_) / raster_.cellMm() - 0.5);
        return static_cast<int>(std::clamp(level, 0.0, static_cast<double>(levels_)));
    }

    /// Bits of a word from one level of the column to before another.
    static std::uint64_t maskOf(int word, int from, int to) {
        const int low = std::clamp(from - word * kBits, 0, kBits);
        const int high = std::clamp(to - word * kBits, 0, kBits);
        const auto below = [](int bits) {
            return bits == kBits ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
        };
        return below(high) & ~below(low);
    }

    void clearFrom(std::size_t column, int level) {
        for (int w = level / kBits; w < words_a_column_; ++w)
            words_[column * words_a_column_ + w] &= ~maskOf(w, level, levels_);
    }

    bool isRim(std::size_t column) const {
        const int x = static_cast<int>(column) % raster_.columns();
        const int y = static_cast<int>(column) / raster_.columns();
        return x == 0 || y == 0 || x + 1 == raster_.columns() || y + 1 == raster_.rows();
    }

    /// Between two levels: a cube with one on each of its four sides.
    bool hasThick(std::size_t column, int from, int to) const {
        const auto columns = static_cast<std::size_t>(raster_.columns());
        for (int w = from / kBits; w <= (to - 1) / kBits; ++w) {
            std::uint64_t bits = maskOf(w, from, to);
            for (const std::size_t side :
                 {column, column - 1, column + 1, column - columns, column + columns})
                bits &= words_[side * words_a_column_ + w];
            if (bits != 0) return true;
        }
        return false;
    }

    bool isSolid(const Vec3& at) const {
        const Vec2 low = raster_.centre(0, 0);
        const auto column = std::lround((at.x() - low.x()) / raster_.cellMm());
        const auto row = std::lround((at.y() - low.y()) / raster_.cellMm());
        const auto level = std::lround((at.z() - middle(0)) / raster_.cellMm());
        if (column < 0 || row < 0 || level < 0 || column >= raster_.columns() || row >= raster_.rows() ||
            level >= levels_)
            return false;
        const std::size_t index = raster_.index(static_cast<int>(column), static_cast<int>(row));
        return (words_[index * words_a_column_ + level / kBits] & bitOf(static_cast<int>(level))) != 0;
    }

    Raster raster_;
    double bottom_mm_ = 0;
    int levels_ = 0;
    int words_a_column_ = 0;
    std::vector<std::uint64_t> words_;  ///< columns one after the other, from the bottom up
};

}  // namespace stepmill::test
