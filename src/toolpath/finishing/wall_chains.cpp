#include "toolpath/finishing/wall_chains.h"

#include "toolpath/needed_pieces.h"
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

std::vector<Path> WallChains::along(const Loop& loop) const {
    const std::vector<Edge> edges = edgesOf(loop);
    std::vector<char> needed;
    needed.reserve(edges.size());
    for (const Edge& edge : edges)
        needed.push_back(static_cast<char>(isNeeded(edge)));
    return neededPieces(loop, edges, needed, kBridgeRadii * radius_mm_);
}

}  // namespace stepmill::toolpath
