// How few setups reach all: branch and bound over sets of axes, exact as far as cover.h says.

#include "setup/cover.h"

namespace stepmill::setup {

namespace {

/// Sets closer in worth than this are equal; the one found first stays.
constexpr double kSameWorth = 1e-9;

/// Sculpted parts with dozens of axes that each see a little end the search here, with the best set so far.
/// Parts of planes and holes need some hundreds of visits.
constexpr int kMostVisits = 20000;

double seenWorth(const SampleGroup& group) {
    return group.volume_share / kSetupPaysShare + group.faces / kSetupPaysFace;
}

double worthOf(const SampleGroup& group, Reach reach, bool steps_finished) {
    if (reach == Reach::None) return 0;
    const double seen = seenWorth(group);
    const bool finished = reach == Reach::Finished || (steps_finished && reach == Reach::Steps);
    return finished ? seen + group.ruled_share / kFinishPaysShare : seen;
}

/// Depth-first over "with this axis" and "without it". What a set reaches is kept as worth per group.
class Search {
  public:
    Search(const std::vector<SampleGroup>& groups, const std::vector<double>& bonus, bool steps_finished)
        : bonus_(bonus), exact_(steps_finished) {
        worth_.assign(bonus.size(), std::vector<double>(groups.size(), 0.0));
        for (std::size_t axis = 0; axis < bonus.size(); ++axis)
            for (std::size_t g = 0; g < groups.size(); ++g)
                worth_[axis][g] = worthOf(groups[g], groups[g].reach[axis], steps_finished);
    }

    std::vector<int> run() {
        std::vector<int> all;
        for (int axis = 0; axis < static_cast<int>(worth_.size()); ++axis)
            if (!isDominated(axis)) all.push_back(axis);
        std::vector<double> held(worth_.empty() ? 0 : worth_.front().size(), 0.0);
        visit(held, 0, all);
        // What the first axes of the search see, later ones may see as well.
        for (bool better = true; better;)
            better = spareOne(all);
        std::sort(best_.begin(), best_.end());
        return best_;
    }

  private:
    double worthOfSet(const std::vector<int>& axes) const {
        std::vector<double> held(worth_.front().size(), 0.0);
        double worth = 0;
        for (const int axis : axes) {
            worth += gain(held, axis);
            hold(axis, held);
        }
        return worth;
    }

    /// Is this set worth more? Then it is the best.
    bool takeIfBetter(std::vector<int> axes) {
        const double worth = worthOfSet(axes);
        if (worth <= best_worth_ + kSameWorth) return false;
        best_worth_ = worth;
        best_ = std::move(axes);
        return true;
    }

    /// Leaves out a dear axis whose work the others do, or puts one along the box in its place. One along the
    /// box stays: by sight alone it may seem needless and yet reach best.
    bool spareOne(const std::vector<int>& axes) {
        for (const int dear : best_) {
            if (bonus_[dear] >= 0) continue;
            std::vector<int> others = best_;
            std::erase(others, dear);
            if (takeIfBetter(others)) return true;
            for (const int axis : axes) {
                if (bonus_[axis] < 0 || std::find(others.begin(), others.end(), axis) != others.end())
                    continue;
                std::vector<int> straight = others;
                straight.push_back(axis);
                if (takeIfBetter(std::move(straight))) return true;
            }
        }
        return false;
    }

    void hold(int axis, std::vector<double>& held) const {
        for (std::size_t g = 0; g < held.size(); ++g)
            held[g] = std::max(held[g], worth_[axis][g]);
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

    double mostWorth(const std::vector<double>& held, const std::vector<std::pair<double, int>>& axes) const {
        double sum = 0;
        for (const auto& [by, axis] : axes)
            sum += exact_ ? std::max(0.0, bonus_[axis]) : bonus_[axis];
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
        // However many axes follow, together they add no more than the best of them does in each group, less
        // one.
        double bound = worth + std::min(sum, mostWorth(held, paying) - 1);
        std::stable_sort(paying.begin(), paying.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
        for (std::size_t i = 0; i < paying.size(); ++i) {
            if (bound <= best_worth_ + kSameWorth) return;
            const auto [by, axis] = paying[i];
            std::vector<double> more = held;
            hold(axis, more);
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
    bool exact_;  ///< else dear axes that could follow make the search give up sooner
    std::vector<std::vector<double>> worth_;  ///< by axis, by group
    std::vector<int> chosen_;
    std::vector<int> best_;
    double best_worth_ = 0;
    int visits_ = 0;
};

}  // namespace

std::vector<int> bestAxes(const std::vector<SampleGroup>& groups, const std::vector<double>& bonus,
                          bool steps_finished) {
    return Search(groups, bonus, steps_finished).run();
}

double worthSeen(const std::vector<int>& axes, const std::vector<SampleGroup>& groups) {
    double worth = 0;
    for (const SampleGroup& group : groups)
        if (std::any_of(axes.begin(), axes.end(), [&](int axis) { return group.reach[axis] != Reach::None; }))
            worth += seenWorth(group);
    return worth;
}

}  // namespace stepmill::setup
