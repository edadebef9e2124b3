#include "support/shape_makers.h"

#include <algorithm>
#include <cmath>

namespace stepmill::test {
namespace {

/// Points and centre are rounded to the grid; the arc is good if both ends still lie on it to 2 nm.
bool fits(const Vec2& from, const Vec2& to, const Arc& arc) {
    constexpr double kOffMm = 1.9 * kGridMm;
    return std::abs((from - arc.centre).norm() - arc.radius_mm) < kOffMm &&
           std::abs((to - arc.centre).norm() - arc.radius_mm) < kOffMm;
}

void appendLine(Loop& loop, const Vec2& to) {
    if (loop.segments.empty() || loop.end() != to) loop.segments.push_back({to, std::nullopt});
}

}  // namespace

Vec2 polar(const Vec2& centre, double radius_mm, double angle_rad) {
    return centre + radius_mm * Vec2(std::cos(angle_rad), std::sin(angle_rad));
}

void addHole(Region& region, const Region& hole) {
    for (const Loop& loop : hole.loops)
        region.loops.push_back(reversed(loop));
}

/// No drawing has smaller fillets [mm].
constexpr double kLeastFilletMm = 2e-3;

Loop filleted(const std::vector<Vec2>& corners, double largest_share, Random& random) {
    const std::size_t n = corners.size();
    Loop loop;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2& corner = corners[i];
        const Vec2 to_last = corners[(i + n - 1) % n] - corner;
        const Vec2 to_next = corners[(i + 1) % n] - corner;
        const Vec2 back = to_last.normalized();
        const Vec2 on = to_next.normalized();
        const double share = std::min(1.0, random.real(0, largest_share));
        const double half_rad = std::acos(std::clamp(back.dot(on), -1.0, 1.0)) / 2;
        const double room_mm = share * std::min(to_last.norm(), to_next.norm()) / 2;
        const double radius_mm = snapToGrid(room_mm * std::tan(half_rad));
        if (random.below(3) == 0 || radius_mm < kLeastFilletMm) {
            appendLine(loop, snapToGrid(corner));
            continue;
        }
        const double cut_mm = radius_mm / std::tan(half_rad);
        const Vec2 begin = snapToGrid(Vec2(corner + cut_mm * back));
        const Vec2 end = snapToGrid(Vec2(corner + cut_mm * on));
        const Vec2 centre =
            snapToGrid(Vec2(corner + radius_mm / std::sin(half_rad) * (back + on).normalized()));
        const Arc arc{centre, radius_mm, cross(back, on) < 0};
        appendLine(loop, begin);
        if (begin == end) continue;
        if (fits(begin, end, arc))
            loop.segments.push_back({end, arc});
        else
            appendLine(loop, end);
    }
    loop.start = loop.segments.back().to;
    // The first line has no length where the last rounding ends where the first begins.
    if (!loop.segments.front().arc && loop.segments.front().to == loop.start)
        loop.segments.erase(loop.segments.begin());
    return loop;
}

Loop bulged(const std::vector<Vec2>& corners, Random& random) {
    Loop loop{corners.back(), {}};
    for (const Vec2& to : corners) {
        const Vec2 from = loop.end();
        const Vec2 chord = to - from;
        const Vec2 left(-chord.y(), chord.x());
        // Up to a quarter turn, either way.
        const double height_share = random.real(0.3, 4) * (random.below(2) ? 1 : -1);
        const Vec2 centre = snapToGrid(Vec2(from + chord / 2 + height_share * left));
        const Arc arc{centre, snapToGrid(((from - centre).norm() + (to - centre).norm()) / 2),
                      height_share > 0};
        if (random.below(2) && fits(from, to, arc))
            loop.segments.push_back({to, arc});
        else
            loop.segments.push_back({to, std::nullopt});
    }
    return loop;
}

}  // namespace stepmill::test
