// Sections of a solid at one height.

#include "layers/section/section.h"

#include "layers/section/section_path.h"
#include "layers/section/section_trace.h"
#include "layers/section/tidy_loop.h"

namespace stepmill::layers {

namespace {

/// Stretches of a chain on one face each, beginning where the face changes.
std::vector<FaceRun> splitByFace(const SolidMesh& mesh, const std::vector<Crossing>& chain) {
    const std::size_t n = chain.size();
    std::size_t first = 0;
    while (first < n && chain[first].face == chain[(first + n - 1) % n].face)
        ++first;
    if (first == n) return {FaceRun{&mesh.faces()[chain[0].face], chain, true}};
    std::vector<FaceRun> runs;
    for (std::size_t k = 0; k < n; ++k) {
        const Crossing& crossing = chain[(first + k) % n];
        if (runs.empty() || crossing.face != runs.back().crossings.back().face)
            runs.push_back({&mesh.faces()[crossing.face], {}, false});
        runs.back().crossings.push_back(crossing);
    }
    return runs;
}

}  // namespace

std::optional<Region> exactSection(const SolidMesh& mesh, double z_mm, const Tolerances& tol) {
    const Chains chains = traceChains(mesh, z_mm);
    if (!chains.open.empty()) return std::nullopt;
    Region region;
    for (const std::vector<Crossing>& chain : chains.closed) {
        Loop loop = joinRuns(mesh, splitByFace(mesh, chain), z_mm, tol);
        if (!loop.segments.empty()) region.loops.push_back(std::move(loop));
    }
    sortLoops(region);
    if (diagnose(region)) return std::nullopt;
    return region;
}

}  // namespace stepmill::layers
