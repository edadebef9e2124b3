#include "plan/order/visit_problem.h"

#include <algorithm>
#include <map>
#include <set>

#include "stepmill/core/error.h"

namespace stepmill {
namespace {

/// What a setter does first: the faces that others are measured from, then roughing, holes before the profile
/// that ties them to what is held, finishing last.
enum class WorkKind { Face, Rough, Holes, Profile, Finish };

WorkKind kindOf(const Operation& operation, const Precedence& feature) {
    if (operation.role == Role::Face) return WorkKind::Face;
    if (operation.role == Role::Finish) return WorkKind::Finish;
    if (isForHoles(operation.role)) return WorkKind::Holes;
    return feature.is_profile ? WorkKind::Profile : WorkKind::Rough;
}

/// Of each feature its nearest ancestors with operations, ascending: when theirs are done, so are those of
/// all before them.
std::vector<std::vector<int>> nearestWithOperations(const std::vector<VisitFeature>& features,
                                                    const std::vector<std::vector<int>>& queue) {
    std::vector<std::vector<int>> nearest(features.size());
    for (std::size_t i = 0; i < features.size(); ++i) {
        std::set<int> found;
        for (const int parent : features[i].parents) {
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

void addParents(VisitOperation& operation, const std::vector<int>& nearest,
                const std::vector<std::vector<int>>& queue) {
    std::vector<Need>& needs = operation.needs;
    const auto is_named = [&](int ancestor) {
        return std::any_of(needs.begin(), needs.end(),
                           [&](const Need& need) { return need.feature == ancestor; });
    };
    for (const int ancestor : nearest)
        if (!is_named(ancestor)) needs.push_back({ancestor, static_cast<int>(queue[ancestor].size())});
    std::erase_if(needs, [](const Need& need) { return need.operations == 0; });
}

/// Leaves out needs that follow from others of the operation, or from those of the one before it.
class NeedReduction {
  public:
    explicit NeedReduction(VisitProblem& problem) : problem_(problem), done_(problem.operations.size()) {}

    void reduceAll() {
        // Parents come before their children, so what an operation needs is known before it.
        for (const std::vector<int>& queue : problem_.queue)
            for (std::size_t i = 0; i < queue.size(); ++i)
                reduce(queue[i], i > 0 ? queue[i - 1] : -1);
    }

  private:
    void reduce(int operation, int before) {
        std::vector<Need>& needs = problem_.operations[operation].needs;
        std::vector<int> last;  // operations that must be done, and all these need
        if (before >= 0) last.push_back(before);
        for (const Need& need : needs)
            last.push_back(problem_.queue[need.feature][need.operations - 1]);
        std::erase_if(needs, [&](const Need& need) {
            const int own = problem_.queue[need.feature][need.operations - 1];
            return std::any_of(last.begin(), last.end(), [&](int other) {
                return other != own && done_[other][need.feature] >= need.operations;
            });
        });
        std::vector<int>& done = done_[operation];
        done.assign(problem_.queue.size(), 0);
        for (const int other : last)
            for (std::size_t f = 0; f < done.size(); ++f)
                done[f] = std::max(done[f], done_[other][f]);
        ++done[problem_.operations[operation].feature];
    }

    VisitProblem& problem_;
    std::vector<std::vector<int>> done_;  ///< of each operation, once it is done: so many of each feature
};

/// The features of the first setup that is not done; none where all are.
const std::vector<int>& featuresInWork(const VisitProblem& problem, const std::vector<int>& done) {
    static const std::vector<int> kNone;
    const auto is_open = [&](int f) { return done[f] < static_cast<int>(problem.queue[f].size()); };
    const auto open =
        std::find_if(problem.in_setup.begin(), problem.in_setup.end(), [&](const std::vector<int>& features) {
            return std::any_of(features.begin(), features.end(), is_open);
        });
    return open == problem.in_setup.end() ? kNone : *open;
}

/// The operations that are asked for and may run now.
template <typename IsAskedFor>
std::vector<int> readyOf(const VisitProblem& problem, const std::vector<int>& done,
                         const IsAskedFor& isAskedFor) {
    std::vector<int> ready;
    for (const int f : featuresInWork(problem, done)) {
        if (done[f] == static_cast<int>(problem.queue[f].size())) continue;
        const int next = problem.queue[f][done[f]];
        const VisitOperation& operation = problem.operations[next];
        if (isAskedFor(operation) &&
            std::all_of(operation.needs.begin(), operation.needs.end(),
                        [&](const Need& need) { return done[need.feature] >= need.operations; }))
            ready.push_back(next);
    }
    return ready;
}

}  // namespace

VisitProblem visitProblem(std::vector<VisitOperation> operations, const std::vector<VisitFeature>& features) {
    VisitProblem problem;
    for (const VisitFeature& feature : features)
        problem.setup.push_back(feature.setup);
    problem.queue.resize(features.size());
    for (std::size_t i = 0; i < operations.size(); ++i) {
        problem.tools = std::max(problem.tools, operations[i].tool + 1);
        problem.queue[operations[i].feature].push_back(static_cast<int>(i));
    }
    for (std::size_t f = 0; f < features.size(); ++f) {
        const auto setup = static_cast<std::size_t>(features[f].setup);
        if (setup >= problem.in_setup.size()) problem.in_setup.resize(setup + 1);
        if (!problem.queue[f].empty()) problem.in_setup[setup].push_back(static_cast<int>(f));
    }
    const std::vector<std::vector<int>> nearest = nearestWithOperations(features, problem.queue);
    for (VisitOperation& operation : operations)
        addParents(operation, nearest[operation.feature], problem.queue);
    problem.operations = std::move(operations);
    NeedReduction(problem).reduceAll();
    return problem;
}

VisitProblem visitProblem(const std::vector<Operation>& operations, const std::vector<Precedence>& features) {
    std::map<std::string, int> number;
    std::vector<VisitFeature> places;
    for (const Precedence& feature : features) {
        number.emplace(feature.feature_id, static_cast<int>(number.size()));
        places.push_back({feature.setup, {}});
    }
    const auto numberOf = [&](const std::string& id, const std::string& asked_by) {
        const auto found = number.find(id);
        STEPMILL_CHECK(found != number.end(), "feature " + id + " of " + asked_by);
        return found->second;
    };
    for (std::size_t f = 0; f < features.size(); ++f)
        for (const std::string& parent : features[f].parents)
            places[f].parents.push_back(numberOf(parent, features[f].feature_id));
    std::map<std::string, int> tool_number;
    std::vector<VisitOperation> visits;
    for (const Operation& operation : operations) {
        VisitOperation& visit = visits.emplace_back();
        visit.tool =
            tool_number.emplace(operation.tool_id, static_cast<int>(tool_number.size())).first->second;
        visit.feature = numberOf(operation.feature_id, operation.id);
        visit.stage = static_cast<int>(kindOf(operation, features[visit.feature]));
        for (const Wait& wait : operation.waits)
            visit.needs.push_back({numberOf(wait.feature_id, operation.id), wait.operations});
    }
    return visitProblem(std::move(visits), places);
}

std::vector<int> readyOperations(const VisitProblem& problem, const std::vector<int>& done) {
    return readyOf(problem, done, [](const VisitOperation&) { return true; });
}

std::vector<int> takeAll(const VisitProblem& problem, int tool, std::vector<int>& done) {
    const auto is_its = [tool](const VisitOperation& operation) { return operation.tool == tool; };
    std::vector<int> taken;
    for (;;) {
        const std::vector<int> ready = readyOf(problem, done, is_its);
        if (ready.empty()) return taken;
        for (const int next : ready)
            ++done[problem.operations[next].feature];
        taken.insert(taken.end(), ready.begin(), ready.end());
    }
}

}  // namespace stepmill
