#include "plan/order/order_operations.h"

#include <algorithm>
#include <map>
#include <set>

#include "plan/order/fewest_visits.h"
#include "plan/order/visit_problem.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

Vec2 startOf(const Operation& operation) {
    return operation.path.start.head<2>();
}

Vec2 endOf(const Operation& operation) {
    const Toolpath& path = operation.path;
    return path.moves.empty() ? startOf(operation) : Vec2(path.moves.back().to.head<2>());
}

void addNew(std::vector<std::string>& ids, const std::vector<std::string>& others) {
    for (const std::string& id : others)
        if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
}

}  // namespace

std::vector<Precedence> inSetupOrder(const std::vector<PlannedSetup>& setups) {
    std::vector<Precedence> order;
    for (std::size_t s = 0; s < setups.size(); ++s) {
        std::map<std::string, std::vector<std::string>> above;
        for (const PlannedFeature& planned : setups[s].features) {
            const Feature& feature = planned.feature;
            std::vector<std::string>& own = above[feature.id];
            for (const std::string& parent : feature.parents) {
                addNew(own, above[parent]);
                addNew(own, {parent});
            }
            const bool is_profile = feature.feature_class == FeatureClass::OpenProfile;
            order.push_back({feature.id, feature.parents, static_cast<int>(s), own, is_profile});
        }
    }
    return order;
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
    NextOperation(const std::vector<Operation>& operations, const VisitProblem& problem,
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
        const std::vector<bool>& above = below_[problem_.operations[operation].feature];
        for (std::size_t done = order.size(); done > 0; --done)
            if (above[problem_.operations[order[done - 1]].feature]) return done;
        return 0;
    }

    const std::vector<Operation>& operations_;
    const VisitProblem& problem_;
    OrderRule rule_;
    Below below_;
};

/// Rapids that join the operations of one setup without a tool change between them.
double travelMm(const std::vector<Operation>& operations, const std::vector<int>& order) {
    double sum_mm = 0;
    for (std::size_t i = 1; i < order.size(); ++i) {
        if (operations[order[i]].tool_id != operations[order[i - 1]].tool_id) continue;
        const Toolpath& before = operations[order[i - 1]].path;
        const Vec3 from = before.moves.empty() ? before.start : before.moves.back().to;
        const Vec3 way = operations[order[i]].path.start - from;
        sum_mm += way.head<2>().norm() + std::abs(way.z());
    }
    return sum_mm;
}

/// The operations in the order of these tools, each tool's by the rule.
std::vector<int> inOrderOf(const std::vector<int>& tools, const VisitProblem& problem,
                           const NextOperation& next_operation) {
    std::vector<int> done(problem.queue.size(), 0);
    std::vector<int> order;
    for (const int tool : tools) {
        for (;;) {
            int best = -1;
            for (const int next : readyOperations(problem, done)) {
                if (problem.operations[next].tool != tool) continue;
                if (best < 0 || next_operation.isBetter(next, best, order)) best = next;
            }
            if (best < 0) break;
            order.push_back(best);
            ++done[problem.operations[best].feature];
        }
    }
    return order;
}

/// The order of an earlier plan for what is still there, with what is new put in.
class OrderAsBefore {
  public:
    /// \param otherwise  the order of a plan made anew
    OrderAsBefore(const VisitProblem& problem, const EarlierPlaces& places, const std::vector<int>& otherwise)
        : problem_(problem), places_(places), position_(otherwise.size()) {
        for (std::size_t i = 0; i < otherwise.size(); ++i)
            position_[otherwise[i]] = static_cast<int>(i);
    }

    std::vector<int> order() {
        done_.assign(problem_.queue.size(), 0);
        std::vector<int> order;
        while (order.size() < problem_.operations.size()) {
            const int last_tool = order.empty() ? -1 : problem_.operations[order.back()].tool;
            order.push_back(next(last_tool));
            ++done_[problem_.operations[order.back()].feature];
        }
        return order;
    }

  private:
    int setupOf(int operation) const { return problem_.setupOf(operation); }

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
        std::vector<int> ready = readyOperations(problem_, done_);
        STEPMILL_CHECK(!ready.empty(), "features do not wait for each other in a circle");
        std::sort(ready.begin(), ready.end(), [this](int a, int b) { return isEarlier(a, b); });
        const int before = nextOfBefore(setupOf(ready.front()));
        const bool may_run = before >= 0 && ready.front() == before;
        if (may_run && problem_.operations[before].tool == last_tool) return before;
        const auto is_new = [&](int one) { return !places_[one] && setupOf(one) == setupOf(ready.front()); };
        for (const int one : ready)
            if (is_new(one) && problem_.operations[one].tool == last_tool) return one;
        if (may_run) return before;
        const auto fresh = std::find_if(ready.begin(), ready.end(), is_new);
        return fresh != ready.end() ? *fresh : ready.front();
    }

    const VisitProblem& problem_;
    const EarlierPlaces& places_;
    std::vector<int> position_;
    std::vector<int> done_;  ///< of each feature
};

