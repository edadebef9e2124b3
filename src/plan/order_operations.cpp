#include "plan/order_operations.h"

#include <map>
#include <set>

#include "stepmill/core/error.h"

namespace stepmill {
namespace {

/// So many operations of a feature must be done.
struct Need {
    int feature = 0;
    int operations = 0;
};

/// The operations as a precedence problem: per feature a queue, whose operations may run when those of its
/// ancestors that each of them waits for are done.
struct Problem {
    std::vector<int> tool;                 ///< of each operation, numbered by first appearance
    std::vector<int> feature;              ///< of each operation
    std::vector<int> setup;                ///< of each feature
    std::vector<std::vector<int>> queue;   ///< operations of each feature in their own order
    std::vector<std::vector<Need>> needs;  ///< of each operation
    int tools = 0;
};

/// How many operations of each feature are done, and the tools called so far.
struct Partial {
    std::vector<int> done;
    std::vector<int> tools;
    int total = 0;
    int tools_left = 0;  ///< of every setup, summed: no setup has fewer visits
};

/// Of each feature its nearest ancestors with operations, ascending: when theirs are done, so are those of
/// all before them. A parent without operations does not hold its children back, but its own parents do.
/// \pre
/// parents come before their children
std::vector<std::vector<int>> nearestWithOperations(const std::vector<std::vector<int>>& parents,
                                                    const std::vector<std::vector<int>>& queue) {
    std::vector<std::vector<int>> nearest(parents.size());
    for (std::size_t i = 0; i < parents.size(); ++i) {
        std::set<int> found;
        for (const int parent : parents[i]) {
            STEPMILL_CHECK(parent < static_cast<int>(i), "parents come before their children");
            if (queue[parent].empty())
                found.insert(nearest[parent].begin(), nearest[parent].end());
            else
                found.insert(parent);
        }
        nearest[i].assign(found.begin(), found.end());
    }
    return nearest;
}

Problem makeProblem(const std::vector<Operation>& operations, const std::vector<Precedence>& features) {
    Problem problem;
    std::map<std::string, int> feature_number;
    for (const Precedence& feature : features)
        feature_number.emplace(feature.feature_id, static_cast<int>(feature_number.size()));
    problem.queue.resize(features.size());
    for (const Precedence& feature : features)
        problem.setup.push_back(feature.setup);
    std::vector<std::vector<int>> parents(features.size());
    for (std::size_t i = 0; i < features.size(); ++i) {
        for (const std::string& parent : features[i].parents) {
            const auto found = feature_number.find(parent);
            STEPMILL_CHECK(found != feature_number.end(),
                           "parent " + parent + " of " + features[i].feature_id);
            parents[i].push_back(found->second);
        }
    }
    std::map<std::string, int> tool_number;
    for (std::size_t i = 0; i < operations.size(); ++i) {
        const auto found = feature_number.find(operations[i].feature_id);
        STEPMILL_CHECK(found != feature_number.end(), "feature of operation " + operations[i].id);
        const auto tool =
            tool_number.emplace(operations[i].tool_id, static_cast<int>(tool_number.size())).first;
        problem.tool.push_back(tool->second);
        problem.feature.push_back(found->second);
        problem.queue[found->second].push_back(static_cast<int>(i));
    }
    problem.tools = static_cast<int>(tool_number.size());
    const std::vector<std::vector<int>> waits_for = nearestWithOperations(parents, problem.queue);
    for (std::size_t i = 0; i < operations.size(); ++i) {
        std::vector<Need>& needs = problem.needs.emplace_back();
        for (const Wait& wait : operations[i].waits)
            needs.push_back({feature_number.at(wait.feature_id), wait.operations});
        const auto named = [&](int ancestor) {
            return std::any_of(needs.begin(), needs.end(),
                               [&](const Need& need) { return need.feature == ancestor; });
        };
        for (const int ancestor : waits_for[problem.feature[i]])
            if (!named(ancestor))
                needs.push_back({ancestor, static_cast<int>(problem.queue[ancestor].size())});
    }
    return problem;
}

/// The feature's next operation if it may run now, else -1.
int nextOperation(const Problem& problem, const std::vector<int>& done, int feature) {
    if (done[feature] == static_cast<int>(problem.queue[feature].size())) return -1;
    const int next = problem.queue[feature][done[feature]];
    for (const Need& need : problem.needs[next])
        if (done[need.feature] < need.operations) return -1;
    return next;
}

void countToolsLeft(const Problem& problem, Partial& partial) {
    std::set<std::pair<int, int>> left;
    for (std::size_t f = 0; f < problem.queue.size(); ++f) {
        for (std::size_t i = partial.done[f]; i < problem.queue[f].size(); ++i)
            left.emplace(problem.setup[f], problem.tool[problem.queue[f][i]]);
    }
    partial.tools_left = static_cast<int>(left.size());
}

/// Runs everything tool `tool` can do now and thereby becomes able to do.
Partial afterVisit(const Problem& problem, Partial partial, int tool) {
    partial.tools.push_back(tool);
    for (bool again = true; again;) {
        again = false;
        for (std::size_t f = 0; f < problem.queue.size(); ++f) {
            const int next = nextOperation(problem, partial.done, static_cast<int>(f));
            if (next < 0 || problem.tool[next] != tool) continue;
            ++partial.done[f];
            ++partial.total;
            again = true;
        }
    }
    countToolsLeft(problem, partial);
    return partial;
}

/// Fewest tools left to call, then most operations done, then the earlier tools.
bool isMorePromising(const Partial& a, const Partial& b) {
    if (a.tools_left != b.tools_left) return a.tools_left < b.tools_left;
    if (a.total != b.total) return a.total > b.total;
    return a.tools < b.tools;
}

std::vector<Partial> oneVisitMore(const Problem& problem, const std::vector<Partial>& beam,
                                  std::size_t width) {
    std::vector<Partial> wider;
    std::set<std::vector<int>> seen;
    for (const Partial& partial : beam) {
        std::set<int> callable;
        for (std::size_t f = 0; f < problem.queue.size(); ++f) {
            const int next = nextOperation(problem, partial.done, static_cast<int>(f));
            if (next >= 0) callable.insert(problem.tool[next]);
        }
        for (const int tool : callable) {
            Partial longer = afterVisit(problem, partial, tool);
            if (seen.insert(longer.done).second) wider.push_back(std::move(longer));
        }
    }
    std::sort(wider.begin(), wider.end(), isMorePromising);
    if (wider.size() > width) wider.resize(width);
    return wider;
}

/// The tools in the order of their visits: a beam search, one tool change at a time.
std::vector<int> visits(const Problem& problem, std::size_t width) {
    std::vector<Partial> beam(1);
    beam[0].done.assign(problem.queue.size(), 0);
    const int operations = static_cast<int>(problem.tool.size());
    while (beam.front().total < operations) {
        beam = oneVisitMore(problem, beam, width);
        STEPMILL_CHECK(!beam.empty(), "features do not wait for each other in a circle");
    }
    return beam.front().tools;
}

Vec2 startOf(const Operation& operation) {
    return operation.path.start.head<2>();
}

Vec2 endOf(const Operation& operation) {
    const Toolpath& path = operation.path;
    return path.moves.empty() ? startOf(operation) : Vec2(path.moves.back().to.head<2>());
}

}  // namespace

std::vector<Precedence> inSetupOrder(const std::vector<PlannedSetup>& setups) {
    std::vector<Precedence> order;
    std::vector<std::string> ends_before;  // features of the setup before that no other waits for
    std::map<std::string, std::vector<std::string>> bands;  // by the whole feature
    for (const PlannedSetup& setup : setups) {
        std::set<std::string> ends;
        for (const PlannedFeature& planned : setup.features) {
            const Feature& feature = planned.feature;
            order.push_back({feature.id,
                             feature.parents.empty() ? ends_before : feature.parents,
                             static_cast<int>(&setup - setups.data()),
                             {}});
            if (feature.band) {
                order.back().bands_above = bands[feature.band->of];
                bands[feature.band->of].push_back(feature.id);
            }
            for (const std::string& parent : feature.parents)
                ends.erase(parent);
            ends.insert(feature.id);
        }
        if (!ends.empty()) ends_before.assign(ends.begin(), ends.end());
    }
    return order;
}

std::vector<int> toolVisits(const std::vector<Operation>& operations, const std::vector<Precedence>& features,
                            std::size_t beam_width) {
    return visits(makeProblem(operations, features), beam_width);
}

namespace {

/// Which feature lies below which, itself included: [below][above].
using Below = std::vector<std::vector<bool>>;

Below belowOf(const std::vector<Precedence>& features) {
    std::map<std::string, std::size_t> number;
    Below below(features.size(), std::vector<bool>(features.size(), false));
    for (std::size_t f = 0; f < features.size(); ++f) {
        number.emplace(features[f].feature_id, f);
        below[f][f] = true;
        for (const std::string& parent : features[f].parents)
            for (std::size_t above = 0; above < f; ++above)
                if (below[number.at(parent)][above]) below[f][above] = true;
    }
    return below;
}

/// What of one tool's operations comes next.
class NextOperation {
  public:
    NextOperation(const std::vector<Operation>& operations, const Problem& problem,
                  const std::vector<Precedence>& features, OrderRule rule)
        : operations_(operations), problem_(problem), rule_(rule) {
        if (rule == OrderRule::Branches) below_ = belowOf(features);
    }

