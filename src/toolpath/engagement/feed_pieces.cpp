#include "toolpath/engagement/feed_pieces.h"

#include <algorithm>

#include "stepmill/core/units.h"

namespace stepmill::toolpath {
namespace {

/// A change of feed is worth this much [s].
constexpr double kLeastSavingS = 0.2;

struct Piece {
    double end_mm;
    double length_mm;
    double feed_mm_per_min;
};

/// What two pieces take longer as one, at the lesser feed [s].
double lossS(const Piece& a, const Piece& b) {
    const bool a_slower = a.feed_mm_per_min < b.feed_mm_per_min;
    const Piece& fast = a_slower ? b : a;
    const Piece& slow = a_slower ? a : b;
    return fast.length_mm * (1 / slow.feed_mm_per_min - 1 / fast.feed_mm_per_min) * kSecondsPerMinute;
}

std::vector<Piece> runsOf(const std::vector<double>& feeds, double step_mm, double length_mm) {
    std::vector<Piece> runs;
    double begin_mm = 0;
    for (std::size_t i = 0; i < feeds.size(); ++i) {
        const bool last = i + 1 == feeds.size();
        const double end_mm = last ? length_mm : std::min(length_mm, begin_mm + step_mm);
        if (runs.empty() || runs.back().feed_mm_per_min != feeds[i]) runs.push_back({end_mm, 0, feeds[i]});
        runs.back().end_mm = end_mm;
        runs.back().length_mm += end_mm - begin_mm;
        begin_mm = end_mm;
    }
    return runs;
}

}  // namespace

std::vector<double> feedPieces(const std::vector<double>& feeds, double step_mm, double length_mm) {
    std::vector<Piece> pieces = runsOf(feeds, step_mm, length_mm);
    while (pieces.size() > 1) {
        std::size_t cheapest = 0;
        for (std::size_t i = 1; i + 1 < pieces.size(); ++i)
            if (lossS(pieces[i], pieces[i + 1]) < lossS(pieces[cheapest], pieces[cheapest + 1])) cheapest = i;
        if (lossS(pieces[cheapest], pieces[cheapest + 1]) >= kLeastSavingS) break;
        Piece& joined = pieces[cheapest];
        const Piece& next = pieces[cheapest + 1];
        joined = {next.end_mm, joined.length_mm + next.length_mm,
                  std::min(joined.feed_mm_per_min, next.feed_mm_per_min)};
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(cheapest) + 1);
    }
    std::vector<double> ends;
    for (const Piece& piece : pieces)
        ends.push_back(piece.end_mm / length_mm);
    ends.back() = 1;
    return ends;
}

}  // namespace stepmill::toolpath
