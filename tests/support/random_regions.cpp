#include "support/random_regions.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "support/shape_makers.h"

namespace stepmill::test {
namespace {

/// Makes one region; lengths are about 10 before scaling.
class Maker {
  public:
    Maker(RegionKind kind, std::uint64_t seed, RandomRegion& out)
        : random_(seed * 16 + static_cast<std::uint64_t>(kind)), kind_(kind), out_(out) {
        const double scales[8] = {1, 1, 1, 1, 1, 1, random_.real(5, 30), 0.1};
        scale_ = kind == RegionKind::Lattice ? 1 : scales[random_.below(8)];
    }

    Region make() {
        switch (kind_) {
            case RegionKind::Scattered:
            case RegionKind::Lattice:
            case RegionKind::Shifted:
                return combined();
            case RegionKind::Filleted:
                return filletedWithIslands();
            case RegionKind::Touching:
                return touchingIslands();
            case RegionKind::Necks:
                return roomsWithNecks();
            case RegionKind::Stars:
                return random_.below(2) ? starOfCorners() : roomsRoundATriangle();
            case RegionKind::Slivers:
                return slivers();
            default:
                return freeForm();
        }
    }

  private:
    double length(double low, double high) {
        const double value = random_.real(low, high);
        const bool lattice = kind_ == RegionKind::Lattice || kind_ == RegionKind::Shifted;
        return snapToGrid(scale_ * (lattice ? std::round(2 * value) / 2 : value));
    }
    Vec2 place(double low, double high) { return {length(low, high), length(low, high)}; }
    double angle() { return random_.real(0, 2 * kPi); }
    void tie(double radius_mm) { out_.tie_radii_mm.push_back(snapToGrid(radius_mm)); }

    Region shape() {
        Vec2 at = place(-10, 10);
        if (kind_ == RegionKind::Shifted) {
            const double by_mm = kGridMm * std::pow(10.0, random_.below(4));
            at += Vec2(random_.real(-by_mm, by_mm), random_.real(-by_mm, by_mm));
        }
        at = snapToGrid(at);
        const Vec2 size = place(3, 14);
        const double half =
            kGridMm * std::floor(size.minCoeff() / 2 / kGridMm + 0.25);  // of an odd width: less
        switch (random_.below(4)) {
            case 0:
                return makeRectangle(at, at + size);
            case 1:
                tie(size.x() / 2);
                return makeCircle(at, size.x() / 2);
            case 2: {
                const double corner = snapToGrid(size.minCoeff() / random_.real(2.01, 6));
                tie(corner);
                return makeRoundedRectangle(at, at + size, corner);
            }
            default:
                tie(half);
                return makeRoundedRectangle(at, at + size, half);
        }
    }

    Region combined() {
        Region region = shape();
        for (int k = random_.below(6); k > 0; --k)
            region = random_.below(3) ? unite(region, shape(), {}) : subtract(region, shape(), {});
        return region;
    }

    Region filletedWithIslands() {
        const int corners = 3 + random_.below(9);
        const double largest = random_.real(0, 1.2);
        Region region{{filleted(ring({0, 0}, length(8, 14), 0.35, corners), largest, random_)}};
        for (const Vec2& at : {Vec2(-2.4, 0.3), Vec2(2.6, -0.4)}) {
            if (random_.below(2)) continue;
            const std::vector<Vec2> around = ring(scale_ * at, length(0.8, 1.7), 0.2, 3 + random_.below(5));
            region.loops.push_back(reversed(filleted(around, random_.real(0, 1.2), random_)));
        }
        for (const Loop& loop : region.loops)
            for (const Segment& s : loop.segments)
                if (s.arc && s.arc->ccw) tie(s.arc->radius_mm);
        return region;
    }

    std::vector<Vec2> ring(const Vec2& centre, double radius_mm, double share, int count) {
        const double phase = angle();
        std::vector<Vec2> corners;
        for (int i = 0; i < count; ++i)
            corners.push_back(
                polar(centre, radius_mm * random_.real(1 - share, 1 + share), phase + 2 * kPi * i / count));
        return corners;
    }

