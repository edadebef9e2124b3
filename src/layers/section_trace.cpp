// Chains of facets that a horizontal plane crosses.

#include "layers/section_trace.h"

#include <unordered_map>

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

std::optional<std::vector<std::vector<Crossing>>> traceChains(const SolidMesh& mesh, double z_mm) {
    const std::vector<Crossing> crossed = crossedFacets(mesh, z_mm);
    std::unordered_multimap<int, int> by_side_in;
    for (std::size_t i = 0; i < crossed.size(); ++i)
        by_side_in.emplace(crossed[i].side_in, static_cast<int>(i));
    std::vector<bool> used(crossed.size(), false);
    std::vector<std::vector<Crossing>> chains;
    for (std::size_t start = 0; start < crossed.size(); ++start) {
        if (used[start]) continue;
        std::vector<Crossing> chain;
        for (int at = static_cast<int>(start); at >= 0;) {
            used[at] = true;
            chain.push_back(crossed[at]);
            // Where a solid touches itself along an edge several facets may follow: the lowest unused.
            int next = -1;
            const auto [begin, end] = by_side_in.equal_range(crossed[at].side_out);
            for (auto it = begin; it != end; ++it)
                if (!used[it->second] && (next < 0 || it->second < next)) next = it->second;
            at = next;
        }
        if (chain.back().side_out != chain.front().side_in) return std::nullopt;
        chains.push_back(std::move(chain));
    }
    return chains;
}

}  // namespace stepmill::layers
