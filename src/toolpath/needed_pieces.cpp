#include "toolpath/needed_pieces.h"

#include <algorithm>

namespace stepmill::toolpath {
namespace {

/// Is `next` the rest of the line or arc that `last`, from there, is a part of?
bool goesOn(const Vec2& from, const Segment& last, const Segment& next) {
    if (last.arc || next.arc) return last.arc == next.arc;
    const Vec2 before = last.to - from, after = next.to - last.to;
    return before.dot(after) > 0 &&
           std::abs(cross(before, after)) <= kGridMm * std::max(before.norm(), after.norm());
}

/// Edges were cut to be asked one by one; the path has them whole again.
void add(Path& path, const Segment& segment) {
    const std::size_t count = path.segments.size();
    const Vec2 from = count > 1 ? path.segments[count - 2].to : path.start;
    if (count > 0 && segment.to != from && goesOn(from, path.segments.back(), segment))
        path.segments.back().to = segment.to;
    else
        path.segments.push_back(segment);
}

}  // namespace

std::vector<char> bridged(const std::vector<Edge>& edges, const std::vector<char>& needed,
                          double longest_mm) {
    const std::size_t count = edges.size();
    std::vector<char> with_bridges = needed;
    for (std::size_t i = 0; i < count; ++i) {
        if (needed[i] == 0 || needed[(i + 1) % count] != 0) continue;
        double gap_mm = 0;
        std::size_t gap = 0;
        for (; needed[(i + 1 + gap) % count] == 0; ++gap)
            gap_mm += length(edges[(i + 1 + gap) % count]);
        for (std::size_t k = 0; gap_mm <= longest_mm && k < gap; ++k)
            with_bridges[(i + 1 + k) % count] = 1;
    }
    return with_bridges;
}

std::vector<Path> neededPieces(const Loop& loop, const std::vector<Edge>& edges,
                               const std::vector<char>& needed, double bridge_mm) {
    if (std::find(needed.begin(), needed.end(), 1) == needed.end()) return {};
    const std::vector<char> taken = bridged(edges, needed, bridge_mm);
    const auto gap = std::find(taken.begin(), taken.end(), 0);
    if (gap == taken.end()) return {loop};
    std::vector<Path> pieces;
    const auto first = static_cast<std::size_t>(gap - taken.begin());
    for (std::size_t k = 1; k <= edges.size(); ++k) {
        const std::size_t i = (first + k) % edges.size();
        if (taken[i] == 0) continue;
        if (taken[(first + k - 1) % edges.size()] == 0) pieces.push_back({edges[i].from, {}});
        add(pieces.back(), edges[i].segment);
    }
    return pieces;
}

}  // namespace stepmill::toolpath
