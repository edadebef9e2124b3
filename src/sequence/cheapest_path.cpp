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

}  // namespace

CheapestPath cheapestPath(int n, const std::function<double(int, int)>& edge, const std::vector<bool>& ends) {
    STEPMILL_CHECK(n >= 0 && ends.size() == static_cast<std::size_t>(n), "one end mark per tool");
    // The numbering is a topological order, so when node k is reached every path to it is known.
    std::vector<CheapestPath> best(n);
    CheapestPath result;
    for (int k = 0; k < n; ++k) {
        for (int m = kSource; m < k; ++m) {
            const double before = m == kSource ? 0 : best[m].cost;
            if (before == kNoEdge) continue;
            const double cost = before + edge(m, k);
            // Most edges lose by cost alone; only then is a path worth copying.
            if (!(cost < kNoEdge) || cost > best[k].cost) continue;
            CheapestPath path = m == kSource ? CheapestPath{} : best[m];
            path.tools.push_back(k);
            path.cost = cost;
            if (isBetter(path, best[k])) best[k] = std::move(path);
        }
        if (ends[k] && best[k].cost < kNoEdge && isBetter(best[k], result)) result = best[k];
    }
    return result;
}

}  // namespace stepmill
