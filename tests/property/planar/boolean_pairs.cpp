#include "boolean_pairs.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "support/random_regions.h"

namespace stepmill::test {

namespace {

double scaleOf(PairKind kind) {
    if (kind == PairKind::Tiny) return 0.0025;
    return kind == PairKind::Huge ? 50 : 1;
}

Region turnedAbout(const Region& region, const Vec2& p, double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return turned(region, angle_rad, p - Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y()));
}

/// A chord and the arc of a far larger circle below it.
Region shallowCap(const Vec2& p, double width, double radius_mm) {
    const double half = std::asin(width / 2 / radius_mm);
    const Vec2 centre = snapToGrid(Vec2(p.x() + width / 2, p.y() + radius_mm * std::cos(half)));
    const Arc arc{centre, snapToGrid((p - centre).norm()), true};
    return Region{{Loop{p, {{Vec2(p.x() + width, p.y()), arc}, {p, std::nullopt}}}}};
}

}  // namespace

PairMaker::PairMaker(unsigned seed, PairKind kind) : random_(seed), kind_(kind), scale_(scaleOf(kind)) {}

Region PairMaker::region() {
    const Tolerances tol;
    std::vector<Region> parts(1 + below(4));
    for (Region& part : parts)
        part = shape();
    Region result = unite(parts, tol);
    if (kind_ != PairKind::Chained) return result;
    for (unsigned i = 0, n = 1 + below(4); i < n; ++i) {
        const Region next = shape();
        result = below(2) ? subtract(result, next, tol) : unite(result, next, tol);
        if (below(3) == 0) result = nudged(result);
    }
    return result;
}

Path PairMaker::path() {
    Path result{{coordinate(), coordinate()}, {}};
    for (unsigned i = 0, n = 1 + below(4); i < n; ++i) {
        const Vec2 from = result.end();
        Vec2 to(coordinate(), coordinate());
        if (to == from) to.x() += 5;
        if (below(2) == 0) {
            const Vec2 centre = snapToGrid(Vec2((from + to) / 2));
            const double radius_mm = snapToGrid((from - centre).norm());
            result.segments.push_back({to, Arc{centre, radius_mm, below(2) == 0}});
        } else {
            result.segments.push_back({to, std::nullopt});
        }
    }
    return result;
}

Region PairMaker::plainShape(unsigned which) {
    const Vec2 p(coordinate(), coordinate());
    const double w = size();
    const double h = size();
    switch (which) {
        case 0:
            return makeRectangle(p, p + Vec2(w, h));
        case 1:
            return makeCircle(p, w / 2);
        case 2:
            return makeRoundedRectangle(p, p + Vec2(w, h),
                                        onLattice() ? 2.5 * scale_ : real(0, std::min(w, h) / 2));
        case 3:
            return makePolygon({p, p + Vec2(w, 0), p + Vec2(0, w)});
        case 4: {
            Region ring = makeCircle(p, w);
            ring.loops.push_back(reversed(makeCircle(p, w / 2).loops.front()));
            return ring;
        }
        default:
            return makePolygon(
                {p + Vec2(w / 2, 0), p + Vec2(0, w / 2), p - Vec2(w / 2, 0), p - Vec2(0, w / 2)});
    }
}

Region PairMaker::wideShape(unsigned which) {
    const Vec2 p(coordinate(), coordinate());
    const double w = size();
    switch (which) {
        case 0: {  // a slot along 3 : 4, whose corners stay on the lattice
            const Region slot = makeRoundedRectangle(p, p + scale_ * Vec2(20, 5), 2.5 * scale_);
            return turnedAbout(slot, p, below(2) ? std::atan2(3, 4) : std::atan2(4, 3));
        }
        case 1: {
            Region two = makeCircle(p, w / 2);
            two.loops.push_back(makeCircle(p + Vec2(0.6 * w, 0.8 * w), w / 2).loops.front());
            return two;
        }
        case 2: {  // walls 1 to 100 um apart
            const double thin = 1e-3 * std::pow(10.0, below(3));
            return turnedAbout(makeRectangle(p, p + Vec2(w, thin)), p, kPi / 4 * below(4));
        }
        default:
            return shallowCap(p, w, 50 * scale_);
    }
}

Region PairMaker::shape() {
    const unsigned which = below(wide() ? 10 : 6);
    Region result = which < 6 ? plainShape(which) : wideShape(which - 6);
    if (kind_ == PairKind::Turned) {
        const double little = std::pow(10.0, -3.0 - below(6));
        const double angle = below(3) == 0 ? real(0, 2 * kPi) : kPi / 2 * below(4) + little;
        result = turnedAbout(result, {20, 20}, angle);
    }
    const bool sometimes = kind_ == PairKind::Tangent || kind_ == PairKind::Chained;
    return kind_ == PairKind::Shifted || (sometimes && below(3) == 0) ? nudged(result) : result;
}

Region PairMaker::nudged(const Region& region) {
    const double by_mm = kGridMm * std::pow(10.0, below(4));
    const double dx = real(-by_mm, by_mm);
    return translated(region, {dx, real(-by_mm, by_mm)});
}

}  // namespace stepmill::test
