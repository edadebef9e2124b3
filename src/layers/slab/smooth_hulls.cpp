// Outlines of facets' hulls with fewer edges.

#include "layers/slab/smooth_hulls.h"

#include "layers/section/curve_fit.h"
#include "layers/section/tidy_loop.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::layers {

namespace {

/// Lines of a run are at most this many slacks long ...
constexpr double kShortSlacks = 20;
/// ... and a run worth fitting has this many of them.
constexpr std::size_t kLeastRun = 8;
/// The fit may lie this share of its tolerance inside its points (see fitSafeSide): they go out by more.
constexpr double kOutShare = 0.06;

bool isShort(const Vec2& from, const Segment& segment, double short_mm) {
    return !segment.arc && (segment.to - from).norm() <= short_mm;
}

/// The points, all but the ends a little to the right.
std::vector<Vec2> pushedOut(const std::vector<Vec2>& points, double by_mm) {
    std::vector<Vec2> pushed = points;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Vec2 along = (points[i + 1] - points[i - 1]).normalized();
        pushed[i] += by_mm * Vec2(along.y(), -along.x());
    }
    return pushed;
}

/// The loop begun at an edge that is not short, so that no run goes over its end.
Loop begunAtLongEdge(Loop loop, double short_mm) {
    Vec2 from = loop.start;
    for (std::size_t i = 0; i < loop.segments.size(); ++i) {
        if (!isShort(from, loop.segments[i], short_mm)) {
            std::rotate(loop.segments.begin(), loop.segments.begin() + static_cast<std::ptrdiff_t>(i),
                        loop.segments.end());
            loop.start = from;
            return loop;
        }
        from = loop.segments[i].to;
    }
    return loop;
}

Loop smoothLoop(const Loop& sharp, double by_mm) {
    const double short_mm = kShortSlacks * by_mm;
    const Loop loop = begunAtLongEdge(sharp, short_mm);
    std::vector<Segment> kept;
    Vec2 from = loop.start;
    for (std::size_t i = 0; i < loop.segments.size();) {
        std::vector<Vec2> run{from};
        std::size_t end = i;
        while (end < loop.segments.size() && isShort(run.back(), loop.segments[end], short_mm))
            run.push_back(loop.segments[end++].to);
        if (end - i >= kLeastRun) {
            const std::vector<Segment> fitted = fitSafeSide(pushedOut(run, kOutShare * by_mm), by_mm);
            kept.insert(kept.end(), fitted.begin(), fitted.end());
        } else {
            end = std::max(end, i + 1);
            kept.insert(kept.end(), loop.segments.begin() + static_cast<std::ptrdiff_t>(i),
                        loop.segments.begin() + static_cast<std::ptrdiff_t>(end));
        }
        i = end;
        from = loop.segments[end - 1].to;
    }
    return tidyLoop(std::move(kept));
}

}  // namespace

Region smoothHulls(const Region& region, double by_mm, const Tolerances& tol) {
    if (by_mm <= tol.gouge_mm) return region;
    Region smooth;
    for (const Loop& loop : region.loops) {
        Loop fitted = smoothLoop(loop, by_mm);
        // A hole as narrow as the slack may close; an outline may not vanish.
        if (fitted.segments.empty() && signedArea(loop) > 0) return region;
        if (!fitted.segments.empty()) smooth.loops.push_back(std::move(fitted));
    }
    sortLoops(smooth);
    if (diagnose(smooth) || !covers(smooth, region, tol.gouge_mm, tol)) return region;
    return smooth;
}

}  // namespace stepmill::layers
