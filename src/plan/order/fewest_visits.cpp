#include "plan/order/fewest_visits.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "stepmill/core/error.h"

namespace stepmill {
namespace {

/// How often each tool must be called, by the chains of operations that wait for each other.
class LeastVisits {
  public:
    explicit LeastVisits(const VisitProblem& problem) : problem_(problem) {
        runs_.assign(problem.operations.size() * problem.tools, 0);
        std::vector<std::vector<int>> next(problem.operations.size());
        for (std::size_t i = 0; i < problem.operations.size(); ++i)
            for (const int before : directlyBefore(static_cast<int>(i)))
                next[before].push_back(static_cast<int>(i));
        for (const int operation : lastFirst(next))
            countRuns(operation, next[operation]);
        const std::vector<int> nothing_done(problem.queue.size(), 0);
        for (const std::vector<int>& features : problem.in_setup)
            untouched_.push_back(visitsOf(features, nothing_done));
    }

    /// What is left of a setup cannot be done in fewer visits; each later setup may begin with the tool that
    /// the one before ends with. No setup is begun before those ahead of it are done.
    int after(const std::vector<int>& done) const {
        int visits = 0;
        for (std::size_t setup = 0; setup < untouched_.size(); ++setup) {
            const int own = visits > 0 ? untouched_[setup] : visitsOf(problem_.in_setup[setup], done);
            visits += visits > 0 && own > 0 ? own - 1 : own;
        }
        return visits;
    }

  private:
    /// What is left of one setup's features.
    int visitsOf(const std::vector<int>& features, const std::vector<int>& done) const {
        std::vector<int> most(problem_.tools, 0);
        for (const int f : features) {
            const std::vector<int>& queue = problem_.queue[f];
            if (done[f] == static_cast<int>(queue.size())) continue;
            const int* of_next = &runs_[static_cast<std::size_t>(queue[done[f]]) * problem_.tools];
            for (int tool = 0; tool < problem_.tools; ++tool)
                most[tool] = std::max(most[tool], of_next[tool]);
        }
        return std::accumulate(most.begin(), most.end(), 0);
    }

    int& runs(int operation, int tool) {
        return runs_[static_cast<std::size_t>(operation) * problem_.tools + tool];
    }
    int runs(int operation, int tool) const {
        return runs_[static_cast<std::size_t>(operation) * problem_.tools + tool];
    }

    /// Operations of the same setup that come straight before.
    std::vector<int> directlyBefore(int operation) const {
        std::vector<int> before;
        const int feature = problem_.operations[operation].feature;
        const std::vector<int>& own = problem_.queue[feature];
        const auto place = std::find(own.begin(), own.end(), operation);
        if (place != own.begin()) before.push_back(*std::prev(place));
        for (const Need& need : problem_.operations[operation].needs)
            if (problem_.setup[need.feature] == problem_.setup[feature])
                before.push_back(problem_.queue[need.feature][need.operations - 1]);
        return before;
    }

    /// All operations, each after those that come after it.
    std::vector<int> lastFirst(const std::vector<std::vector<int>>& next) const {
        std::vector<int> waits_for(next.size(), 0);
        std::vector<std::vector<int>> before(next.size());
        for (std::size_t i = 0; i < next.size(); ++i) {
            waits_for[i] = static_cast<int>(next[i].size());
            for (const int later : next[i])
                before[later].push_back(static_cast<int>(i));
        }
        std::vector<int> order;
        for (std::size_t i = 0; i < next.size(); ++i)
            if (waits_for[i] == 0) order.push_back(static_cast<int>(i));
        for (std::size_t i = 0; i < order.size(); ++i)
            for (const int earlier : before[order[i]])
                if (--waits_for[earlier] == 0) order.push_back(earlier);
        STEPMILL_CHECK(order.size() == next.size(), "operations do not wait for each other in a circle");
        return order;
    }

    void countRuns(int operation, const std::vector<int>& next) {
        const int own = problem_.operations[operation].tool;
        runs(operation, own) = 1;
        for (const int later : next)
            for (int tool = 0; tool < problem_.tools; ++tool) {
                const bool again =
                    tool == own && problem_.operations[later].tool != own && runs(later, tool) > 0;
                runs(operation, tool) = std::max(runs(operation, tool), runs(later, tool) + (again ? 1 : 0));
            }
    }

    const VisitProblem& problem_;
    std::vector<int> runs_;       ///< of each operation, of each tool: on the chain from it on with the most
    std::vector<int> untouched_;  ///< visits of each setup before it is begun
};

/// How many operations of each feature are done, and the tools called so far.
struct Partial {
    std::vector<int> done;
    std::vector<int> tools;
    int total = 0;
    int left = 0;   ///< visits that are still to come, at least
    int late = 0;   ///< operations of an earlier stage that came in a later visit than some of a later one
    int stage = 0;  ///< the latest of the operations that are done
};

class VisitSearcher {
  public:
    explicit VisitSearcher(const VisitProblem& problem) : problem_(problem), least_(problem) {}

