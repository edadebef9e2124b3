#include "stepmill/core/error.h"
#include "stepmill/sequence/tool_dag.h"

namespace stepmill {
namespace {

/// Cheaper, else fewer tools, else larger first tools (smaller node numbers).
bool isBetter(const CheapestPath& a, const CheapestPath& b) {
    if (a.cost != b.cost) return a.cost < b.cost;
    if (a.tools.size() != b.tools.size()) return a.tools.size() < b.tools.size();
    return a.tools < b.tools;
}

/// The cheapest paths known that end with an edge into one tool, by where that edge starts. Without savings
/// only the cheapest of them can go on, so one stands for all.
class PathsInto {
  public:
    explicit PathsInto(bool apart) : apart_(apart) {}

    void add(CheapestPath path) {
        if (apart_ || paths_.empty())
            paths_.push_back(std::move(path));
        else if (isBetter(path, paths_.front()))
            paths_.front() = std::move(path);
    }
    const std::vector<CheapestPath>& paths() const { return paths_; }

  private:
    bool apart_;
    std::vector<CheapestPath> paths_;
};

int beforeLast(const CheapestPath& path) {
    return path.tools.size() < 2 ? kSource : path.tools[path.tools.size() - 2];
}

}  // namespace

CheapestPath cheapestPath(int n, const std::function<double(int, int)>& edge, const std::vector<bool>& ends,
                          const Saving& saving) {
    STEPMILL_CHECK(n >= 0 && ends.size() == static_cast<std::size_t>(n), "one end mark per tool");
    // What the path costs when tool `next` follows.
    const auto costBefore = [&](const CheapestPath& path, int next) {
        return saving ? path.cost - saving(beforeLast(path), path.tools.back(), next) : path.cost;
    };
    // The numbering is a topological order, so when node k is reached every path to it is known.
    std::vector<PathsInto> into(n, PathsInto(static_cast<bool>(saving)));
    CheapestPath result;
    for (int k = 0; k < n; ++k) {
        const double first = edge(kSource, k);
        if (first < kNoEdge) into[k].add({{k}, first});
        for (int m = 0; m < k; ++m) {
            const double weight = edge(m, k);
            if (!(weight < kNoEdge)) continue;
            const CheapestPath* best = nullptr;
            double least = kNoEdge;
            for (const CheapestPath& path : into[m].paths()) {
                const double cost = costBefore(path, k);
                // Most lose by cost alone.
                if (best != nullptr && cost > least) continue;
                if (best == nullptr || isBetter({path.tools, cost}, {best->tools, least})) {
                    best = &path;
                    least = cost;
                }
            }
            if (best == nullptr) continue;
            CheapestPath longer{best->tools, least + weight};
            longer.tools.push_back(k);
            into[k].add(std::move(longer));
        }
        if (!ends[k]) continue;
        for (const CheapestPath& path : into[k].paths()) {
            CheapestPath whole{path.tools, costBefore(path, n)};
            if (isBetter(whole, result)) result = std::move(whole);
        }
    }
    return result;
}

}  // namespace stepmill
