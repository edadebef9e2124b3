#include "stepmill/sequence/advice/ranking.h"

#include <tuple>

#include "stepmill/core/units.h"
#include "stepmill/sequence/advice/area_models.h"

namespace stepmill {
namespace {

std::vector<AreaModelTool> modelTools(const std::vector<AccessRow>& rows) {
    std::vector<AreaModelTool> tools;
    for (const AccessRow& row : rows) {
        AreaModelTool tool;
        tool.radius_mm = row.diameter_mm / 2;
        tool.volume_mm3 = row.volume_cm3 * kMm3PerCm3;
        tool.rate_mm3_per_s = row.mrr_cm3_per_min * kMm3PerCm3 / kSecondsPerMinute;
        tools.push_back(tool);
    }
    return tools;
}

class Ranker {
  public:
    explicit Ranker(std::vector<AreaModelTool> tools) : tools_(std::move(tools)) { rank(); }

    /// Rows by rank.
    const std::vector<int>& ranks() const { return ranks_; }

    /// Time of the first `count` ranks and, unless it is negative, of `wider` before them [s].
    double timeS(std::size_t count, int wider, double tool_change_s) const {
        std::vector<int> rows(ranks_.begin(), ranks_.begin() + static_cast<std::ptrdiff_t>(count));
        if (wider >= 0) rows.push_back(wider);
        std::reverse(rows.begin(), rows.end());
        double time_s = 0;
        double before_mm3 = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            time_s += limEdgeS(before_mm3, tools_[rows[i]], i == 0 ? 0 : tool_change_s);
            before_mm3 = tools_[rows[i]].volume_mm3;
        }
        return time_s;
    }

    /// Does the wider cutter reach something, but no more than the narrower one, as both models assume?
    bool reachesPartOf(int narrower, int wider) const {
        return tools_[wider].volume_mm3 > 0 && tools_[wider].volume_mm3 <= tools_[narrower].volume_mm3;
    }

    /// As many ranks as pay.
    RankedSet greedy(double tool_change_s) const {
        RankedSet best;
        for (std::size_t count = 1; count <= ranks_.size(); ++count) {
            const double total_min = timeS(count, -1, tool_change_s) / kSecondsPerMinute;
            if (count > 1 && total_min >= best.total_min) continue;
            best.rows.assign(ranks_.rend() - static_cast<std::ptrdiff_t>(count), ranks_.rend());
            best.total_min = total_min;
        }
        return best;
    }

    /// The optimum over all sequences.
    RankedSet shortestPath(double tool_change_s) const {
        const int n = static_cast<int>(tools_.size());
        const std::vector<AreaModelTool> falling(tools_.rbegin(), tools_.rend());
        const CheapestPath path = cheapestByLim(falling, tool_change_s, FirstChange::Free);
        RankedSet set;
        for (const int node : path.tools)
            set.rows.push_back(n - 1 - node);
        if (!path.tools.empty()) set.total_min = path.cost / kSecondsPerMinute;
        return set;
    }

  private:
    void rank() {
        const int n = static_cast<int>(tools_.size());
        double most_mm3 = 0;
        for (const AreaModelTool& tool : tools_)
            most_mm3 = std::max(most_mm3, tool.volume_mm3);
        if (most_mm3 <= 0) return;
        int last = n - 1;
        while (tools_[last].volume_mm3 < most_mm3 * (1 - kFullAccessShare))
            --last;
        ranks_ = {last};
        for (double known_s = timeS(1, -1, 0);;) {
            int next = -1;
            for (int wider = ranks_.back() + 1; wider < n; ++wider) {
                // With equal reach the narrower one would do nothing.
                if (tools_[wider].volume_mm3 >= tools_[ranks_.back()].volume_mm3) continue;
                const double time_s = timeS(ranks_.size(), wider, 0);
                if (time_s >= known_s) continue;
                known_s = time_s;
                next = wider;
            }
            if (next < 0) return;
            ranks_.push_back(next);
        }
    }

    std::vector<AreaModelTool> tools_;
    std::vector<int> ranks_;
};

RankedRow rankedRow(int index, const AccessRow& cutter, double most_cm3, const Ranker& ranker,
                    double tool_change_s) {
    RankedRow row;
    row.cutter = cutter;
    row.time_min = cutter.volume_cm3 / cutter.mrr_cm3_per_min;
    row.share = most_cm3 > 0 ? cutter.volume_cm3 / most_cm3 : 0;
    const std::vector<int>& ranks = ranker.ranks();
    if (ranks.empty()) return row;
    const auto found = std::find(ranks.begin(), ranks.end(), index);
    if (found != ranks.end()) row.rank = static_cast<int>(found - ranks.begin());
    const auto narrower = static_cast<std::size_t>(
        std::count_if(ranks.begin(), ranks.end(), [&](int rank) { return rank < index; }));
    const bool reaches_part = narrower > 0 && ranker.reachesPartOf(ranks[narrower - 1], index);
    if (reaches_part) row.dvcd_min = ranker.timeS(narrower, index, 0) / kSecondsPerMinute;
    const std::size_t so_far = std::max<std::size_t>(1, narrower + (row.rank ? 1 : 0));
    row.rdvc_min = ranker.timeS(so_far, -1, 0) / kSecondsPerMinute;
    row.rdvc_with_changes_min = ranker.timeS(so_far, -1, tool_change_s) / kSecondsPerMinute;
    return row;
}

}  // namespace

Ranking rankTools(std::vector<AccessRow> table, double tool_change_s) {
    std::stable_sort(table.begin(), table.end(), [](const AccessRow& a, const AccessRow& b) {
        return std::tuple(a.diameter_mm, -a.volume_cm3, a.mrr_cm3_per_min) <
               std::tuple(b.diameter_mm, -b.volume_cm3, b.mrr_cm3_per_min);
    });
    double most_cm3 = 0;
    for (const AccessRow& cutter : table)
        most_cm3 = std::max(most_cm3, cutter.volume_cm3);
    const Ranker ranker(modelTools(table));
    Ranking ranking;
    ranking.tool_change_s = tool_change_s;
    for (std::size_t i = 0; i < table.size(); ++i)
        ranking.rows.push_back(rankedRow(static_cast<int>(i), table[i], most_cm3, ranker, tool_change_s));
    ranking.greedy = ranker.greedy(tool_change_s);
    ranking.shortest_path = ranker.shortestPath(tool_change_s);
    return ranking;
}

}  // namespace stepmill