    /// \param order  of those that are done
    bool isBetter(int candidate, int than, const std::vector<int>& order) const {
        if (rule_ == OrderRule::Levels && operations_[candidate].z_floor_mm != operations_[than].z_floor_mm)
            return operations_[candidate].z_floor_mm > operations_[than].z_floor_mm;
        if (rule_ == OrderRule::Branches) {
            const std::size_t one = lastAbove(candidate, order);
            const std::size_t other = lastAbove(than, order);
            if (one != other) return one > other;
        }
        if (order.empty()) return false;
        const Vec2 position = endOf(operations_[order.back()]);
        return (startOf(operations_[candidate]) - position).norm() <
               (startOf(operations_[than]) - position).norm();
    }

  private:
    /// How much was done when something above the operation was done last; 0 for nothing.
    std::size_t lastAbove(int operation, const std::vector<int>& order) const {
        const std::vector<bool>& above = below_[problem_.feature[operation]];
        for (std::size_t done = order.size(); done > 0; --done)
            if (above[problem_.feature[order[done - 1]]]) return done;
        return 0;
    }

    const std::vector<Operation>& operations_;
    const Problem& problem_;
    OrderRule rule_;
    Below below_;
};

/// Rapids that join the operations of one setup.
double travelMm(const std::vector<Operation>& operations, const std::vector<int>& order) {
    double sum_mm = 0;
    for (std::size_t i = 1; i < order.size(); ++i) {
        const Toolpath& before = operations[order[i - 1]].path;
        const Vec3 from = before.moves.empty() ? before.start : before.moves.back().to;
        const Vec3 way = operations[order[i]].path.start - from;
        sum_mm += way.head<2>().norm() + std::abs(way.z());
    }
    return sum_mm;
}

/// The operations in the order of these tools, each tool's by the rule.
std::vector<int> inOrderOf(const std::vector<int>& tools, const Problem& problem,
                           const NextOperation& next_operation) {
    std::vector<int> done(problem.queue.size(), 0);
    std::vector<int> order;
    for (const int tool : tools) {
        for (;;) {
            int best = -1;
            for (std::size_t f = 0; f < problem.queue.size(); ++f) {
                const int next = nextOperation(problem, done, static_cast<int>(f));
                if (next < 0 || problem.tool[next] != tool) continue;
                if (best < 0 || next_operation.isBetter(next, best, order)) best = next;
            }
            if (best < 0) break;
            order.push_back(best);
            ++done[problem.feature[best]];
        }
    }
    return order;
}

/// The order of an earlier plan for what is still there, with what is new put in.
class OrderAsBefore {
  public:
    /// \param otherwise  the order of a plan made anew
    OrderAsBefore(const Problem& problem, const EarlierPlaces& places, const std::vector<int>& otherwise)
        : problem_(problem), places_(places), position_(otherwise.size()) {
        for (std::size_t i = 0; i < otherwise.size(); ++i)
            position_[otherwise[i]] = static_cast<int>(i);
    }

