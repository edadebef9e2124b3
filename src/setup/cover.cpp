// How few setups reach all: an exact search over sets of axes.

#include "setup/cover.h"

#include <limits>

namespace stepmill::setup {

namespace {

/// Sets closer in worth than this are equal; the one found first stays.
constexpr double kSameWorth = 1e-9;

/// Sculpted parts with dozens of axes that each see a little end the search here, with the best set so far.
/// Parts of planes and holes need some hundreds of visits.
constexpr int kMostVisits = 20000;

double worthOf(const SampleGroup& group, Reach reach) {
    if (reach == Reach::None) return 0;
    const double seen = group.volume_share / kSetupPaysShare + group.faces / kSetupPaysFace;
    return reach == Reach::Poor ? seen : seen + group.ruled_share / kFinishPaysShare;
}

/// Depth-first over "with this axis" and "without it". What a set reaches is kept as worth per group.
class Search {
  public:
    Search(const std::vector<SampleGroup>& groups, const std::vector<double>& bonus) : bonus_(bonus) {
        worth_.assign(bonus.size(), std::vector<double>(groups.size(), 0.0));
        for (std::size_t axis = 0; axis < bonus.size(); ++axis)
            for (std::size_t g = 0; g < groups.size(); ++g)
                worth_[axis][g] = worthOf(groups[g], groups[g].reach[axis]);
    }

    std::vector<int> run() {
        std::vector<int> all;
        for (int axis = 0; axis < static_cast<int>(worth_.size()); ++axis)
            if (!isDominated(axis)) all.push_back(axis);
        std::vector<double> held(worth_.empty() ? 0 : worth_.front().size(), 0.0);
        visit(held, 0, all);
        if (visits_ > kMostVisits) improve(all);
        std::sort(best_.begin(), best_.end());
        return best_;
    }

  private:
    double worthOfSet(const std::vector<int>& axes) const {
        double worth = 0;
        for (const int axis : axes)
            worth += bonus_[axis] - 1;
        for (std::size_t g = 0; g < worth_.front().size(); ++g) {
            double most = 0;
            for (const int axis : axes)
                most = std::max(most, worth_[axis][g]);
            worth += most;
        }
        return worth;
    }

    /// Sets that differ from the best so far by one axis left out, added or taken for another.
    std::vector<std::vector<int>> nextToBest(const std::vector<int>& all) const {
        std::vector<std::vector<int>> sets;
        for (std::size_t out = 0; out <= best_.size(); ++out) {
            std::vector<int> kept = best_;
            if (out < best_.size()) kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(out));
            sets.push_back(kept);
            kept.push_back(-1);
            for (const int axis : all) {
                kept.back() = axis;
                sets.push_back(kept);
            }
        }
        return sets;
    }

    /// A search that comes to its end too early may hold an axis that does not pay: single axes are exchanged
    /// as long as that helps.
    void improve(const std::vector<int>& all) {
        for (bool better = true; better;) {
            better = false;
            for (std::vector<int>& set : nextToBest(all)) {
                const double worth = worthOfSet(set);
                if (worth <= best_worth_ + kSameWorth) continue;
                best_worth_ = worth;
                best_ = std::move(set);
                better = true;
            }
        }
    }

    /// Does another axis reach all that this one does, as well? Of equal ones the first stays.
    bool isDominated(int axis) const {
        for (int other = 0; other < static_cast<int>(worth_.size()); ++other) {
            if (other == axis || bonus_[other] < bonus_[axis]) continue;
            const bool twin = worth_[other] == worth_[axis] && bonus_[other] == bonus_[axis];
            if (twin && other > axis) continue;
            if (std::equal(worth_[other].begin(), worth_[other].end(), worth_[axis].begin(),
                           std::greater_equal<>()))
                return true;
        }
        return false;
    }

    double gain(const std::vector<double>& held, int axis) const {
        double sum = bonus_[axis] - 1;
        for (std::size_t g = 0; g < held.size(); ++g)
            sum += std::max(0.0, worth_[axis][g] - held[g]);
        return sum;
    }

    /// No less than what any of the axes can add together: of each group what the best of them reaches, less
    /// the cost of one axis. Further ones, indexed ones above all, cost more.
    double mostWorth(const std::vector<double>& held, const std::vector<std::pair<double, int>>& axes) const {
        double sum = std::numeric_limits<double>::lowest();
        for (const auto& [by, axis] : axes)
            sum = std::max(sum, bonus_[axis] - 1);
        for (std::size_t g = 0; g < held.size(); ++g) {
            double most = 0;
            for (const auto& [by, axis] : axes)
                most = std::max(most, worth_[axis][g] - held[g]);
            sum += most;
        }
        return sum;
    }

    void visit(const std::vector<double>& held, double worth, const std::vector<int>& open) {
        if (++visits_ > kMostVisits) return;
        if (worth > best_worth_ + kSameWorth) {
            best_worth_ = worth;
            best_ = chosen_;
        }
        // Gains only fall as the set grows: their sum bounds what any choice among the open axes adds.
        std::vector<std::pair<double, int>> paying;
        double sum = 0;
        for (const int axis : open) {
            const double by = gain(held, axis);
            if (by <= 0) continue;
            paying.emplace_back(by, axis);
            sum += by;
        }
        double bound = worth + std::min(sum, mostWorth(held, paying));
        std::stable_sort(paying.begin(), paying.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
        for (std::size_t i = 0; i < paying.size(); ++i) {
            if (bound <= best_worth_ + kSameWorth) return;
            const auto [by, axis] = paying[i];
            std::vector<double> more = held;
            for (std::size_t g = 0; g < more.size(); ++g)
                more[g] = std::max(more[g], worth_[axis][g]);
            std::vector<int> rest;
            for (std::size_t j = i + 1; j < paying.size(); ++j)
                rest.push_back(paying[j].second);
            chosen_.push_back(axis);
            visit(more, worth + by, rest);
            chosen_.pop_back();
            sum -= by;
            bound = std::min(bound, worth + sum);
        }
    }

    const std::vector<double>& bonus_;
    std::vector<std::vector<double>> worth_;  ///< by axis, by group
    std::vector<int> chosen_;
    std::vector<int> best_;
    double best_worth_ = 0;
    int visits_ = 0;
};

}  // namespace

std::vector<int> bestAxes(const std::vector<SampleGroup>& groups, const std::vector<double>& bonus) {
    return Search(groups, bonus).run();
}

double aloneShare(const std::vector<SampleGroup>& groups, int axis, const std::vector<int>& others) {
    double share = 0;
    for (const SampleGroup& group : groups) {
        if (group.reach[axis] == Reach::None) continue;
        const bool alone = std::none_of(others.begin(), others.end(), [&](int other) {
            return other != axis && group.reach[other] != Reach::None;
        });
        if (alone) share += group.volume_share;
    }
    return share;
}

}  // namespace stepmill::setup