    int atLeast() const { return least_.after(start().done); }

    /// The tools of at most so many visits; nothing where none were found.
    /// \param dropped  becomes true where partial orders were dropped that might have come to an end in time
    std::optional<std::vector<int>> within(int visits, std::size_t width, bool& dropped) const {
        std::vector<Partial> beam{start()};
        const int operations = static_cast<int>(problem_.operations.size());
        while (!beam.empty() && beam.front().total < operations)
            beam = oneVisitMore(beam, visits, width, dropped);
        if (beam.empty()) return std::nullopt;
        return beam.front().tools;
    }

  private:
    Partial start() const {
        Partial partial;
        partial.done.assign(problem_.queue.size(), 0);
        return partial;
    }

    /// Over all setups.
    int stageOf(int operation) const {
        constexpr int kMostStages = 100;
        return problem_.setupOf(operation) * kMostStages + problem_.operations[operation].stage;
    }

    /// Runs everything tool `tool` can do now and thereby becomes able to do.
    Partial afterVisit(Partial partial, int tool) const {
        partial.tools.push_back(tool);
        const int stage_before = partial.stage;
        for (const int operation : takeAll(problem_, tool, partial.done)) {
            ++partial.total;
            partial.late += stageOf(operation) < stage_before ? 1 : 0;
            partial.stage = std::max(partial.stage, stageOf(operation));
        }
        partial.left = least_.after(partial.done);
        return partial;
    }

    /// Fewest visits left, then what is in the order of stages, then most operations done, then the earlier
    /// tools.
    static bool isMorePromising(const Partial& a, const Partial& b) {
        if (a.left != b.left) return a.left < b.left;
        if (a.late != b.late) return a.late < b.late;
        if (a.total != b.total) return a.total > b.total;
        return a.tools < b.tools;
    }

    std::vector<Partial> oneVisitMore(const std::vector<Partial>& beam, int visits, std::size_t width,
                                      bool& dropped) const {
        std::map<std::vector<int>, Partial> wider;
        for (const Partial& partial : beam) {
            std::set<int> callable;
            for (const int next : readyOperations(problem_, partial.done))
                callable.insert(problem_.operations[next].tool);
            STEPMILL_CHECK(!callable.empty(), "features do not wait for each other in a circle");
            for (const int tool : callable) {
                Partial longer = afterVisit(partial, tool);
                if (longer.left > visits - static_cast<int>(longer.tools.size())) continue;
                const auto known = wider.find(longer.done);
                if (known == wider.end())
                    wider.emplace(longer.done, std::move(longer));
                else if (isMorePromising(longer, known->second))
                    known->second = std::move(longer);
            }
        }
        std::vector<Partial> longer;
        longer.reserve(wider.size());
        for (auto& [done, partial] : wider)
            longer.push_back(std::move(partial));
        std::sort(longer.begin(), longer.end(), isMorePromising);
        if (longer.size() > width) {
            longer.resize(width);
            dropped = true;
        }
        return longer;
    }

    const VisitProblem& problem_;
    LeastVisits least_;
};

}  // namespace

int leastVisits(const VisitProblem& problem) {
    return problem.operations.empty() ? 0 : VisitSearcher(problem).atLeast();
}

std::optional<int> visitsWithin(const VisitProblem& problem, int most_visits, int spare_visits,
                                std::size_t width) {
    if (most_visits < spare_visits) return std::nullopt;
    if (problem.operations.empty()) return 0;
    const VisitSearcher searcher(problem);
    if (searcher.atLeast() > most_visits - spare_visits) return std::nullopt;
    bool dropped = false;
    const auto tools = searcher.within(most_visits, width, dropped);
    return tools ? std::optional(static_cast<int>(tools->size())) : std::nullopt;
}

FewestVisits fewestVisits(const VisitProblem& problem, const VisitSearch& search) {
    if (problem.operations.empty()) return {};
    const VisitSearcher searcher(problem);
    bool dropped = false;
    FewestVisits fewest{*searcher.within(kAnyNumberOfVisits, search.width, dropped), searcher.atLeast()};
    if (!dropped) fewest.at_least = static_cast<int>(fewest.tools.size());
    dropped = false;
    for (int visits = fewest.at_least;
         search.proving_width > 0 && visits < static_cast<int>(fewest.tools.size()); ++visits) {
        auto fewer = searcher.within(visits, search.proving_width, dropped);
        if (fewer)
            fewest.tools = std::move(*fewer);
        else if (!dropped)
            fewest.at_least = visits + 1;
    }
    return fewest;
}

}  // namespace stepmill
