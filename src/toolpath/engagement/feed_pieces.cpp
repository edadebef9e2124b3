#include "toolpath/engagement/feed_pieces.h"

#include <algorithm>

#include "stepmill/core/units.h"

namespace stepmill::toolpath {
namespace {

/// A change of feed is worth this much [s].
constexpr double kLeastSavingS = 0.2;

struct Piece {
    std::size_t steps;
    double feed_mm_per_min;
};

/// What two pieces take longer as one, at the lesser feed [steps min/mm].
double loss(const Piece& a, const Piece& b) {
    const bool a_slower = a.feed_mm_per_min < b.feed_mm_per_min;
    const Piece& fast = a_slower ? b : a;
    const Piece& slow = a_slower ? a : b;
    return static_cast<double>(fast.steps) * (1 / slow.feed_mm_per_min - 1 / fast.feed_mm_per_min);
}

std::vector<Piece> runsOf(const std::vector<double>& feeds) {
    std::vector<Piece> runs;
    for (const double feed : feeds) {
        if (runs.empty() || runs.back().feed_mm_per_min != feed) runs.push_back({0, feed});
        ++runs.back().steps;
    }
    return runs;
}

}  // namespace

std::vector<double> feedPieces(const std::vector<double>& feeds, double length_mm) {
    std::vector<Piece> pieces = runsOf(feeds);
    const double step_s = length_mm / static_cast<double>(feeds.size()) * kSecondsPerMinute;
    while (pieces.size() > 1) {
        std::size_t cheapest = 0;
        for (std::size_t i = 1; i + 1 < pieces.size(); ++i)
            if (loss(pieces[i], pieces[i + 1]) < loss(pieces[cheapest], pieces[cheapest + 1])) cheapest = i;
        if (loss(pieces[cheapest], pieces[cheapest + 1]) * step_s >= kLeastSavingS) break;
        Piece& joined = pieces[cheapest];
        const Piece& next = pieces[cheapest + 1];
        joined = {joined.steps + next.steps, std::min(joined.feed_mm_per_min, next.feed_mm_per_min)};
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(cheapest) + 1);
    }
    std::vector<double> ends;
    std::size_t steps = 0;
    for (const Piece& piece : pieces) {
        steps += piece.steps;
        ends.push_back(static_cast<double>(steps) / static_cast<double>(feeds.size()));
    }
    return ends;
}

}  // namespace stepmill::toolpath