    std::vector<int> order() {
        done_.assign(problem_.queue.size(), 0);
        std::vector<int> order;
        while (order.size() < problem_.tool.size()) {
            const int last_tool = order.empty() ? -1 : problem_.tool[order.back()];
            order.push_back(next(last_tool));
            ++done_[problem_.feature[order.back()]];
        }
        return order;
    }

  private:
    int setupOf(int operation) const { return problem_.setup[problem_.feature[operation]]; }

    bool isEarlier(int one, int than) const {
        if (setupOf(one) != setupOf(than)) return setupOf(one) < setupOf(than);
        const auto place = [&](int operation) {
            return std::pair(places_[operation].value_or(places_.size()), position_[operation]);
        };
        return place(one) < place(than);
    }

    /// The first that the earlier plan did and that is not done yet, may it run or not; -1 for none.
    int nextOfBefore(int setup) const {
        int first = -1;
        for (std::size_t f = 0; f < problem_.queue.size(); ++f)
            for (std::size_t i = done_[f]; i < problem_.queue[f].size(); ++i) {
                const int operation = problem_.queue[f][i];
                if (problem_.setup[f] == setup && places_[operation] &&
                    (first < 0 || isEarlier(operation, first)))
                    first = operation;
            }
        return first;
    }

    int next(int last_tool) const {
        std::vector<int> ready;
        for (std::size_t f = 0; f < problem_.queue.size(); ++f)
            if (const int one = nextOperation(problem_, done_, static_cast<int>(f)); one >= 0)
                ready.push_back(one);
        STEPMILL_CHECK(!ready.empty(), "features do not wait for each other in a circle");
        std::sort(ready.begin(), ready.end(), [this](int a, int b) { return isEarlier(a, b); });
        const int before = nextOfBefore(setupOf(ready.front()));
        const bool may_run = before >= 0 && ready.front() == before;
        if (may_run && problem_.tool[before] == last_tool) return before;
        const auto is_new = [&](int one) { return !places_[one] && setupOf(one) == setupOf(ready.front()); };
        for (const int one : ready)
            if (is_new(one) && problem_.tool[one] == last_tool) return one;
        if (may_run) return before;
        const auto fresh = std::find_if(ready.begin(), ready.end(), is_new);
        return fresh != ready.end() ? *fresh : ready.front();
    }

