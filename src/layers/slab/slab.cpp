// One solid in one slab.

#include "layers/slab/slab.h"

#include <fmt/format.h>

#include "layers/section/hull_section.h"
#include "layers/section/mended_section.h"
#include "layers/slab/facet_cover.h"
#include "layers/slab/local_boolean.h"
#include "layers/slab/slab_facets.h"
#include "layers/slab/smooth_hulls.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill::layers {

namespace {

/// Sections "at the end" of a slab are cut that far inside it. What leaning walls gain on that height is
/// lost to the obstruction; half the gouge budget at most.
double insetMm(double height_mm, const Tolerances& tol) {
    return std::min(0.5 * tol.gouge_mm, 0.01 * height_mm);
}

/// Walls that run out level are closed over gaps no wider than this: no mill goes in there [mm].
constexpr double kLevelGapMm = 1;
/// Facets this near to level at a slab's bottom are where such walls run out: others close no gap there.
constexpr double kNearlyLevel = 0.95;

bool allWallsVertical(const SolidMesh& mesh, double top_mm, double bottom_mm, double merge_mm) {
    for (const MeshFace& face : mesh.faces()) {
        if (face.vertical || face.horizontal) continue;
        if (face.z_min_mm < top_mm - merge_mm && face.z_max_mm > bottom_mm + merge_mm) return false;
    }
    return true;
}

struct Lean {
    bool up = false;
    bool down = false;
};

Lean leanOf(const std::vector<SlabFacet>& facets) {
    constexpr double kLeast = 1e-7;
    Lean lean;
    for (const SlabFacet& facet : facets) {
        if (facet.thin) continue;
        lean.up = lean.up || facet.normal_z > kLeast;
        lean.down = lean.down || facet.normal_z < -kLeast;
    }
    return lean;
}

class SlabCutter {
  public:
    SlabCutter(const SolidMesh& mesh, double top_mm, double bottom_mm, const Tolerances& tol)
        : mesh_(mesh),
          top_(top_mm),
          bottom_(bottom_mm),
          inset_(insetMm(top_mm - bottom_mm, tol)),
          tol_(tol) {}

    SlabCut vertical() {
        cut_.region = section((top_ + bottom_) / 2).region;
        cut_.volume_mm3 = area(cut_.region) * (top_ - bottom_);
        return std::move(cut_);
    }

    SlabCut leaning() {
        cut_.vertical = false;
        const std::vector<SlabFacet> facets = slopedFacets(mesh_, top_, bottom_);
        cut_.volume_mm3 = volumeInSlab(mesh_, facets, top_, bottom_);
        cut_.leaning = sharesOfFaces(facets);
        cutUnion(facets);
        closeLevelGaps(facets);
        if (cut_.mended_by_mm > 0) {
            cut_.region = smoothHulls(cut_.region, cut_.mended_by_mm, tol_);
            cut_.mended_by_mm *= 2;
        }
        if (const auto trouble = diagnose(cut_.region))
            cut_.remarks.push_back(
                fmt::format("union over z {:.4f} .. {:.4f} mm: {}", top_, bottom_, *trouble));
        return std::move(cut_);
    }

  private:
    MendedSection section(double z_mm) {
        MendedSection cut = mendedSection(mesh_, z_mm, top_, bottom_, inset_, tol_);
        if (!cut.remark.empty()) cut_.remarks.push_back(cut.remark);
        cut_.mended_by_mm = std::max(cut_.mended_by_mm, cut.exceeds_mm);
        return cut;
    }

    void cutUnion(const std::vector<SlabFacet>& facets) {
        const Lean lean = leanOf(facets);
        if (!lean.up && !lean.down) {
            cut_.region = section((top_ + bottom_) / 2).region;
            return;
        }
        if (lean.up) addBottom(facets);
        if (lean.down) addTop(facets);
        if (!lean.up || !lean.down) return;
        // Between the two sections, or facets would reach out by what walls lean over the inset.
        addFacets(facetsOverEnds(slopedFacets(mesh_, top_ - inset_, bottom_ + inset_)), top_ - inset_,
                  bottom_ + inset_);
    }

    /// Material that reaches down to the bottom. A section taken farther inside misses what ends below it,
    /// under facets looking up.
    void addBottom(const std::vector<SlabFacet>& facets) {
        const MendedSection end = section(bottom_ + inset_);
        cut_.region = uniteLocally(cut_.region, end.region, tol_);
        if (!end.moved) return;
        std::vector<SlabFacet> missed;
        std::copy_if(facets.begin(), facets.end(), std::back_inserter(missed),
                     [&](const SlabFacet& facet) { return facet.normal_z >= 0 && facet.low_mm < end.z_mm; });
        addFacets(missed, end.z_mm, bottom_);
    }

    /// Material that reaches up to the top. A section taken farther inside misses what ends above it, over
    /// facets looking down.
    void addTop(const std::vector<SlabFacet>& facets) {
        const MendedSection end = section(top_ - inset_);
        cut_.region = uniteLocally(cut_.region, end.region, tol_);
        if (!end.moved) return;
        std::vector<SlabFacet> missed;
        std::copy_if(facets.begin(), facets.end(), std::back_inserter(missed),
                     [&](const SlabFacet& facet) { return facet.normal_z <= 0 && facet.high_mm > end.z_mm; });
        addFacets(missed, top_, end.z_mm);
    }

    void addFacets(const std::vector<SlabFacet>& facets, double top_mm, double bottom_mm) {
        const Region beyond = facetsBeyond(mesh_, facets, cut_.region, top_mm, bottom_mm, tol_);
        if (beyond.empty()) return;
        cut_.mended_by_mm = std::max(cut_.mended_by_mm, 2 * mesh_.chord_mm());
        cut_.region = uniteLocally(cut_.region, beyond, tol_);
    }

    /// At the bottom of a round groove its walls meet; half a micrometre over it they are a tenth of a
    /// millimetre apart, over all the groove's length.
    void closeLevelGaps(const std::vector<SlabFacet>& facets) {
        std::vector<Region> level;
        std::vector<Region> near;
        for (const SlabFacet& facet : facets) {
            if (facet.thin || facet.normal_z < kNearlyLevel || facet.low_mm > bottom_ + inset_) continue;
            Region plan = grownHull({facet.corner.begin(), facet.corner.begin() + facet.corners}, 0);
            if (plan.empty()) continue;
            const Box2 box = grown(boundingBox(plan), kLevelGapMm);
            level.push_back(std::move(plan));
            near.push_back(makeRectangle(box.min(), box.max()));
        }
        if (level.empty()) return;
        const Region walls = intersect(cut_.region, unite(near, tol_), tol_);
        const Region closed = offset(offset(walls, kLevelGapMm / 2, tol_), -kLevelGapMm / 2, tol_);
        const Region gaps = intersect(subtract(closed, walls, tol_), unite(level, tol_), tol_);
        if (!gaps.empty()) cut_.region = uniteLocally(cut_.region, gaps, tol_);
    }

    const SolidMesh& mesh_;
    double top_;
    double bottom_;
    double inset_;
    const Tolerances& tol_;
    SlabCut cut_;
};

}  // namespace

SlabCut cutSlab(const SolidMesh& mesh, double top_mm, double bottom_mm, const SliceOptions& options,
                const Tolerances& tol) {
    SlabCutter cutter(mesh, top_mm, bottom_mm, tol);
    return allWallsVertical(mesh, top_mm, bottom_mm, options.level_merge_mm) ? cutter.vertical()
                                                                             : cutter.leaning();
}

}  // namespace stepmill::layers
