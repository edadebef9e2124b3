#include "toolpath/engagement/swept_ways.h"

#include <algorithm>

namespace stepmill::toolpath {
namespace {

/// Spreads an index over 64 bits (the finaliser of SplitMix64).
std::uint64_t spread(std::uint64_t index) {
    std::uint64_t x = index + 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}

}  // namespace

EdgeKey keyOf(const Edge& edge) {
    Vec2 a = edge.from;
    Vec2 b = edge.to();
    bool ccw = edge.segment.arc && edge.segment.arc->ccw;
    if (std::pair(b.x(), b.y()) < std::pair(a.x(), a.y())) {
        std::swap(a, b);
        ccw = !ccw;
    }
    EdgeKey key{a.x(), a.y(), b.x(), b.y(), 0, 0, 0};
    if (const std::optional<Arc>& arc = edge.segment.arc) {
        key[4] = arc->centre.x();
        key[5] = arc->centre.y();
        key[6] = ccw ? 1 : -1;
    }
    return key;
}

void SweptWays::add(const Edge& edge, double radius_mm, double low_z_mm) {
    sets_.clear();
    const EdgeKey key = keyOf(edge);
    const auto [known, is_new] = known_.try_emplace({key, radius_mm}, ways_.size());
    if (!is_new) {
        SweptWay& way = ways_[known->second];
        way.low_z_mm = std::min(way.low_z_mm, low_z_mm);
        return;
    }
    if (ways_.size() % kBlock == 0) blocks_.emplace_back();
    ways_.push_back({edge, radius_mm, low_z_mm, key});
    boxes_.push_back(grown(edge.box, radius_mm));
    blocks_.back().extend(boxes_.back());
}

std::uint64_t SweptWays::setOf(double z_mm) const {
    const auto [known, is_new] = sets_.try_emplace(z_mm, 0);
    if (is_new)
        for (std::size_t i = 0; i < ways_.size(); ++i)
            if (ways_[i].low_z_mm <= z_mm) known->second += spread(i);
    return known->second;
}

}  // namespace stepmill::toolpath