    Region touchingIslands() {
        const Vec2 size = place(12, 24);
        Region region = makeRoundedRectangle({0, 0}, size, length(0, 2));
        const double r = snapToGrid(length(1, 2.5));
        tie(r);
        tie(size.y() / 2 - r);
        const double x = snapToGrid(size.x() / 2);
        // Tangent to the lower wall, to the first island, to the upper wall; some of them, some only nearly.
        const double off[3] = {0, kGridMm, 0.5 * r};
        addHole(region, makeCircle({x, r}, r));
        if (random_.below(2))
            addHole(region, makeCircle({snapToGrid(x + 2 * r) + off[random_.below(3)], r}, r));
        if (random_.below(2)) addHole(region, makeCircle({x, size.y() - r - off[random_.below(3)]}, r));
        if (random_.below(3) == 0) {
            const Vec2 lowest(snapToGrid(x - 2.5 * r), 0);
            addHole(region, makePolygon({lowest, lowest + Vec2(r, r), lowest + Vec2(0, 2 * r),
                                         lowest + Vec2(-r, r)}));
        }
        return region;
    }

    Region roomsWithNecks() {
        const double width = 2 * snapToGrid(length(0.5, 1.5));  // all necks alike: ties in several places
        tie(width / 2);
        Region region;
        double x = 0;
        const int rooms = 2 + random_.below(3);
        for (int i = 0; i < rooms; ++i) {
            const double half = length(2, 5);
            const double height = std::max(half, width);
            const Vec2 centre(x + half, 0);
            region = unite(region,
                           random_.below(2)
                               ? makeCircle(centre, half)
                               : makeRectangle(centre - Vec2(half, height), centre + Vec2(half, height)),
                           {});
            x += 2 * half;
            if (i + 1 < rooms) x = addNeck(region, x, width);
        }
        return region;
    }

    /// A neck to the right of x; returns where the next room may begin.
    double addNeck(Region& region, double x, double width) {
        const double reach = length(1, 3);
        const double half = snapToGrid(width / 2);
        switch (random_.below(3)) {
            case 0:  // corridor
                region = unite(region, makeRectangle({x - reach, -half}, {x + 2 * reach, half}), {});
                return x + reach;
            case 1: {  // between two round posts
                const Region bridge =
                    makeRectangle({x - 2 * reach, -half - reach}, {x + 3 * reach, half + reach});
                region = unite(region, bridge, {});
                for (const double side : {-1.0, 1.0})
                    region = subtract(region, makeCircle({x + reach / 2, side * (half + reach)}, reach), {});
                return x + reach;
            }
            default: {  // between two corners
                const double mid = snapToGrid(x + reach / 2);
                const Region hourglass = makePolygon({{x - 2 * reach, -half - 3 * reach},
                                                      {mid, -half},
                                                      {x + 3 * reach, -half - 3 * reach},
                                                      {x + 3 * reach, half + 3 * reach},
                                                      {mid, half},
                                                      {x - 2 * reach, half + 3 * reach}});
                region = unite(region, hourglass, {});
                return x + 2 * reach;
            }
        }
    }

    Region roomsRoundATriangle() {
        const double from_centre = length(5, 7);
        const double phase = angle();
        std::vector<Region> rooms;
        std::vector<Vec2> centres;
        for (int i = 0; i < 3; ++i) {
            centres.push_back(snapToGrid(polar({0, 0}, from_centre, phase + 2 * kPi * i / 3)));
            rooms.push_back(makeCircle(centres.back(), length(4.6, 6)));
        }
        rooms.push_back(makePolygon(centres));
        const double island = length(0.3, 2.5);
        const double turn = random_.below(2) ? kPi / 3 : random_.real(0, 1);
        std::vector<Vec2> triangle;
        for (int i = 0; i < 3; ++i)
            triangle.push_back(polar({0, 0}, island, phase + turn + 2 * kPi * i / 3));
        return subtract(unite(rooms, {}), makePolygon(triangle), {});
    }

    /// Arms meet in the middle of a ring of corners that no large disc passes.
    Region starOfCorners() {
        const int arms = 3 + random_.below(5);
        const double inner = length(0.8, 3);
        const double phase = random_.below(2) ? 0 : angle();
        std::vector<Vec2> corners;
        for (int i = 0; i < arms; ++i) {
            const double middle = phase + 2 * kPi * i / arms;
            const double width = 0.9 * kPi / arms;
            corners.push_back(polar({0, 0}, inner, middle - kPi / arms));
            corners.push_back(polar({0, 0}, length(9, 13), middle - width));
            corners.push_back(polar({0, 0}, length(9, 13), middle + width));
        }
        tie(inner);
        tie(inner * std::sin(kPi / arms));
        return makePolygon(corners);
    }

