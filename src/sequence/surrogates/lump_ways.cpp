#include "sequence/surrogates/lump_ways.h"

#include <algorithm>
#include <map>

namespace stepmill {
namespace {

/// Combinations looked at before the best one known is taken.
constexpr int kMostCombinations = 20000;

bool uses(const LumpWay& way, int tool) {
    return std::find(way.tools.begin(), way.tools.end(), tool) != way.tools.end();
}

/// Branch and bound over the lumps in their order.
class WayChoice {
  public:
    /// \param free_tool  not paid for, but must come last; kNoTool: all are paid for
    WayChoice(const std::vector<std::vector<LumpWay>>& lumps, double change_weight, int free_tool)
        : lumps_(lumps), change_(change_weight), free_(free_tool) {
        order_.resize(lumps.size());
        rest_.assign(lumps.size() + 1, 0);
        for (std::size_t i = lumps.size(); i-- > 0;) {
            for (std::size_t k = 0; k < lumps[i].size(); ++k)
                if (isAllowed(lumps[i][k])) order_[i].push_back(static_cast<int>(k));
            std::stable_sort(order_[i].begin(), order_[i].end(),
                             [&](int a, int b) { return lumps[i][a].weight < lumps[i][b].weight; });
            rest_[i] = order_[i].empty() ? kNoEdge : rest_[i + 1] + lumps[i][order_[i].front()].weight;
        }
    }

    ChosenWays best() {
        if (rest_[0] < kNoEdge) {
            tryOneToolForAll();
            chosen_.assign(lumps_.size(), 0);
            extend(0, 0);
        }
        return best_;
    }

  private:
    bool isAllowed(const LumpWay& way) const {
        return free_ == kNoTool || !uses(way, free_) || way.tools.back() == free_;
    }

    /// A plan to beat: the bounds rule most others out.
    void tryOneToolForAll() {
        for (const int first : order_[0]) {
            const LumpWay& way = lumps_[0][first];
            if (way.tools.size() != 1) continue;
            std::vector<int> ways;
            double weight = way.tools[0] == free_ ? 0 : change_;
            for (std::size_t i = 0; i < lumps_.size(); ++i) {
                const auto same = std::find_if(order_[i].begin(), order_[i].end(),
                                               [&](int k) { return lumps_[i][k].tools == way.tools; });
                if (same == order_[i].end()) break;
                ways.push_back(*same);
                weight += lumps_[i][*same].weight;
            }
            if (ways.size() == lumps_.size()) keep(ways, weight);
        }
    }

    void keep(const std::vector<int>& ways, double weight) {
        if (weight > best_.weight || (weight == best_.weight && ways >= best_.ways)) return;
        best_.ways = ways;
        best_.weight = weight;
    }

    void extend(std::size_t lump, double weight) {
        if (weight + rest_[lump] > best_.weight || tried_ > kMostCombinations) return;
        if (lump == lumps_.size()) {
            keep(chosen_, weight);
            return;
        }
        for (const int k : order_[lump]) {
            ++tried_;
            const LumpWay& way = lumps_[lump][k];
            double added = way.weight;
            for (const int tool : way.tools)
                if (calls_[tool]++ == 0 && tool != free_) added += change_;
            chosen_[lump] = k;
            extend(lump + 1, weight + added);
            for (const int tool : way.tools)
                --calls_[tool];
        }
    }

    const std::vector<std::vector<LumpWay>>& lumps_;
    double change_;
    int free_;
    std::vector<std::vector<int>> order_;  ///< allowed ways of each lump, the cheapest first
    std::vector<double> rest_;             ///< least weight of a lump and all after it
    std::map<int, int> calls_;
    std::vector<int> chosen_;
    ChosenWays best_;
    int tried_ = 0;
};

}  // namespace

ChosenWays cheapestWays(const std::vector<std::vector<LumpWay>>& lumps, double change_weight, int next) {
    if (lumps.empty()) return {{}, 0, false};
    ChosenWays best = WayChoice(lumps, change_weight, kNoTool).best();
    if (next == kNoTool) return best;
    ChosenWays joined = WayChoice(lumps, change_weight, next).best();
    if (joined.weight >= best.weight) return best;
    joined.joins_next = true;
    return joined;
}

}  // namespace stepmill
