#include "stepmill/batch/magazine.h"

#include <algorithm>
#include <limits>
#include <map>

namespace stepmill {
namespace {

using ToolSet = std::vector<bool>;

/// What a set of tools comes to: fewest unserved tasks first, then least cost.
struct Worth {
    int unserved = std::numeric_limits<int>::max();
    double cost = std::numeric_limits<double>::infinity();

    bool operator<(const Worth& other) const {
        return unserved != other.unserved ? unserved < other.unserved : cost < other.cost;
    }
};

/// The tasks with tools by number.
class NumberedTasks {
  public:
    explicit NumberedTasks(const std::vector<ToolTask>& tasks) {
        std::map<std::string, int> numbers;
        for (const ToolTask& task : tasks)
            for (const ToolWay& way : task.ways)
                for (const std::string& tool : way.tools)
                    numbers.emplace(tool, 0);
        for (auto& [tool, number] : numbers) {
            number = static_cast<int>(names_.size());
            names_.push_back(tool);
        }
        for (const ToolTask& task : tasks)
            tasks_.push_back(numbered(task, numbers));
    }

    int tools() const { return static_cast<int>(names_.size()); }
    const std::string& name(int tool) const { return names_[static_cast<std::size_t>(tool)]; }

    /// Without loading.
    Worth worthOf(const ToolSet& set) const {
        Worth worth{0, 0};
        for (const Task& task : tasks_) {
            const Way* way = firstWithin(task, set);
            if (way == nullptr)
                ++worth.unserved;
            else
                worth.cost += task.pieces * way->cost;
        }
        return worth;
    }

    /// What the first set leaves unserved and costs more than the second, which holds it.
    struct Difference {
        int unserved = 0;
        double cost = 0;  ///< of tasks that both serve
    };
    Difference difference(const ToolSet& less, const ToolSet& more) const {
        Difference difference;
        for (const Task& task : tasks_) {
            const Way* with_less = firstWithin(task, less);
            const Way* with_more = firstWithin(task, more);
            if (with_more == nullptr) continue;
            if (with_less == nullptr)
                ++difference.unserved;
            else
                difference.cost += task.pieces * (with_less->cost - with_more->cost);
        }
        return difference;
    }

  private:
    struct Way {
        double cost = 0;
        std::vector<int> tools;
    };
    struct Task {
        std::vector<Way> ways;  ///< the cheapest first
        double pieces = 1;
    };

    static Task numbered(const ToolTask& task, const std::map<std::string, int>& numbers) {
        Task result;
        result.pieces = task.pieces;
        for (const ToolWay& way : task.ways) {
            result.ways.push_back({way.cost, {}});
            for (const std::string& tool : way.tools)
                result.ways.back().tools.push_back(numbers.at(tool));
        }
        std::stable_sort(result.ways.begin(), result.ways.end(),
                         [](const Way& a, const Way& b) { return a.cost < b.cost; });
        return result;
    }

    static const Way* firstWithin(const Task& task, const ToolSet& set) {
        const auto way = std::find_if(task.ways.begin(), task.ways.end(), [&](const Way& candidate) {
            return std::all_of(candidate.tools.begin(), candidate.tools.end(),
                               [&](int tool) { return set[static_cast<std::size_t>(tool)]; });
        });
        return way == task.ways.end() ? nullptr : &*way;
    }

    std::vector<std::string> names_;
    std::vector<Task> tasks_;
};

class MagazineSearch {
  public:
    MagazineSearch(const NumberedTasks& tasks, const MagazineTerms& terms) : tasks_(tasks), terms_(terms) {
        places_ = terms.places > 0 ? terms.places : tasks.tools();
    }

    Magazine run() {
        dropOneByOne();
        const ToolSet all(static_cast<std::size_t>(tasks_.tools()), true);
        branch(all, 0, 0);
        return result();
    }

  private:
    Worth loaded(const ToolSet& set) {
        ++looked_at_;
        Worth worth = tasks_.worthOf(set);
        worth.cost += terms_.load_cost * static_cast<double>(std::count(set.begin(), set.end(), true));
        return worth;
    }

