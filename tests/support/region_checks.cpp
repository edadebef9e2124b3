#include "support/region_checks.h"

#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "stepmill/planar/edge.h"
#include "stepmill/planar/region_text.h"
#include "stepmill/planar/svg_path.h"

namespace stepmill::test {

struct CaseTrace::Scope {
    testing::ScopedTrace trace;
};

CaseTrace::CaseTrace(const RandomRegion& which, const std::string& more)
    : which_(which),
      failed_before_(testing::Test::HasFailure()),
      scope_(new Scope{testing::ScopedTrace(__FILE__, __LINE__,
                                            name(which.kind) + " seed " + std::to_string(which.seed) + " " +
                                                more + "\n" + toText(which.region))}) {}

CaseTrace::~CaseTrace() {
    delete scope_;
    if (failed_before_ || !testing::Test::HasFailure()) return;
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string file =
        std::string(test->name()) + "_" + name(which_.kind) + std::to_string(which_.seed) + ".svg";
    for (char& c : file)
        if (c == '/') c = '_';
    const Box2 box = boundingBox(which_.region);
    const Vec2 size = box.sizes();
    std::ofstream(testing::TempDir() + file)
        << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='" << box.min().x() << ' ' << -box.max().y()
        << ' ' << size.x() << ' ' << size.y() << "'><path fill='#ccd' transform='scale(" << kGridMm << ','
        << -kGridMm << ")' d='" << toSvgPath(which_.region, kGridMm) << "'/></svg>\n";
}

double signedClearance(const Region& region, const Vec2& p) {
    const double distance = distanceToBoundary(region, p);
    return contains(region, p) ? distance : -distance;
}

Vec2 nearMedialAxis(const Region& region, Vec2 p) {
    double clearance = signedClearance(region, p);
    double step = std::abs(clearance) / 2;
    for (int i = 0; i < 12; ++i) {
        Vec2 best = p;
        for (const Vec2& way : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) {
            const Vec2 there = p + step * way;
            const double value = signedClearance(region, there);
            if (value <= clearance) continue;
            clearance = value;
            best = there;
        }
        if (best == p) step /= 2;
        p = best;
    }
    return p;
}

Vec2 probePoint(const Region& region, double grown_mm, Random& random) {
    const Vec2 p = random.point(grown(boundingBox(region), grown_mm));
    return random.below(2) ? p : nearMedialAxis(region, p);
}

Deviation deviation(const Region& offset, const Region& region, double distance_mm) {
    Deviation result;
    for (const auto& [from, segment] : eachEdge(offset)) {
        for (const double t : {0.0, 0.11, 0.5, 0.93}) {
            const Vec2 p = pointAt(from, segment, t);
            const double off_mm = distanceToBoundary(region, p) - std::abs(distance_mm);
            if (-off_mm > result.too_close_mm) {
                result.too_close_mm = -off_mm;
                result.closest_at = p;
            }
            if (off_mm > result.too_far_mm) {
                result.too_far_mm = off_mm;
                result.farthest_at = p;
            }
        }
    }
    return result;
}

double sweptBy(const Region& centres, double radius_mm, const Vec2& p) {
    if (centres.empty()) return -std::numeric_limits<double>::infinity();
    return radius_mm + signedClearance(centres, p);
}

}  // namespace stepmill::test
