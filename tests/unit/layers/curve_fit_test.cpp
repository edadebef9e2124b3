#include <gtest/gtest.h>

#include "layers/section/curve_fit.h"
#include "layers/slab/smooth_hulls.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"

using namespace stepmill;

namespace {

std::vector<Vec2> ellipse(double a, double b, bool ccw) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 400; ++i) {
        const double t = (ccw ? 1 : -1) * 2 * kPi * i / 400;
        points.emplace_back(a * std::cos(t), b * std::sin(t));
    }
    return points;
}

/// How far the fit lies outside (right of) the points: least and most.
std::pair<double, double> outside(const std::vector<Vec2>& points, const std::vector<Segment>& fit) {
    Path path{points.front(), fit};
    path.segments.back().to = path.start;
    Region region{{path}};
    const bool ccw = signedArea(path) > 0;
    if (!ccw) region.loops[0] = reversed(path);
    std::pair<double, double> range{1e300, -1e300};
    for (const Vec2& p : points) {
        const double inside = contains(region, p) ? 1 : -1;
        const double d = distanceToBoundary(region, p) * inside * (ccw ? 1 : -1);
        range.first = std::min(range.first, d);
        range.second = std::max(range.second, d);
    }
    return range;
}

}  // namespace

TEST(FitSafeSide, NeverTakesMaterialFromAnEllipticBoss) {
    const auto points = ellipse(10, 6, true);
    const auto fit = layers::fitSafeSide(points, 1e-3);
    const auto [least, most] = outside(points, fit);
    EXPECT_GE(least, -0.06e-3);
    EXPECT_LE(most, 1.01e-3);
    EXPECT_LT(fit.size(), 60u);
}

TEST(FitSafeSide, NeverTakesMaterialFromAnEllipticHole) {
    const auto points = ellipse(10, 6, false);
    const auto [least, most] = outside(points, layers::fitSafeSide(points, 1e-3));
    EXPECT_GE(least, -0.06e-3);
    EXPECT_LE(most, 1.01e-3);
}

TEST(FitSafeSide, StraightChainIsOneLine) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 50; ++i)
        points.emplace_back(i * 0.3, i * 0.1);
    const auto fit = layers::fitSafeSide(points, 1e-3);
    EXPECT_LE(fit.size(), 3u);
    EXPECT_EQ(fit.back().to, points.back());
}

TEST(SmoothHulls, AHullOfManyLinesBecomesAFewEdgesOnItsOutside) {
    std::vector<Vec2> corners{{0, 0}, {30, 0}};
    for (int i = 0; i <= 200; ++i) {
        // A bulge of short lines between long sides, rough by two hundredths as facets' hulls are.
        const double t = kPi * i / 200;
        const double r = 15 + (i % 2 == 0 ? 0.0 : 0.02);
        corners.push_back(snapToGrid(Vec2(15 + r * std::cos(t), 10 + r * std::sin(t))));
    }
    const Region rough = makePolygon(corners);
    const Tolerances tol;
    const Region smooth = layers::smoothHulls(rough, 0.1, tol);
    EXPECT_LT(smooth.loops.front().segments.size(), 20u);
    EXPECT_TRUE(covers(smooth, rough, tol.gouge_mm, tol));
    EXPECT_LT(area(smooth) - area(rough), 0.11 * perimeter(rough));
    // What has no runs of short lines stays as it is.
    const Region box = makePolygon({{0, 0}, {30, 0}, {30, 20}, {0, 20}});
    EXPECT_EQ(area(layers::smoothHulls(box, 0.1, tol)), area(box));
}
