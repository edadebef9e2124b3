#include "toolpath/engagement/swept_ways.h"

#include <algorithm>
#include <cmath>

namespace stepmill::toolpath {
namespace {

/// Spreads an index over 64 bits (the finaliser of SplitMix64).
std::uint64_t spread(std::uint64_t index) {
    std::uint64_t x = index + 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}

/// The last decimal of a program in mm [mm].
constexpr double kLastDecimalMm = 1e-4;
/// Half a decimal rounds up or down by chance; inches have values that are just that in mm, so the borders
/// between words lie this share of one beside it.
constexpr double kBesideHalf = 0.01;

std::array<std::int64_t, 2> wordsOf(const Vec2& point) {
    return {std::llround(point.x() / kLastDecimalMm + kBesideHalf),
            std::llround(point.y() / kLastDecimalMm + kBesideHalf)};
}

}  // namespace

DirectedKey keyOf(const Edge& edge) {
    std::array<std::int64_t, 2> a = wordsOf(edge.from);
    std::array<std::int64_t, 2> b = wordsOf(edge.to());
    const std::optional<Arc>& arc = edge.segment.arc;
    bool ccw = arc && arc->ccw;
    const bool turned = b < a;
    if (turned) {
        std::swap(a, b);
        ccw = !ccw;
    }
    DirectedKey found{{a[0], a[1], b[0], b[1], 0, 0, 0}, turned};
    if (arc) {
        const std::array<std::int64_t, 2> centre = wordsOf(arc->centre);
        found.key[4] = centre[0];
        found.key[5] = centre[1];
        found.key[6] = ccw ? 1 : -1;
    }
    return found;
}

void SweptWays::add(const Edge& edge, double radius_mm, double low_z_mm) {
    sets_.clear();
    const auto [known, is_new] = known_.try_emplace({keyOf(edge).key, radius_mm}, ways_.size());
    if (!is_new) {
        SweptWay& way = ways_[known->second];
        way.low_z_mm = std::min(way.low_z_mm, low_z_mm);
        return;
    }
    if (ways_.size() % kBlock == 0) blocks_.emplace_back();
    ways_.push_back({edge, radius_mm, low_z_mm, grown(edge.box, radius_mm)});
    blocks_.back().extend(ways_.back().box);
}

std::uint64_t SweptWays::setOf(double z_mm) const {
    const auto [known, is_new] = sets_.try_emplace(z_mm, 0);
    if (is_new)
        for (std::size_t i = 0; i < ways_.size(); ++i)
            if (ways_[i].low_z_mm <= z_mm) known->second += spread(i);
    return known->second;
}

}  // namespace stepmill::toolpath
