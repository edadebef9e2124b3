// Chains of facets that a horizontal plane crosses.

#include "layers/section/section_trace.h"

#include <algorithm>

namespace stepmill::layers {

namespace {

Vec2 crossingOnSide(const SolidMesh& mesh, int side, double z_mm) {
    const Vec3& a = mesh.nodes()[mesh.sides()[side].a];
    const Vec3& b = mesh.nodes()[mesh.sides()[side].b];
    const double t = std::clamp((z_mm - a.z()) / (b.z() - a.z()), 0.0, 1.0);
    return (a + t * (b - a)).head<2>();
}

/// Outward facets run counter-clockwise, so the plane enters a facet over the side that goes down and
/// leaves it over the side that goes up, material on the left.
std::vector<Crossing> crossedFacets(const SolidMesh& mesh, double z_mm) {
    std::vector<Crossing> crossed;
    for (std::size_t f = 0; f < mesh.faces().size(); ++f) {
        if (mesh.faces()[f].facets_low_mm >= z_mm || mesh.faces()[f].facets_high_mm < z_mm) continue;
        for (const int t : mesh.trianglesOfFace()[f]) {
            const MeshTriangle& triangle = mesh.triangles()[t];
            std::array<bool, 3> above{};
            for (int k = 0; k < 3; ++k)
                above[k] = mesh.nodes()[triangle.node[k]].z() >= z_mm;
            if (above[0] == above[1] && above[1] == above[2]) continue;
            Crossing crossing;
            crossing.triangle = t;
            crossing.face = triangle.face;
            for (int k = 0; k < 3; ++k) {
                if (above[k] == above[(k + 1) % 3]) continue;
                (above[k] ? crossing.side_in : crossing.side_out) = triangle.side[k];
            }
            crossing.from = crossingOnSide(mesh, crossing.side_in, z_mm);
            crossing.to = crossingOnSide(mesh, crossing.side_out, z_mm);
            crossed.push_back(crossing);
        }
    }
    return crossed;
}

}  // namespace

Chains traceChains(const SolidMesh& mesh, double z_mm) {
    const std::vector<Crossing> crossed = crossedFacets(mesh, z_mm);
    // Entries in the order of their side, and of one side in the order they were found.
    std::vector<std::pair<int, int>> by_side_in;
    std::vector<int> sides_out;
    for (std::size_t i = 0; i < crossed.size(); ++i) {
        by_side_in.emplace_back(crossed[i].side_in, static_cast<int>(i));
        sides_out.push_back(crossed[i].side_out);
    }
    std::sort(by_side_in.begin(), by_side_in.end());
    std::sort(sides_out.begin(), sides_out.end());
    // Open chains are followed from their beginnings, or one would come out in two pieces.
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < crossed.size(); ++i)
        if (!std::binary_search(sides_out.begin(), sides_out.end(), crossed[i].side_in)) starts.push_back(i);
    for (std::size_t i = 0; i < crossed.size(); ++i)
        starts.push_back(i);
    std::vector<bool> used(crossed.size(), false);
    Chains chains;
    for (const std::size_t start : starts) {
        if (used[start]) continue;
        std::vector<Crossing> chain;
        for (int at = static_cast<int>(start); at >= 0;) {
            used[at] = true;
            chain.push_back(crossed[at]);
            // Where a solid touches itself along an edge several facets may follow: the first unused.
            int next = -1;
            auto it =
                std::lower_bound(by_side_in.begin(), by_side_in.end(), std::pair(crossed[at].side_out, -1));
            for (; it != by_side_in.end() && it->first == crossed[at].side_out && next < 0; ++it)
                if (!used[it->second]) next = it->second;
            at = next;
        }
        const bool closes = chain.back().side_out == chain.front().side_in;
        (closes ? chains.closed : chains.open).push_back(std::move(chain));
    }
    return chains;
}

}  // namespace stepmill::layers
