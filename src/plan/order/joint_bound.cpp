// The least that features and the tools they share can take together.

#include "plan/order/joint_bound.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "stepmill/sequence/tool_dag.h"

namespace stepmill {
namespace {

/// Rounds of dividing the changes anew; after about a third of them little is gained.
constexpr int kMostBoundRounds = 100;
/// Bounds nearer to the best choice known are good enough.
constexpr double kCloseShare = 1e-4;
/// The part of the step to the best choice known that is taken, halved whenever rounds do not raise the
/// bound.
constexpr double kFirstStep = 1.5;
constexpr int kRoundsToHalve = 8;

/// Of each tool, what a feature pays for its change [s].
using Prices = std::vector<double>;

/// The largest shares that add up to no more than the whole and lie nearest to those given.
std::vector<double> withinWhole(std::vector<double> shares, double whole) {
    for (double& share : shares)
        share = std::max(0.0, share);
    std::vector<double> sorted = shares;
    std::sort(sorted.begin(), sorted.end(), std::greater<>());
    double sum = 0;
    double over = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        sum += sorted[i];
        const double level = (sum - whole) / static_cast<double>(i + 1);
        if (sorted[i] > level) over = level;
    }
    if (over <= 0) return shares;
    for (double& share : shares)
        share = std::max(0.0, share - over);
    return shares;
}

class SharedChanges {
  public:
    SharedChanges(const std::vector<LeastTimes>& features, double tool_change_s) : change_s_(tool_change_s) {
        for (const LeastTimes& feature : features) {
            if (feature.tools.empty()) continue;
            for (std::size_t k = 0; k < feature.tools.size(); ++k)
                places_[feature.tools[k]].push_back({features_.size(), k});
            features_.push_back(&feature);
            prices_.emplace_back(feature.tools.size(), 0.0);
        }
        giveToThoseApart();
    }

    double highest() {
        double bound_s = 0;
        double choice_s = kNoEdge;
        double step = kFirstStep;
        int without_gain = 0;
        for (int round = 0; round < kMostBoundRounds; ++round) {
            const Round found = cheapest();
            choice_s = std::min(choice_s, found.choice_s);
            without_gain = found.bound_s > bound_s ? 0 : without_gain + 1;
            bound_s = std::max(bound_s, found.bound_s);
            if (choice_s - bound_s <= kCloseShare * choice_s) break;
            if (without_gain == kRoundsToHalve) {
                step /= 2;
                without_gain = 0;
            }
            move(found, step * (choice_s - found.bound_s));
        }
        return bound_s;
    }

  private:
    struct Place {
        std::size_t feature;
        std::size_t tool;
    };
    /// The features' cheapest paths at some prices.
    struct Round {
        std::vector<std::vector<int>> paths;
        double bound_s = 0;
        double choice_s = 0;  ///< of these paths, with a change for every tool in them
    };

    /// Features no two of which can end with the same tool pay for all of their last tools.
    void giveToThoseApart() {
        std::set<std::string> taken;
        for (std::size_t f = 0; f < features_.size(); ++f) {
            const LeastTimes& feature = *features_[f];
            std::set<std::string> last;
            for (std::size_t k = 0; k < feature.tools.size(); ++k)
                if (feature.ends[k]) last.insert(feature.tools[k]);
            const bool apart = std::none_of(last.begin(), last.end(),
                                            [&](const std::string& id) { return taken.count(id) > 0; });
            if (!apart) continue;
            taken.insert(last.begin(), last.end());
            for (std::size_t k = 0; k < feature.tools.size(); ++k)
                if (feature.ends[k]) prices_[f][k] = change_s_;
        }
    }

    Round cheapest() const {
        Round round;
        std::set<std::string> used;
        for (std::size_t f = 0; f < features_.size(); ++f) {
            const LeastTimes& feature = *features_[f];
            const Prices& prices = prices_[f];
            const CheapestPath path = cheapestPath(
                static_cast<int>(feature.tools.size()),
                [&](int m, int k) { return feature.cuttingS(m, k) + prices[k]; }, feature.ends);
            round.paths.push_back(path.tools);
            if (path.tools.empty()) continue;
            round.bound_s += path.cost;
            int before = kSource;
            for (const int k : path.tools) {
                round.choice_s += feature.cuttingS(before, k);
                used.insert(feature.tools[k]);
                before = k;
            }
        }
        round.choice_s += change_s_ * static_cast<double>(used.size());
        return round;
    }

    /// Tools on the cheapest paths become dearer there, so that the bound would rise by that much if all
    /// went on as here.
    void move(const Round& round, double rise_s) {
        std::size_t used = 0;
        for (const std::vector<int>& path : round.paths)
            used += path.size();
        if (used == 0) return;
        const double dearer_s = rise_s / static_cast<double>(used);
        for (std::size_t f = 0; f < round.paths.size(); ++f)
            for (const int k : round.paths[f])
                prices_[f][k] += dearer_s;
        for (const auto& [tool, places] : places_) {
            std::vector<double> shares;
            for (const Place& place : places)
                shares.push_back(prices_[place.feature][place.tool]);
            shares = withinWhole(std::move(shares), change_s_);
            for (std::size_t i = 0; i < places.size(); ++i)
                prices_[places[i].feature][places[i].tool] = shares[i];
        }
    }

    double change_s_;
    std::vector<const LeastTimes*> features_;
    std::vector<Prices> prices_;  ///< of each feature, by tool
    std::map<std::string, std::vector<Place>> places_;
};

}  // namespace

double leastTogetherS(const std::vector<LeastTimes>& features, double tool_change_s) {
    return SharedChanges(features, tool_change_s).highest();
}

}  // namespace stepmill
