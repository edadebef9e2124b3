#include "stepmill/batch/part_order.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace stepmill {
namespace {

using Tools = std::set<std::string>;
using Order = std::vector<std::size_t>;

/// Groups of which all orders are tried: 8! = 40320.
constexpr std::size_t kMostTried = 8;
/// Groups of which pairs change places: each round weighs all pairs.
constexpr std::size_t kMostSwapped = 60;

/// Parts that are made one after another with the tools of the one that needs most.
struct Group {
    Tools tools;
    Order parts;
};

bool holds(const Tools& all, const Tools& some) {
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

/// \param fitting  parts that fit into the magazine
std::vector<Group> groupsOf(const std::vector<Tools>& needs, const Order& fitting) {
    Order by_size = fitting;
    std::stable_sort(by_size.begin(), by_size.end(),
                     [&](std::size_t a, std::size_t b) { return needs[a].size() > needs[b].size(); });
    std::vector<Group> groups;
    for (const std::size_t part : by_size) {
        const auto home = std::find_if(groups.begin(), groups.end(),
                                       [&](const Group& group) { return holds(group.tools, needs[part]); });
        if (home == groups.end())
            groups.push_back({needs[part], {part}});
        else
            home->parts.push_back(part);
    }
    for (Group& group : groups)
        std::sort(group.parts.begin(), group.parts.end());
    return groups;
}

/// The magazine while groups are made in an order.
class MagazineRun {
  public:
    MagazineRun(const std::vector<Group>& groups, const Order& order, std::size_t places)
        : groups_(groups), order_(order), places_(places) {
        for (std::size_t turn = 0; turn < order.size(); ++turn)
            for (const std::string& tool : groups[order[turn]].tools)
                turns_[tool].push_back(turn);
    }

    int loads() {
        int loads = 0;
        for (std::size_t turn = 0; turn < order_.size(); ++turn)
            for (const std::string& tool : groups_[order_[turn]].tools)
                if (inside_.insert(tool).second) {
                    ++loads;
                    makeRoom(turn);
                }
        return loads;
    }

  private:
    void makeRoom(std::size_t turn) {
        if (inside_.size() <= places_) return;
        const Tools& needed = groups_[order_[turn]].tools;
        auto last = inside_.end();
        std::size_t last_turn = 0;
        for (auto tool = inside_.begin(); tool != inside_.end(); ++tool) {
            if (needed.contains(*tool)) continue;
            const std::size_t next = nextTurn(*tool, turn);
            if (last == inside_.end() || next > last_turn) {
                last = tool;
                last_turn = next;
            }
        }
        inside_.erase(last);
    }

    std::size_t nextTurn(const std::string& tool, std::size_t turn) const {
        const std::vector<std::size_t>& turns = turns_.at(tool);
        const auto next = std::upper_bound(turns.begin(), turns.end(), turn);
        return next == turns.end() ? std::numeric_limits<std::size_t>::max() : *next;
    }

    const std::vector<Group>& groups_;
    const Order& order_;
    std::size_t places_;
    std::map<std::string, std::vector<std::size_t>> turns_;
    Tools inside_;
};

class OrderSearch {
  public:
    OrderSearch(const std::vector<Group>& groups, std::size_t places) : groups_(groups), places_(places) {
        best_.resize(groups.size());
        std::iota(best_.begin(), best_.end(), std::size_t{0});
    }

    /// \return the order of the groups
    const Order& run() {
        loads_ = loadsOf(best_);
        if (groups_.size() <= kMostTried) {
            tryAll();
        } else {
            takeIfBetter(nearestNext());
            if (groups_.size() <= kMostSwapped)
                while (swapOnePair()) {
                }
        }
        return best_;
    }

    int loads() const { return loads_; }
    bool triedAll() const { return groups_.size() <= kMostTried; }

  private:
    int loadsOf(const Order& order) const { return MagazineRun(groups_, order, places_).loads(); }

    bool takeIfBetter(const Order& order) {
        const int loads = loadsOf(order);
        if (loads >= loads_) return false;
        loads_ = loads;
        best_ = order;
        return true;
    }

    void tryAll() {
        Order order = best_;
        while (std::next_permutation(order.begin(), order.end()))
            takeIfBetter(order);
    }

    std::size_t newTools(std::size_t from, std::size_t to) const {
        const Tools& had = groups_[from].tools;
        return static_cast<std::size_t>(
            std::count_if(groups_[to].tools.begin(), groups_[to].tools.end(),
                          [&](const std::string& tool) { return !had.contains(tool); }));
    }

    Order nearestNext() const {
        Order left(groups_.size() - 1);
        std::iota(left.begin(), left.end(), std::size_t{1});
        Order order{0};
        while (!left.empty()) {
            const auto next = std::min_element(left.begin(), left.end(), [&](std::size_t a, std::size_t b) {
                return newTools(order.back(), a) < newTools(order.back(), b);
            });
            order.push_back(*next);
            left.erase(next);
        }
        return order;
    }

    /// Does some pair help?
    bool swapOnePair() {
        Order order = best_;
        for (std::size_t i = 0; i < order.size(); ++i)
            for (std::size_t k = i + 1; k < order.size(); ++k) {
                std::swap(order[i], order[k]);
                if (takeIfBetter(order)) return true;
                std::swap(order[i], order[k]);
            }
        return false;
    }

    const std::vector<Group>& groups_;
    std::size_t places_;
    Order best_;
    int loads_ = 0;
};

}  // namespace

PartOrder orderParts(const std::vector<std::vector<std::string>>& needs, int places) {
    const auto room = static_cast<std::size_t>(std::max(places, 1));
    std::vector<Tools> tools;
    PartOrder result;
    Order fitting;
    for (const std::vector<std::string>& ids : needs) {
        tools.emplace_back(ids.begin(), ids.end());
        (tools.back().size() <= room ? fitting : result.too_many).push_back(tools.size() - 1);
    }
    const std::vector<Group> groups = groupsOf(tools, fitting);
    if (groups.empty()) return result;
    OrderSearch search(groups, room);
    Tools all;
    for (const std::size_t group : search.run()) {
        result.parts.insert(result.parts.end(), groups[group].parts.begin(), groups[group].parts.end());
        all.insert(groups[group].tools.begin(), groups[group].tools.end());
    }
    result.loads = search.loads();
    result.bound = search.triedAll() ? result.loads : static_cast<int>(all.size());
    return result;
}

}  // namespace stepmill
