#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace stepmill {

/// Node numbers of a tool DAG over n tools in falling diameter: -1 is the source ("tool 0", nothing cut
/// yet), 0..n-1 the tools, n the sink.
inline constexpr int kSource = -1;

inline constexpr double kNoEdge = std::numeric_limits<double>::infinity();

/// The cheapest way from source to sink.
struct CheapestPath {
    std::vector<int> tools;  ///< in the order of use; empty when there is none
    double cost = kNoEdge;
};

/// What a path saves on edge (m, n) when tool p comes next; p is the sink's number n_tools at the end.
/// Never more than edge (m, n) costs.
using Saving = std::function<double(int m, int n, int p)>;

/// Cheapest path of the DAG in topological order [DSouza2006, section 'Graph algorithm'].
/// `edge(m, n)` is the cost of machining D_mn with n (m may be kSource), kNoEdge where there is none, asked
/// once for each pair; `ends[n]` says that tool n has a zero edge to the sink. Ties go to fewer tools, then
/// to the larger first tools. O(n^2) without `saving`.
///
/// With `saving` the cost of a path depends on three tools in a row: a surrogate of (m, n) that is the next
/// tool anyway is changed to once. The exact optimum is then the cheapest path over the pairs (m, n) -> (n,
/// p) [tool-dag.md, 'Surrogates']: O(n^3).
CheapestPath cheapestPath(int n, const std::function<double(int, int)>& edge, const std::vector<bool>& ends,
                          const Saving& saving = {});

}  // namespace stepmill
