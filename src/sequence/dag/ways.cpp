#include "sequence/dag/ways.h"

#include <algorithm>
#include <cstdint>

#include "stepmill/sequence/tool_dag.h"

namespace stepmill {
namespace {

/// Partial ways looked at for a feature, and ways kept; beyond these only the cheapest found are offered.
constexpr int kMostWaysSeen = 20000;
constexpr std::size_t kMostWaysKept = 24;

using Visits = std::vector<const ToolAssembly*>;

bool isWithin(const Visits& few, const Visits& many) {
    auto next = few.begin();
    for (const ToolAssembly* tool : many)
        if (next != few.end() && *next == tool) ++next;
    return next == few.end();
}

/// A bit for each tool, the same for some others: visits whose bits are not among another's are not within
/// them. Which bits those are changes no answer.
std::uint64_t bitsOf(const Visits& visits) {
    constexpr std::uintptr_t kBits = 64;
    std::uint64_t bits = 0;
    for (const ToolAssembly* tool : visits)
        bits |= std::uint64_t{1} << (reinterpret_cast<std::uintptr_t>(tool) / sizeof(ToolAssembly) % kBits);
    return bits;
}

/// What most pairs of ways are told apart by, side by side in memory.
struct Gist {
    double paths = 0;
    std::uint64_t bits = 0;
};

/// May b be no better than a, whatever other features call?
bool mayBeNoBetter(const Gist& b, const Gist& a) {
    // Both asked always: which of them fails cannot be foretold, and a wrong guess costs more than the
    // question.
    return static_cast<int>(a.paths <= b.paths) & static_cast<int>((a.bits & ~b.bits) == 0);
}

class WayLister {
  public:
    explicit WayLister(const WaySource& source) : source_(source) {}

    std::vector<Way> list() {
        add(source_.dag.path, source_.dag.weight);
        std::vector<int> path;
        extend(path, 0);
        // The feature's own stays first; of the others those that are dearest by themselves go.
        std::stable_sort(ways_.begin() + 1, ways_.end(),
                         [&](const Way& a, const Way& b) { return alone(a) < alone(b); });
        if (ways_.size() > kMostWaysKept) ways_.resize(kMostWaysKept);
        return std::move(ways_);
    }

  private:
    double changes(const Visits& visits) const {
        return static_cast<double>(visits.size()) * source_.change_weight;
    }
    double alone(const Way& way) const { return way.paths + changes(way.visits); }

    Visits visitsOn(const std::vector<int>& path) const {
        Visits visits;
        const auto visit = [&](const ToolAssembly* tool) {
            if (visits.empty() || visits.back() != tool) visits.push_back(tool);
        };
        for (std::size_t i = 0; i < path.size(); ++i) {
            const WeighedEdge* edge = edgeBetween(source_.dag, i == 0 ? kSource : path[i - 1], path[i]);
            visit(source_.tools[path[i]].tool);
            const int next = i + 1 < path.size() ? path[i + 1] : static_cast<int>(source_.tools.size());
            for (const ToolAssembly* surrogate :
                 surrogatesBefore(edge->surrogates, next, source_.finder, source_.tools))
                visit(surrogate);
        }
        return visits;
    }

    void add(const std::vector<int>& path, double weight) {
        Way way{visitsOn(path), 0, path};
        way.paths = weight - changes(way.visits);
        const Gist gist{way.paths, bitsOf(way.visits)};
        if (isNoBetterThanKnown(way, gist) || !source_.leaves_the_same(path)) return;
        ways_.push_back(std::move(way));
        gists_.push_back(gist);
    }

    bool isNoBetterThanKnown(const Way& way, const Gist& gist) const {
        for (std::size_t i = 0; i < gists_.size(); ++i)
            if (mayBeNoBetter(gist, gists_[i]) && isWithin(ways_[i].visits, way.visits)) return true;
        return false;
    }

    /// All ways on from `path`, whose edges but the last weigh `weight`, as long as their paths alone take no
    /// more than the whole of the feature's own optimum: others are worse in every company.
    void extend(std::vector<int>& path, double weight) {
        const int n = static_cast<int>(source_.tools.size());
        const int before = path.size() < 2 ? kSource : path[path.size() - 2];
        const int last = path.empty() ? kSource : path.back();
        const WeighedEdge* edge = path.empty() ? nullptr : edgeBetween(source_.dag, before, last);
        if (++seen_ > kMostWaysSeen) return;
        if (edge != nullptr && source_.ends[last]) add(path, weight + edge->weightBefore(n));
        const double so_far_changes = path.empty() ? 0 : changes(visitsOn(path));
        for (int next = last + 1; next < n; ++next) {
            if (edgeBetween(source_.dag, last, next) == nullptr) continue;
            const double so_far = weight + (edge != nullptr ? edge->weightBefore(next) : 0);
            if (so_far - so_far_changes > source_.dag.weight) continue;
            path.push_back(next);
            extend(path, so_far);
            path.pop_back();
        }
    }

    const WaySource& source_;
    std::vector<Way> ways_;
    std::vector<Gist> gists_;  ///< of each of them
    int seen_ = 0;
};

}  // namespace

std::vector<Way> listWays(const WaySource& source) {
    return WayLister(source).list();
}

}  // namespace stepmill
