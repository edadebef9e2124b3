#include "bench/planar_shapes.h"

#include <cmath>
#include <random>

#include "stepmill/core/tolerances.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::bench {
namespace {

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    // Not std::uniform_real_distribution, whose results differ between standard libraries.
    double operator()(double from, double to) {
        return from + (to - from) * (static_cast<double>(engine_()) / 4294967296.0);
    }

  private:
    std::mt19937 engine_;
};

Vec2 polar(const Vec2& centre, double radius_mm, double angle_rad) {
    return centre + radius_mm * Vec2(std::cos(angle_rad), std::sin(angle_rad));
}

/// Counter-clockwise loop through the corners; every `every`-th one rounded with that radius.
Loop filleted(const std::vector<Vec2>& corners, std::size_t every, double radius_mm) {
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2& corner = corners[i];
        if (i % every != 0) {
            segments.push_back({snapToGrid(corner), std::nullopt});
            continue;
        }
        const Vec2 back = (corners[(i + corners.size() - 1) % corners.size()] - corner).normalized();
        const Vec2 on = (corners[(i + 1) % corners.size()] - corner).normalized();
        const double half_rad = std::acos(back.dot(on)) / 2;
        const Vec2 centre = corner + radius_mm / std::sin(half_rad) * (back + on).normalized();
        const double cut_mm = radius_mm / std::tan(half_rad);
        const bool ccw = cross(back, on) < 0;
        segments.push_back({snapToGrid(Vec2(corner + cut_mm * back)), std::nullopt});
        segments.push_back({snapToGrid(Vec2(corner + cut_mm * on)), Arc{snapToGrid(centre), radius_mm, ccw}});
    }
    return Loop{segments.back().to, segments};
}

std::vector<Vec2> ruggedRing(Random& random, const Vec2& centre, double radius_mm, double share, int count) {
    std::vector<Vec2> corners;
    for (int i = 0; i < count; ++i)
        corners.push_back(polar(centre, radius_mm * random(1 - share, 1 + share), 2 * kPi * i / count));
    return corners;
}

Region pocketWithIsland() {
    return subtract(makeRoundedRectangle({0, 0}, {70, 50}, 6), makeCircle({35, 25}, 8), {});
}

Region butterfly() {
    const std::vector<Region> rooms{makeCircle({-34, 0}, 20), makeCircle({34, 2}, 18), makeCircle({0, 0}, 11),
                                    makeRectangle({-20, -3}, {0, 3}), makeRectangle({0, -4}, {20, 4})};
    return unite(rooms, {});
}

Region withSixIslands() {
    Random random(3);
    Region region;
    region.loops.push_back(filleted(ruggedRing(random, {0, 0}, 60, 0.03, 48), 3, 1.0));
    for (int i = 0; i < 6; ++i) {
        const Vec2 centre = polar({0, 0}, 34, 2 * kPi * (i + 0.1) / 6);
        region.loops.push_back(reversed(filleted(ruggedRing(random, centre, 8, 0.05, 12), 3, 0.8)));
    }
    return region;
}

}  // namespace

Region freeForm(int edges) {
    constexpr double kEdgeMm = 0.2;
    constexpr double kWaveMm = 25;  // one wave along the boundary
    Random random(4);
    const double radius_mm = kEdgeMm * edges / (2 * kPi);
    const double waves = std::max(2.0, std::floor(kEdgeMm * edges / kWaveMm));
    const double depth_mm = std::min(0.2 * radius_mm, 5.0);
    const double phase = random(0, 2 * kPi);
    std::vector<Vec2> corners;
    for (int i = 0; i < edges; ++i) {
        const double angle = 2 * kPi * i / edges;
        const double wave = std::sin(waves * angle + phase) + 0.4 * std::sin((2 * waves + 1) * angle);
        corners.push_back(snapToGrid(polar({0, 0}, radius_mm + depth_mm * wave, angle)));
    }
    return makePolygon(corners);
}

std::vector<Shape> planarShapes() {
    return {{"a", pocketWithIsland()}, {"b", butterfly()}, {"c", withSixIslands()}, {"d", freeForm(2000)}};
}

}  // namespace stepmill::bench