/// Puts the earlier plan's order in place of one that was found, in each setup that has operations of it.
void keepOrder(const std::vector<Operation>& operations, const VisitProblem& problem,
               const EarlierPlaces& places, std::vector<std::vector<WeighedOrder>>& weighed,
               std::vector<std::vector<int>>& taken) {
    std::vector<int> otherwise;
    for (const std::vector<int>& of_setup : taken)
        otherwise.insert(otherwise.end(), of_setup.begin(), of_setup.end());
    std::vector<std::vector<int>> kept(taken.size());
    for (const int operation : OrderAsBefore(problem, places, otherwise).order())
        kept[problem.setupOf(operation)].push_back(operation);
    for (std::size_t setup = 0; setup < taken.size(); ++setup) {
        const bool any = std::any_of(taken[setup].begin(), taken[setup].end(),
                                     [&](int operation) { return places[operation].has_value(); });
        if (!any || kept[setup] == taken[setup]) continue;
        weighed[setup].insert(weighed[setup].begin(),
                              {OrderRule::Earlier, travelMm(operations, kept[setup])});
        taken[setup] = kept[setup];
    }
}

/// The setups each in the order by the rule with the least travel.
struct WeighedSetups {
    std::vector<std::vector<WeighedOrder>> weighed;  ///< by setup; the one taken first
    std::vector<std::vector<int>> taken;             ///< by setup
    std::size_t visits = 0;

    double travelMm() const {
        double sum_mm = 0;
        for (const std::vector<WeighedOrder>& of_setup : weighed)
            if (!of_setup.empty()) sum_mm += of_setup.front().travel_mm;
        return sum_mm;
    }
    /// \pre  both are of the same operations
    bool isShorterThan(const WeighedSetups& other) const {
        if (visits != other.visits) return visits < other.visits;
        return travelMm() < other.travelMm();
    }
};

VisitProblem withoutStages(VisitProblem problem) {
    for (VisitOperation& operation : problem.operations)
        operation.stage = 0;
    return problem;
}

/// \param searched  the problem as visits are searched for
WeighedSetups weighedSetups(const std::vector<Operation>& operations, const std::vector<Precedence>& features,
                            const VisitProblem& problem, const VisitProblem& searched) {
    int setups = 0;
    for (const Precedence& feature : features)
        setups = std::max(setups, feature.setup + 1);
    const std::vector<int> tools = fewestVisits(searched, kPlanSearch).tools;
    WeighedSetups found;
    found.visits = tools.size();
    found.weighed.resize(setups);
    found.taken.resize(setups);
    for (const OrderRule rule : {OrderRule::Nearest, OrderRule::Branches, OrderRule::Levels}) {
        std::vector<std::vector<int>> by_setup(setups);
        const NextOperation by_rule(operations, problem, features, rule);
        for (const int operation : inOrderOf(tools, problem, by_rule))
            by_setup[problem.setupOf(operation)].push_back(operation);
        for (int setup = 0; setup < setups; ++setup) {
            std::vector<WeighedOrder>& weighed = found.weighed[setup];
            const WeighedOrder one{rule, travelMm(operations, by_setup[setup])};
            const bool better = weighed.empty() || one.travel_mm < weighed.front().travel_mm;
            weighed.insert(better ? weighed.begin() : weighed.end(), one);
            if (better) found.taken[setup] = std::move(by_setup[setup]);
        }
    }
    return found;
}

}  // namespace

std::vector<int> orderOperations(const std::vector<Operation>& operations,
                                 const std::vector<Precedence>& features, OrderRule rule) {
    const VisitProblem problem = visitProblem(operations, features);
    return inOrderOf(fewestVisits(problem, kPlanSearch).tools, problem,
                     NextOperation(operations, problem, features, rule));
}

ShortestOrder shortestOrder(const std::vector<Operation>& operations, const std::vector<Precedence>& features,
                            const EarlierPlaces& places) {
    const VisitProblem problem = visitProblem(operations, features);
    WeighedSetups weighed = weighedSetups(operations, features, problem, problem);
    // What a setter does first may lie farther away: stages are kept where that costs nothing.
    WeighedSetups any_stage = weighedSetups(operations, features, problem, withoutStages(problem));
    if (any_stage.isShorterThan(weighed)) weighed = std::move(any_stage);
    if (!places.empty()) keepOrder(operations, problem, places, weighed.weighed, weighed.taken);
    ShortestOrder shortest;
    shortest.weighed = std::move(weighed.weighed);
    for (const std::vector<int>& of_setup : weighed.taken)
        shortest.order.insert(shortest.order.end(), of_setup.begin(), of_setup.end());
    return shortest;
}

}  // namespace stepmill
