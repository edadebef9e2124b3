// The lengths and times of a path, and its look from above.

#include <algorithm>
#include <cmath>

#include "stepmill/core/enum_words.h"
#include "stepmill/core/units.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill {

namespace {

constexpr EnumWord<Pattern> kPatterns[] = {{Pattern::Best, "best"},
                                           {Pattern::ContourInsideOut, "contour-parallel"},
                                           {Pattern::ContourOutsideIn, "contour-parallel from outside in"},
                                           {Pattern::StockOffset, "stock-offset"},
                                           {Pattern::Zigzag, "zigzag"},
                                           {Pattern::OneWay, "one-way"},
                                           {Pattern::Adaptive, "adaptive"}};

double lengthOf(const Vec3& from, const Move& move) {
    const double flat = length(Vec2(from.head<2>()), Segment{move.to.head<2>(), move.arc});
    return std::hypot(flat, move.to.z() - from.z());
}

}  // namespace

Edge edgeOf(const Vec3& from, const Move& move) {
    return makeEdge(from.head<2>(), {Vec2(move.to.head<2>()), move.arc});
}

std::string toString(Pattern pattern) {
    return wordOf(kPatterns, pattern);
}

std::optional<Pattern> patternFrom(std::string_view word) {
    return valueOf(kPatterns, word);
}

bool isAmong(const std::vector<Pattern>& patterns, Pattern pattern) {
    return patterns.empty() || std::find(patterns.begin(), patterns.end(), pattern) != patterns.end();
}

PathTotals& PathTotals::operator+=(const PathTotals& other) {
    cut_length_mm += other.cut_length_mm;
    feed_air_length_mm += other.feed_air_length_mm;
    air_length_mm += other.air_length_mm;
    feed_time_s += other.feed_time_s;
    rapid_time_s += other.rapid_time_s;
    motion_time_s += other.motion_time_s;
    return *this;
}

double Toolpath::feedOf(MoveKind kind) const {
    switch (kind) {
        case MoveKind::Rapid:
            return 0;
        case MoveKind::Feed:
            return feed_mm_per_min;
        case MoveKind::Slot:
            return slot_feed_mm_per_min;
        case MoveKind::Ramp:
            return ramp_feed_mm_per_min;
        case MoveKind::Plunge:
            return plunge_feed_mm_per_min;
    }
    return 0;
}

double rampFeed(double feed_mm_per_min, double plunge_feed_mm_per_min, double angle_rad) {
    return std::min(feed_mm_per_min, plunge_feed_mm_per_min / std::sin(angle_rad));
}

PathTotals measure(const Toolpath& path, const Machine& machine) {
    PathTotals totals;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const double length_mm = lengthOf(from, move);
        from = move.to;
        if (move.kind == MoveKind::Rapid) {
            totals.air_length_mm += length_mm;
            totals.rapid_time_s += length_mm / machine.rapid_mm_per_min * kSecondsPerMinute;
            continue;
        }
        const double feed = path.feedOf(move);
        totals.cut_length_mm += length_mm;
        totals.feed_time_s += length_mm / feed * kSecondsPerMinute;
        if (move.in_air) totals.feed_air_length_mm += length_mm;
    }
    const bool accelerates = machine.acceleration_mm_per_s2 > 0;
    totals.motion_time_s = accelerates ? motionTimeS(path, machine) : totals.time_s();
    return totals;
}

std::vector<Path> topView(const Toolpath& path) {
    double deepest = path.start.z();
    for (const Move& move : path.moves)
        deepest = std::min(deepest, move.to.z());
    std::vector<Path> chains;
    Vec3 from = path.start;
    bool goes_on = false;
    for (const Move& move : path.moves) {
        const bool shown = (move.kind == MoveKind::Feed || move.kind == MoveKind::Slot) &&
                           from.z() == deepest && move.to.z() == deepest;
        if (shown && !goes_on) chains.push_back({from.head<2>(), {}});
        if (shown) chains.back().segments.push_back({move.to.head<2>(), move.arc});
        goes_on = shown;
        from = move.to;
    }
    return chains;
}

}  // namespace stepmill
