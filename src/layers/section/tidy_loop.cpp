// Loops in the one form that equal walls share.

#include "layers/section/tidy_loop.h"

#include "stepmill/core/units.h"

namespace stepmill::layers {

bool sameCircle(const Arc& a, const Arc& b) {
    return a.ccw == b.ccw && (a.centre - b.centre).norm() <= kJointMm &&
           std::abs(a.radius_mm - b.radius_mm) <= kJointMm;
}

namespace {

/// Can the two edges from `from` over `via` to `to` be one?
bool oneCurve(const Vec2& from, const Segment& first, const Segment& second) {
    if (first.arc.has_value() != second.arc.has_value()) return false;
    const Vec2& via = first.to;
    const Vec2& to = second.to;
    if (first.arc) {
        if (!sameCircle(*first.arc, *second.arc)) return false;
        return std::abs(sweepAngle(from, via, *first.arc) + sweepAngle(via, to, *second.arc)) <
               2 * kPi - 1e-6;
    }
    const Vec2 chord = to - from;
    const double length = chord.norm();
    if (length <= kJointMm || (via - from).dot(chord) <= 0 || (to - via).dot(chord) <= 0) return false;
    return std::abs(cross(chord, via - from)) <= kJointMm / 2 * length;
}

bool isNothing(const Vec2& from, const Segment& segment) {
    if ((segment.to - from).norm() > kJointMm) return false;
    return !segment.arc || std::abs(sweepAngle(from, segment.to, *segment.arc)) < kPi;
}

void dropNothings(std::vector<Segment>& segments) {
    std::vector<Segment> kept;
    for (const Segment& segment : segments) {
        if (!kept.empty() && isNothing(kept.back().to, segment)) continue;
        kept.push_back(segment);
    }
    // The joint of the last edge with the first: the first starts where the last ends.
    while (kept.size() > 1 && isNothing(kept.back().to, kept.front()))
        kept.erase(kept.begin());
    segments = std::move(kept);
}

void mergeNeighbours(std::vector<Segment>& segments) {
    bool changed = true;
    while (changed && segments.size() > 2) {
        changed = false;
        const std::size_t n = segments.size();
        for (std::size_t i = 0; i < n && !changed; ++i) {
            const Vec2 from = segments[(i + n - 1) % n].to;
            const std::size_t j = (i + 1) % n;
            if (!oneCurve(from, segments[i], segments[j])) continue;
            segments[i].to = segments[j].to;
            segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(j));
            changed = true;
        }
    }
}

bool isCircle(const std::vector<Segment>& segments) {
    if (segments.empty() || !segments.front().arc) return false;
    for (const Segment& segment : segments)
        if (!segment.arc || !sameCircle(*segment.arc, *segments.front().arc)) return false;
    return true;
}

bool lessPoint(const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

}  // namespace

Loop tidyLoop(std::vector<Segment> segments) {
    dropNothings(segments);
    mergeNeighbours(segments);
    if (isCircle(segments)) {
        const Arc& arc = *segments.front().arc;
        if (arc.radius_mm < kJointMm) return {};
        const Loop circle = makeCircle(arc.centre, arc.radius_mm).loops.front();
        return arc.ccw ? circle : reversed(circle);
    }
    if (segments.size() < 2) return {};
    const auto least = std::min_element(segments.begin(), segments.end(),
                                        [](const auto& a, const auto& b) { return lessPoint(a.to, b.to); });
    std::rotate(segments.begin(), least + 1, segments.end());
    Loop loop{segments.back().to, std::move(segments)};
    if (std::abs(signedArea(loop)) < kJointMm * length(loop)) return {};
    return loop;
}

void sortLoops(Region& region) {
    std::stable_sort(region.loops.begin(), region.loops.end(), [](const Loop& a, const Loop& b) {
        const double area_a = signedArea(a);
        const double area_b = signedArea(b);
        if ((area_a > 0) != (area_b > 0)) return area_a > 0;
        return a.start != b.start ? lessPoint(a.start, b.start) : area_a < area_b;
    });
}

}  // namespace stepmill::layers
