// One solid in one slab.

#include "layers/slab.h"

#include <fmt/format.h>

#include "layers/projection.h"
#include "layers/section.h"
#include "stepmill/core/error.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::layers {

namespace {

/// Sections "at the end" of a slab are cut that far inside it. What leaning walls gain on that height is
/// lost to the obstruction; half the gouge budget at most.
double insetMm(double height_mm, const Tolerances& tol) {
    return std::min(0.5 * tol.gouge_mm, 0.01 * height_mm);
}

bool allWallsVertical(const SolidMesh& mesh, double top_mm, double bottom_mm, double merge_mm) {
    for (const MeshFace& face : mesh.faces()) {
        if (face.vertical || face.horizontal) continue;
        if (face.z_min_mm < top_mm - merge_mm && face.z_max_mm > bottom_mm + merge_mm) return false;
    }
    return true;
}

/// A section is good if it exists and is a valid region.
std::optional<Region> validSection(const SolidMesh& mesh, double z_mm, const Tolerances& tol) {
    std::optional<Region> section = exactSection(mesh, z_mm, tol);
    if (section && diagnose(*section)) section.reset();
    return section;
}

enum class Lean { None, Up, Down, Both };

Lean leanOf(const std::vector<ProjectedFacet>& facets) {
    constexpr double kLeast = 1e-7;
    bool up = false;
    bool down = false;
    for (const ProjectedFacet& facet : facets) {
        up = up || facet.normal_z > kLeast;
        down = down || facet.normal_z < -kLeast;
    }
    if (up && down) return Lean::Both;
    return up ? Lean::Up : (down ? Lean::Down : Lean::None);
}

/// Gauss' rule over three heights: exact for areas that are polynomials of the height up to the fifth.
double volumeBetween(const SolidMesh& mesh, double top_mm, double bottom_mm, const Tolerances& tol,
                     std::vector<std::string>& remarks) {
    const double at = std::sqrt(0.6);
    const double middle = (top_mm + bottom_mm) / 2;
    const double half = (top_mm - bottom_mm) / 2;
    const auto areaAt = [&](double z) {
        return area(mendedSection(mesh, z, top_mm, bottom_mm, tol, remarks));
    };
    return half * (5 * areaAt(middle - at * half) + 8 * areaAt(middle) + 5 * areaAt(middle + at * half)) / 9;
}

/// The union. Where boundaries that nearly coincide leave it with edges on top of each other, once more
/// with other points to snap to: the result with one of the two, then with coarser points, up to half the
/// gouge budget.
Region soundUnion(const Region& a, const Region& b, const Tolerances& tol) {
    const Region united = unite(a, b, tol);
    if (!diagnose(united)) return united;
    for (const double share : {0.0, 0.2, 0.5}) {
        Tolerances coarser = tol;
        coarser.linear_mm = std::max(tol.linear_mm, share * tol.gouge_mm);
        for (const Region* again : {&a, &b}) {
            const Region repeated = unite(united, *again, coarser);
            if (!diagnose(repeated)) return repeated;
        }
    }
    return united;
}

Region unionOverHeight(const SolidMesh& mesh, double top_mm, double bottom_mm, const Tolerances& tol,
                       std::vector<std::string>& remarks) {
    const std::vector<ProjectedFacet> facets = slopedFacets(mesh, top_mm, bottom_mm);
    const double inset = insetMm(top_mm - bottom_mm, tol);
    const auto at = [&](double z) { return mendedSection(mesh, z, top_mm, bottom_mm, tol, remarks); };
    const Lean lean = leanOf(facets);
    if (lean == Lean::None) return at((top_mm + bottom_mm) / 2);
    const std::size_t remarks_before = remarks.size();
    Region ends;
    if (lean != Lean::Down) ends = at(bottom_mm + inset);
    if (lean != Lean::Up) ends = uniteKeeping(ends, at(top_mm - inset), tol);
    // One-sided walls are widest at one end. Otherwise, or if the section had to be taken elsewhere, the
    // facets show what the ends do not.
    if (lean != Lean::Both && remarks.size() == remarks_before) return ends;
    const Region beyond = facetsBeyond(facets, ends, mesh.chord_mm() + tol.gouge_mm, tol);
    return beyond.empty() ? ends : soundUnion(ends, beyond, tol);
}

}  // namespace

Region uniteKeeping(const Region& a, const Region& b, const Tolerances& tol) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    if (covers(a, b, tol.linear_mm, tol)) return a;
    if (covers(b, a, tol.linear_mm, tol)) return b;
    return soundUnion(a, b, tol);
}

Region mendedSection(const SolidMesh& mesh, double z_mm, double top_mm, double bottom_mm,
                     const Tolerances& tol, std::vector<std::string>& remarks) {
    const double height = top_mm - bottom_mm;
    const double inset = insetMm(height, tol);
    // A quarter of a micrometre first: that needs no remark. Then up to a tenth of the slab.
    for (const double by : {0.0, -0.5 * inset, 0.5 * inset, 0.01 * height, -0.01 * height, 0.03 * height,
                            -0.03 * height, 0.1 * height, -0.1 * height}) {
        const double z = z_mm + by;
        if (z >= top_mm || z <= bottom_mm) continue;
        const std::optional<Region> section = validSection(mesh, z, tol);
        if (!section) continue;
        if (std::abs(by) > inset)
            remarks.push_back(
                fmt::format("section at z {:.4f} mm does not close; taken at z {:.4f} mm", z_mm, z));
        return *section;
    }
    if (const std::optional<Region> section = facetSection(mesh, z_mm)) {
        remarks.push_back(fmt::format("section at z {:.4f} mm does not close; taken from facets of {:.4f} mm",
                                      z_mm, mesh.chord_mm()));
        if (!diagnose(*section)) return *section;
        const Region cleaned = unite(std::span<const Region>(&*section, 1), tol);
        if (!diagnose(cleaned)) return cleaned;
    }
    throw Error(ErrorCode::GeometryKernel, fmt::format("section at z {:.4f} mm", z_mm), "cannot be closed");
}

SlabCut cutSlab(const SolidMesh& mesh, double top_mm, double bottom_mm, const SliceOptions& options,
                const Tolerances& tol) {
    SlabCut cut;
    cut.vertical = allWallsVertical(mesh, top_mm, bottom_mm, options.level_merge_mm);
    if (cut.vertical) {
        cut.region = mendedSection(mesh, (top_mm + bottom_mm) / 2, top_mm, bottom_mm, tol, cut.remarks);
        cut.volume_mm3 = area(cut.region) * (top_mm - bottom_mm);
    } else {
        cut.region = unionOverHeight(mesh, top_mm, bottom_mm, tol, cut.remarks);
        cut.volume_mm3 = volumeBetween(mesh, top_mm, bottom_mm, tol, cut.remarks);
        if (const auto trouble = diagnose(cut.region))
            cut.remarks.push_back(
                fmt::format("union over z {:.4f} .. {:.4f} mm: {}", top_mm, bottom_mm, *trouble));
    }
    return cut;
}

}  // namespace stepmill::layers
