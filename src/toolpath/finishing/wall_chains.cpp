#include "toolpath/finishing/wall_chains.h"

#include <algorithm>

#include "toolpath/patterns/ring_family.h"

namespace stepmill::toolpath {

namespace {

/// Stretches between two cuts that are shorter than this many radii are gone along rather than lifted over.
constexpr double kBridgeRadii = 2;

}  // namespace

WallChains::WallChains(const WallTask& task, double radius_mm, const Tolerances& tol)
    : left_edges_(task.left), radius_mm_(radius_mm), tol_(tol) {}

bool WallChains::isNeeded(const Edge& edge) const {
    return left_edges_.anyNearer(edge, radius_mm_ - onBoundaryMm(tol_));
}

std::vector<Chain> WallChains::along(const Loop& loop) const {
    const std::vector<Edge> edges = edgesOf(loop);
    std::vector<char> needed(edges.size());
    std::transform(edges.begin(), edges.end(), needed.begin(),
                   [&](const Edge& edge) { return static_cast<char>(isNeeded(edge)); });
    if (std::find(needed.begin(), needed.end(), 1) == needed.end()) return {};
    bridge(edges, needed);
    const auto gap = std::find(needed.begin(), needed.end(), 0);
    if (gap == needed.end()) return {{loop, true}};
    std::vector<Chain> chains;
    const auto first = static_cast<std::size_t>(gap - needed.begin());
    for (std::size_t k = 1; k <= edges.size(); ++k) {
        const std::size_t i = (first + k) % edges.size();
        const std::size_t before = (first + k - 1) % edges.size();
        if (needed[i] == 0) continue;
        if (needed[before] == 0) chains.push_back({Path{edges[i].from, {}}, false});
        chains.back().path.segments.push_back(edges[i].segment);
    }
    return chains;
}

/// Fills short gaps.
void WallChains::bridge(const std::vector<Edge>& edges, std::vector<char>& needed) const {
    const std::size_t count = edges.size();
    const std::vector<char> before = needed;
    for (std::size_t i = 0; i < count; ++i) {
        if (before[i] == 0 || before[(i + 1) % count] != 0) continue;
        double gap_mm = 0;
        std::size_t gap_edges = 0;
        for (; before[(i + 1 + gap_edges) % count] == 0; ++gap_edges)
            gap_mm += length(edges[(i + 1 + gap_edges) % count]);
        if (gap_mm > kBridgeRadii * radius_mm_) continue;
        for (std::size_t k = 0; k < gap_edges; ++k)
            needed[(i + 1 + k) % count] = 1;
    }
}

}  // namespace stepmill::toolpath
