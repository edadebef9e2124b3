#include <cmath>

#include <polyclipping/clipper.hpp>

#include "bench/kernels.h"

namespace stepmill::bench {
namespace {

using ClipperLib::Paths;

constexpr double kUnitsPerMm = 1e6;

Paths paths(const Region& region) {
    Paths result;
    for (const Loop& loop : region.loops) {
        ClipperLib::Path path;
        for (const Vec2& p : tessellate(loop, kChordMm))
            path.emplace_back(std::llround(p.x() * kUnitsPerMm), std::llround(p.y() * kUnitsPerMm));
        path.pop_back();  // closed without repeating the first point
        result.push_back(std::move(path));
    }
    return result;
}

Paths grown(const Paths& shape, double distance_mm) {
    constexpr double kMiterLimit = 2;  // not used by round joins
    ClipperLib::ClipperOffset offset(kMiterLimit, kChordMm * kUnitsPerMm);
    offset.AddPaths(shape, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
    Paths result;
    offset.Execute(result, distance_mm * kUnitsPerMm);
    return result;
}

Paths difference(const Paths& a, const Paths& b) {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(a, ClipperLib::ptSubject, true);
    clipper.AddPaths(b, ClipperLib::ptClip, true);
    Paths result;
    clipper.Execute(ClipperLib::ctDifference, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    return result;
}

double areaOf(const Paths& shape) {
    double sum = 0;
    for (const ClipperLib::Path& path : shape)
        sum += ClipperLib::Area(path);
    return sum / (kUnitsPerMm * kUnitsPerMm);
}

}  // namespace

double ClipperKernel::openings(const Region& region, const std::vector<double>& radii_mm) const {
    const Paths shape = paths(region);
    double sum = 0;
    for (const double radius : radii_mm)
        sum += areaOf(grown(grown(shape, -radius), radius));
    return sum;
}

double ClipperKernel::insets(const Region& region, const std::vector<double>& distances_mm) const {
    const Paths shape = paths(region);
    double sum = 0;
    for (const double distance : distances_mm)
        sum += areaOf(grown(shape, -distance));
    return sum;
}

double ClipperKernel::rings(const Region& region, double step_mm) const {
    const Paths shape = paths(region);
    double sum = 0;
    for (double distance = step_mm / 2;; distance += step_mm) {
        const Paths ring = grown(shape, -distance);
        if (ring.empty()) return sum;
        sum += areaOf(ring);
    }
}

Pairs ClipperKernel::decomposed(const Region& region, const std::vector<double>& radii_mm,
                                double budget_s) const {
    const double start_s = processorSeconds();
    const Paths shape = paths(region);
    std::vector<Paths> centres;
    std::vector<Paths> accessible;
    for (const double radius : radii_mm) {
        centres.push_back(grown(shape, -radius));
        accessible.push_back(grown(centres.back(), radius));
    }
    return runPairs(radii_mm.size(), start_s, budget_s, [&](std::size_t m, std::size_t n) {
        const Paths left = difference(centres[n], grown(accessible[m], -radii_mm[n]));
        return areaOf(grown(left, radii_mm[n]));
    });
}

}  // namespace stepmill::bench