    Region slivers() {
        const double thin = snapToGrid(2e-6 * std::pow(10.0, random_.real(0, 4)));
        const double w = length(8, 16);
        switch (random_.below(5)) {
            case 4: {  // needle, as cutters leave them between walls
                const Vec2 middle = polar({0, 0}, length(0.002, 0.02), angle());
                const Vec2 bent(random_.real(-thin, thin), random_.real(-thin, thin));
                return makePolygon({{0, 0}, middle, Vec2(2 * middle + bent)});
            }
            case 0:  // wedges: the tip's angle is thin / w
                return makePolygon({{0, 0}, {w, -thin}, {w + length(2, 4), length(3, 5)}, {w, length(6, 8)}});
            case 1: {  // two pockets and a slot of that width
                Region region =
                    unite(makeRectangle({0, 0}, {w, w}), makeRectangle({2 * w, 0}, {3 * w, w}), {});
                tie(thin / 2);
                return unite(region,
                             makeRectangle({w - 1e-3, w / 2}, {2 * w + 1e-3, snapToGrid(w / 2) + thin}), {});
            }
            case 2: {  // eccentric ring, nearly touching
                Region region = makeCircle({0, 0}, w);
                const double hole = length(2, 6);
                tie(hole);
                tie(w - hole);
                addHole(region, makeCircle({w - hole - thin, 0}, hole));
                return region;
            }
            default: {  // crescent
                const double hole = snapToGrid(w * random_.real(0.3, 1.2));
                return subtract(makeCircle({0, 0}, w),
                                makeCircle({snapToGrid(w - hole) + 2 * thin + length(0, 3), 0}, hole), {});
            }
        }
    }

    Region freeForm() {
        const int edges = 60 + random_.below(300);
        const double radius_mm = length(8, 14);
        const double waves = 2 + random_.below(9);
        const double depth = random_.real(0.02, 0.25);
        const double phase = angle();
        std::vector<Vec2> corners;
        for (int i = 0; i < edges; ++i) {
            const double a = 2 * kPi * i / edges;
            const double wave = std::sin(waves * a + phase) + 0.3 * std::sin((2 * waves + 1) * a);
            corners.push_back(snapToGrid(polar({0, 0}, radius_mm * (1 + depth * wave), a)));
        }
        return {{bulged(corners, random_)}};
    }

    Random random_;
    RegionKind kind_;
    RandomRegion& out_;
    double scale_ = 1;
};

}  // namespace

std::string name(RegionKind kind) {
    static const char* const names[] = {"Scattered", "Lattice", "Shifted", "Filleted", "Touching",
                                        "Necks",     "Stars",   "Slivers", "ManyEdges"};
    return names[static_cast<int>(kind)];
}

double RandomRegion::freeRadius(Random& random) const {
    return std::max(kSmallestRadiusMm, snapToGrid(size_mm * 0.4 * std::pow(random.real(0, 1), 1.7)));
}

double RandomRegion::tieRadius(Random& random) const {
    if (tie_radii_mm.empty()) return freeRadius(random);
    return tie_radii_mm[static_cast<std::size_t>(random.below(static_cast<int>(tie_radii_mm.size())))];
}

RandomRegion randomRegion(RegionKind kind, std::uint64_t seed) {
    for (std::uint64_t attempt = 0;; ++attempt) {
        RandomRegion result{kind, seed, {}, {}};
        result.region = Maker(kind, seed + attempt * 1'000'000, result).make();
        if (result.region.empty() || diagnose(result.region)) continue;
        result.size_mm = boundingBox(result.region).sizes().minCoeff();
        return result;
    }
}

namespace {

template <typename Map>
Region mapped(const Region& region, bool flips, Map map) {
    Region result = region;
    for (Loop& loop : result.loops) {
        loop.start = map(loop.start);
        for (Segment& segment : loop.segments) {
            segment.to = map(segment.to);
            if (!segment.arc) continue;
            segment.arc->centre = map(segment.arc->centre);
            if (flips) segment.arc->ccw = !segment.arc->ccw;
        }
        if (flips) loop = reversed(loop);
    }
    return result;
}

}  // namespace

Region turned(const Region& region, double angle_rad, const Vec2& then_by) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return mapped(region, false, [&](const Vec2& p) {
        return snapToGrid(Vec2(c * p.x() - s * p.y() + then_by.x(), s * p.x() + c * p.y() + then_by.y()));
    });
}

Region mirrored(const Region& region) {
    return mapped(region, true, [](const Vec2& p) { return Vec2(-p.x(), p.y()); });
}

Region renumbered(const Region& region, Random& random) {
    Region result = region;
    for (Loop& loop : result.loops) {
        const int by = random.below(static_cast<int>(loop.segments.size()));
        std::rotate(loop.segments.begin(), loop.segments.begin() + by, loop.segments.end());
        loop.start = loop.segments.back().to;
    }
    std::reverse(result.loops.begin(), result.loops.end());
    return result;
}

}  // namespace stepmill::test
