// First and second moments of area, as integrals along the lines and arcs.

#include <array>
#include <cmath>

#include "planar/segment.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/region.h"

namespace stepmill {

namespace {

/// Gauss' rule with ten points on [-1, 1], one half of it. Over an eighth of a turn it is exact to the last
/// digit for the products of sines and cosines that moments are made of.
struct Node {
    double at;
    double weight;
};
constexpr std::array<Node, 5> kGauss{{{0.1488743389816312, 0.2955242247147529},
                                      {0.4333953941292472, 0.2692667193099963},
                                      {0.6794095682990244, 0.2190863625159820},
                                      {0.8650633666889845, 0.1494513491505806},
                                      {0.9739065285171717, 0.0666713443086881}}};

/// Integrals over the area between the origin and the boundary walked so far, with sign.
struct Sums {
    double area = 0;
    Vec2 first = Vec2::Zero();
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();

    /// The thin triangle from the origin to the stretch from p along `step`: integrands of degree n in the
    /// distance from the origin gather 1 / (n + 2) of their value at the far end.
    void add(const Vec2& p, const Vec2& step) {
        const double turn = cross(p, step);
        area += turn / 2;
        first += turn / 3 * p;
        second += turn / 4 * p * p.transpose();
    }
};

void addLine(Sums& sums, const Vec2& a, const Vec2& b) {
    const double triangle = cross(a, b) / 2;
    const Vec2 both = a + b;
    sums.area += triangle;
    sums.first += triangle / 3 * both;
    sums.second += triangle / 12 * (a * a.transpose() + b * b.transpose() + both * both.transpose());
}

/// `a` is where the arc begins, seen from the origin. Positions go by turns from there, not from the centre,
/// which of a shallow arc is too far away to keep the digits.
void addArc(Sums& sums, const Vec2& a, const Vec2& from, const Segment& segment) {
    const Arc& arc = *segment.arc;
    const double sweep = sweepAngle(from, segment.to, arc);
    const int steps = static_cast<int>(std::ceil(std::abs(sweep) / (kPi / 4)));
    const double half = sweep / (2 * steps);
    const Vec2 spoke = from - arc.centre;
    const double begin = std::atan2(spoke.y(), spoke.x());
    for (int i = 0; i < steps; ++i)
        for (const Node& node : kGauss)
            for (const double side : {-1.0, 1.0}) {
                const double turned = (2 * i + 1 + side * node.at) * half;
                const double middle = begin + turned / 2;
                const Vec2 chord =
                    2 * arc.radius_mm * std::sin(turned / 2) * Vec2(-std::sin(middle), std::cos(middle));
                const double angle = begin + turned;
                const Vec2 along = arc.radius_mm * Vec2(-std::sin(angle), std::cos(angle));
                sums.add(a + chord, node.weight * half * along);
            }
}

}  // namespace

Moments moments(const Region& region) {
    STEPMILL_CHECK(!region.empty(), "the empty region has no centre of area");
    const Vec2 origin = (boundingBox(region).min() + boundingBox(region).max()) / 2;
    Sums sums;
    for (const auto& [from, segment] : eachEdge(region)) {
        if (segment.arc)
            addArc(sums, from - origin, from, segment);
        else
            addLine(sums, from - origin, segment.to - origin);
    }
    STEPMILL_CHECK(sums.area > 0, "centre of area of a region without area");
    const Vec2 centre = sums.first / sums.area;
    return {sums.area, origin + centre, sums.second - sums.area * centre * centre.transpose()};
}

Vec2 centroid(const Region& region) {
    return moments(region).centroid;
}

}  // namespace stepmill