    const Problem& problem_;
    const EarlierPlaces& places_;
    std::vector<int> position_;
    std::vector<int> done_;  ///< of each feature
};

/// Puts the earlier plan's order in place of one that was found, in each setup that has operations of it.
void keepOrder(const std::vector<Operation>& operations, const Problem& problem, const EarlierPlaces& places,
               std::vector<std::vector<WeighedOrder>>& weighed, std::vector<std::vector<int>>& taken) {
    std::vector<int> otherwise;
    for (const std::vector<int>& of_setup : taken)
        otherwise.insert(otherwise.end(), of_setup.begin(), of_setup.end());
    std::vector<std::vector<int>> kept(taken.size());
    for (const int operation : OrderAsBefore(problem, places, otherwise).order())
        kept[problem.setup[problem.feature[operation]]].push_back(operation);
    for (std::size_t setup = 0; setup < taken.size(); ++setup) {
        const bool any = std::any_of(taken[setup].begin(), taken[setup].end(),
                                     [&](int operation) { return places[operation].has_value(); });
        if (!any || kept[setup] == taken[setup]) continue;
        weighed[setup].insert(weighed[setup].begin(),
                              {OrderRule::Earlier, travelMm(operations, kept[setup])});
        taken[setup] = kept[setup];
    }
}

}  // namespace

std::vector<int> orderOperations(const std::vector<Operation>& operations,
                                 const std::vector<Precedence>& features, OrderRule rule) {
    const Problem problem = makeProblem(operations, features);
    return inOrderOf(visits(problem, kBeamWidth), problem,
                     NextOperation(operations, problem, features, rule));
}

ShortestOrder shortestOrder(const std::vector<Operation>& operations, const std::vector<Precedence>& features,
                            const EarlierPlaces& places) {
    std::map<std::string, int> setup_of;
    int setups = 0;
    for (const Precedence& feature : features) {
        setup_of[feature.feature_id] = feature.setup;
        setups = std::max(setups, feature.setup + 1);
    }
    const Problem problem = makeProblem(operations, features);
    const std::vector<int> tools = visits(problem, kBeamWidth);
    ShortestOrder shortest;
    shortest.weighed.resize(setups);
    std::vector<std::vector<int>> taken(setups);
    for (const OrderRule rule : {OrderRule::Nearest, OrderRule::Branches, OrderRule::Levels}) {
        std::vector<std::vector<int>> by_setup(setups);
        const NextOperation by_rule(operations, problem, features, rule);
        for (const int operation : inOrderOf(tools, problem, by_rule))
            by_setup[setup_of.at(operations[operation].feature_id)].push_back(operation);
        for (int setup = 0; setup < setups; ++setup) {
            std::vector<WeighedOrder>& weighed = shortest.weighed[setup];
            const WeighedOrder found{rule, travelMm(operations, by_setup[setup])};
            const bool better = weighed.empty() || found.travel_mm < weighed.front().travel_mm;
            weighed.insert(better ? weighed.begin() : weighed.end(), found);
            if (better) taken[setup] = std::move(by_setup[setup]);
        }
    }
    if (!places.empty()) keepOrder(operations, problem, places, shortest.weighed, taken);
    for (const std::vector<int>& of_setup : taken)
        shortest.order.insert(shortest.order.end(), of_setup.begin(), of_setup.end());
    return shortest;
}

}  // namespace stepmill
