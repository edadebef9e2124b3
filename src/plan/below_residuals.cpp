#include <algorithm>

#include "plan/plan_steps.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// How the reason of what lies below standing material begins.
constexpr const char* kBelow = "below material that stays in ";

/// Material left by features above, seen from above, and how high it may stand.
struct Standing {
    Region region;
    double top_z_mm = 0;
};

std::vector<Standing> standingOf(const std::vector<const PlannedFeature*>& planned) {
    std::vector<Standing> found;
    for (const PlannedFeature* feature : planned) {
        for (const Residual& residual : feature->sequence.residual) {
            // What an ancestor could not take below others lies below what those left, and they are here too.
            if (residual.reason.starts_with(kBelow)) continue;
            if (!residual.region.empty()) found.push_back({residual.region, feature->feature.top_z_mm});
        }
    }
    return found;
}

Region unionOf(const std::vector<Standing>& standing, const Tolerances& tol) {
    std::vector<Region> regions;
    for (const Standing& one : standing)
        regions.push_back(one.region);
    return regions.empty() ? Region{} : unite(regions, tol);
}

/// Adds to every obstacle what stands at its height or above; above the last one a new one.
void raiseObstacles(Feature& feature, std::vector<Standing> standing, const Tolerances& tol) {
    double top_z_mm = feature.obstacles.empty() ? feature.floor_z_mm : feature.obstacles.back().top_z_mm;
    double highest_mm = top_z_mm;
    for (const Standing& one : standing)
        highest_mm = std::max(highest_mm, one.top_z_mm);
    if (highest_mm > top_z_mm) feature.obstacles.push_back({top_z_mm, highest_mm, {}});
    // From the top down, so that what stands over one height is united once for all obstacles below.
    std::sort(standing.begin(), standing.end(),
              [](const Standing& a, const Standing& b) { return a.top_z_mm > b.top_z_mm; });
    Region above;
    std::size_t next = 0;
    for (auto obstacle = feature.obstacles.rbegin(); obstacle != feature.obstacles.rend(); ++obstacle) {
        std::vector<Region> sections;
        if (!above.empty()) sections.push_back(above);
        for (; next < standing.size() && standing[next].top_z_mm > obstacle->bottom_z_mm; ++next)
            sections.push_back(standing[next].region);
        if (sections.empty()) continue;
        above = sections.size() > 1 ? unite(sections, tol) : sections.front();
        obstacle->section = obstacle->section.empty() ? above : unite(obstacle->section, above, tol);
    }
}

/// A hole with something left over it is no hole: its target is no circle any more.
FeatureClass withoutHoles(FeatureClass feature_class) {
    if (feature_class == FeatureClass::HoleBlind) return FeatureClass::ClosedPocket;
    if (feature_class == FeatureClass::HoleThrough) return FeatureClass::ThroughPocket;
    return feature_class;
}

std::string namesOf(const std::vector<const PlannedFeature*>& parents) {
    std::string names;
    for (const PlannedFeature* parent : parents) {
        if (parent->sequence.residual.empty()) continue;
        names += (names.empty() ? "" : ", ") + parent->feature.id;
    }
    return names;
}

}  // namespace

std::vector<const PlannedFeature*> parentsOf(const Feature& feature, const PlannedById& planned) {
    std::vector<const PlannedFeature*> parents;
    for (const std::string& id : feature.parents)
        parents.push_back(&planned(id));
    return parents;
}

std::vector<const PlannedFeature*> ancestorsOf(const Feature& feature, const PlannedById& planned) {
    std::vector<const PlannedFeature*> found = parentsOf(feature, planned);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const PlannedFeature* parent : parentsOf(found[i]->feature, planned))
            if (std::find(found.begin(), found.end(), parent) == found.end()) found.push_back(parent);
    return found;
}

ReducedFeature belowResiduals(const Feature& feature, const std::vector<const PlannedFeature*>& parents,
                              const std::vector<const PlannedFeature*>& ancestors, const Tolerances& tol) {
    ReducedFeature reduced{feature, std::nullopt};
    const std::vector<Standing> standing = standingOf(ancestors);
    if (standing.empty()) return reduced;
    Feature& free = reduced.feature;
    raiseObstacles(free, standing, tol);
    const Region above = unionOf(standing, tol);
    free.obstruction = unite(free.obstruction, above, tol);

    Residual below;
    below.region = intersect(feature.target, above, tol);
    below.area_mm2 = area(below.region);
    if (below.area_mm2 <= tol.area_mm2) return reduced;
    below.volume_mm3 = below.area_mm2 * feature.depth_mm();
    below.reason = kBelow + namesOf(parents);
    below.advice = "what " + namesOf(parents) + " needs";
    free.target = subtract(feature.target, above, tol);
    free.area_mm2 = area(free.target);
    if (free.area_mm2 <= tol.area_mm2) {
        free.target = {};
        free.area_mm2 = 0;
        below.region = feature.target;
        below.area_mm2 = feature.area_mm2;
        below.volume_mm3 = feature.volume_mm3;
    }
    free.volume_mm3 = free.area_mm2 * free.depth_mm();
    free.feature_class = withoutHoles(free.feature_class);
    reduced.below = std::move(below);
    return reduced;
}

}  // namespace stepmill