    void offer(const ToolSet& set, const Worth& worth) {
        if (!(worth < best_worth_)) return;
        best_worth_ = worth;
        best_ = set;
    }

    /// A good set to begin with, and the order in which tools are decided: the last to be dropped matters
    /// most.
    void dropOneByOne() {
        ToolSet set(static_cast<std::size_t>(tasks_.tools()), true);
        order_.clear();
        for (int left = tasks_.tools(); left >= 0; --left) {
            if (left <= places_) offer(set, loaded(set));
            if (left > 0) order_.push_back(dropLeast(set));
        }
        std::reverse(order_.begin(), order_.end());
    }

    int dropLeast(ToolSet& set) {
        int least = -1;
        Worth least_worth;
        for (int tool = 0; tool < tasks_.tools(); ++tool) {
            if (!set[static_cast<std::size_t>(tool)]) continue;
            set[static_cast<std::size_t>(tool)] = false;
            const Worth worth = tasks_.worthOf(set);
            set[static_cast<std::size_t>(tool)] = true;
            if (least < 0 || worth < least_worth) {
                least = tool;
                least_worth = worth;
            }
        }
        set[static_cast<std::size_t>(least)] = false;
        return least;
    }

    /// \param possible  tools that are in, and those that are undecided
    /// \param decided  tools of the order
    /// \param in        of these
    void branch(const ToolSet& possible, std::size_t decided, int in) {
        Worth bound = tasks_.worthOf(possible);
        bound.cost += terms_.load_cost * in;
        ++looked_at_;
        if (!(bound < best_worth_)) return;
        if (looked_at_ > terms_.most_sets) {
            open_ = std::min(open_, bound);
            return;
        }
        if (decided == order_.size() || in == places_) return closeBranch(possible, decided);
        branch(possible, decided + 1, in + 1);
        ToolSet without = possible;
        without[static_cast<std::size_t>(order_[decided])] = false;
        branch(without, decided + 1, in);
    }

    /// What is undecided stays out.
    void closeBranch(ToolSet set, std::size_t decided) {
        for (; decided < order_.size(); ++decided)
            set[static_cast<std::size_t>(order_[decided])] = false;
        offer(set, loaded(set));
    }

    ToolValue valueOf(int tool) const {
        ToolSet with = best_;
        ToolSet without = best_;
        with[static_cast<std::size_t>(tool)] = true;
        without[static_cast<std::size_t>(tool)] = false;
        const NumberedTasks::Difference difference = tasks_.difference(without, with);
        return {tasks_.name(tool), best_[static_cast<std::size_t>(tool)], difference.unserved,
                difference.cost};
    }

    Magazine result() const {
        Magazine magazine;
        for (int tool = 0; tool < tasks_.tools(); ++tool)
            if (best_[static_cast<std::size_t>(tool)]) magazine.tools.push_back(tasks_.name(tool));
        magazine.unserved = best_worth_.unserved;
        magazine.cost = best_worth_.cost;
        magazine.proven = !(open_ < best_worth_);
        // A branch left open that might serve more tasks says nothing about this one's cost.
        magazine.bound = magazine.proven                         ? best_worth_.cost
                         : open_.unserved < best_worth_.unserved ? 0
                                                                 : open_.cost;
        const ToolSet all(static_cast<std::size_t>(tasks_.tools()), true);
        magazine.all_tools_cost = tasks_.worthOf(all).cost + terms_.load_cost * tasks_.tools();
        for (int tool = 0; tool < tasks_.tools(); ++tool)
            magazine.values.push_back(valueOf(tool));
        return magazine;
    }

    const NumberedTasks& tasks_;
    const MagazineTerms& terms_;
    int places_ = 0;
    std::vector<int> order_;
    ToolSet best_;
    Worth best_worth_;
    Worth open_;  ///< the best that a branch which was not searched may come to
    long looked_at_ = 0;
};

}  // namespace

Magazine bestMagazine(const std::vector<ToolTask>& tasks, const MagazineTerms& terms) {
    const NumberedTasks numbered(tasks);
    return MagazineSearch(numbered, terms).run();
}

}  // namespace stepmill
