#include "stepmill/plan/reduced_feature.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stepmill/feature/heights.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/drilling.h"

namespace stepmill {
namespace {

std::vector<Standing> standingOf(const std::vector<CutFeature>& ancestors) {
    std::vector<Standing> found;
    for (const CutFeature& cut : ancestors) {
        for (const Residual& residual : *cut.left) {
            // What an ancestor could not take below others lies below what those left, and they are here too.
            if (residual.reason == Reason::BelowStanding) continue;
            // A crumb in the mouth of the next feature is cut with that.
            if (residual.reason == Reason::LeftBetweenPasses && residual.area_mm2 <= kCrumbMm2) continue;
            if (!residual.region.empty()) found.push_back({residual.region, cut.feature->top_z_mm});
        }
    }
    return found;
}

Region unionOf(const std::vector<Standing>& standing, const Tolerances& tol) {
    std::vector<Region> regions;
    regions.reserve(standing.size());
    for (const Standing& one : standing)
        regions.push_back(one.region);
    return regions.empty() ? Region{} : unite(regions, tol);
}

/// Parts the obstacle that goes on over what stands, so that what stands ends where it does.
void partAt(double z_mm, std::vector<Obstacle>& obstacles) {
    const auto over = std::find_if(obstacles.begin(), obstacles.end(), [&](const Obstacle& obstacle) {
        return obstacle.bottom_z_mm + kSameHeightMm < z_mm && z_mm < obstacle.top_z_mm - kSameHeightMm;
    });
    if (over == obstacles.end()) return;
    Obstacle lower = *over;
    lower.top_z_mm = over->bottom_z_mm = z_mm;
    obstacles.insert(over, std::move(lower));
}

/// Adds to every obstacle what stands at its height or above; above the last one a new one.
void raiseObstacles(Feature& feature, std::vector<Standing> standing, const Tolerances& tol) {
    double top_z_mm = feature.obstacles.empty() ? feature.floor_z_mm : feature.obstacles.back().top_z_mm;
    double highest_mm = top_z_mm;
    for (const Standing& one : standing)
        highest_mm = std::max(highest_mm, one.top_z_mm);
    if (highest_mm > top_z_mm) feature.obstacles.push_back({top_z_mm, highest_mm, {}});
    for (const Standing& one : standing)
        if (!one.region.empty()) partAt(one.top_z_mm, feature.obstacles);
    // From the top down, so that what stands over one height is united once for all obstacles below.
    std::sort(standing.begin(), standing.end(),
              [](const Standing& a, const Standing& b) { return a.top_z_mm > b.top_z_mm; });
    Region above;
    std::size_t next = 0;
    for (std::size_t i = feature.obstacles.size(); i-- > 0;) {
        Obstacle& obstacle = feature.obstacles[i];
        std::vector<Region> sections;
        if (!above.empty()) sections.push_back(above);
        for (; next < standing.size() && standing[next].top_z_mm > obstacle.bottom_z_mm; ++next)
            sections.push_back(standing[next].region);
        if (sections.empty()) continue;
        above = sections.size() > 1 ? unite(sections, tol) : sections.front();
        obstacle.section = obstacle.section.empty() ? above : unite(obstacle.section, above, tol);
    }
}

/// A hole with something left over it is no hole: its target is no circle any more. Of a group the others
/// are.
FeatureClass withoutHoles(FeatureClass feature_class, const Region& left) {
    if (isFullCircles(left)) return feature_class;
    if (feature_class == FeatureClass::HoleBlind) return FeatureClass::ClosedPocket;
    if (feature_class == FeatureClass::HoleThrough) return FeatureClass::ThroughPocket;
    return feature_class;
}

std::string namesOf(const std::vector<CutFeature>& parents) {
    std::string names;
    for (const CutFeature& parent : parents) {
        if (parent.left->empty()) continue;
        names += (names.empty() ? "" : ", ") + parent.feature->id;
    }
    return names;
}

struct InTheWay {
    std::vector<Standing> standing;
    std::vector<std::string> names;  ///< each once: a solid's blocks have one
};

/// Fixtures that reach above the feature's floor.
InTheWay inTheWay(const std::vector<Fixture>& fixtures, const Feature& feature) {
    InTheWay found;
    for (const Fixture& fixture : fixtures) {
        if (fixture.top_z_mm <= feature.floor_z_mm + kSameHeightMm) continue;
        found.standing.push_back({fixture.section, fixture.top_z_mm});
        if (std::find(found.names.begin(), found.names.end(), fixture.name) == found.names.end())
            found.names.push_back(fixture.name);
    }
    return found;
}

/// A drill goes below the floor of a through hole, unless a fixture lies there: then it stops at the floor.
void stopAboveFixtures(Feature& feature, const std::vector<Fixture>& fixtures, const Tolerances& tol) {
    if (!feature.through || !isHole(feature.feature_class)) return;
    const double tip_mm = deepestDrillTipZ(feature);
    feature.through = std::none_of(fixtures.begin(), fixtures.end(), [&](const Fixture& fixture) {
        return fixture.bottom_z_mm < feature.floor_z_mm && fixture.top_z_mm > tip_mm &&
               area(intersect(fixture.section, feature.target, tol)) > 0;
    });
}

/// Adds what stands to what the feature's tools keep clear of.
/// \param above  unionOf() it
void keepOff(Feature& feature, const std::vector<Standing>& standing, const Region& above,
             const Tolerances& tol) {
    raiseObstacles(feature, standing, tol);
    feature.obstruction = unite(feature.obstruction, above, tol);
}

/// Adds what stands to what the feature's tools keep clear of, and takes it off the target as a residual.
void keepClear(ReducedFeature& reduced, const std::vector<Standing>& standing, const StayReason& reason,
               const std::string& advice, const Tolerances& tol) {
    if (standing.empty()) return;
    Feature& free = reduced.feature;
    const Region above = unionOf(standing, tol);
    keepOff(free, standing, above, tol);

    Residual blocked;
    blocked.region = intersect(free.target, above, tol);
    blocked.area_mm2 = area(blocked.region);
    if (blocked.area_mm2 <= tol.area_mm2) return;
    Region left = subtract(free.target, above, tol);
    const double left_mm2 = area(left);
    const bool nothing_left = left_mm2 <= tol.area_mm2;
    if (nothing_left) {
        blocked.region = free.target;
        blocked.area_mm2 = free.area_mm2;
    }
    blocked.volume_mm3 = nothing_left ? free.volume_mm3 : blocked.area_mm2 * free.depth_mm();
    blocked.reason = reason;
    blocked.advice = advice;
    free.target = nothing_left ? Region{} : std::move(left);
    free.area_mm2 = nothing_left ? 0 : left_mm2;
    free.volume_mm3 = free.area_mm2 * free.depth_mm();
    free.feature_class = withoutHoles(free.feature_class, free.target);
    reduced.blocked.push_back(std::move(blocked));
}

}  // namespace

Feature beside(Feature feature, const std::vector<Standing>& standing, const Tolerances& tol) {
    if (!standing.empty()) keepOff(feature, standing, unionOf(standing, tol), tol);
    return feature;
}

std::vector<CutFeature> parentsOf(const Feature& feature, const CutById& cut) {
    std::vector<CutFeature> parents;
    for (const std::string& id : feature.parents)
        parents.push_back(cut(id));
    return parents;
}

std::vector<CutFeature> ancestorsOf(const Feature& feature, const CutById& cut) {
    std::vector<CutFeature> found = parentsOf(feature, cut);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const CutFeature& parent : parentsOf(*found[i].feature, cut))
            if (std::none_of(found.begin(), found.end(),
                             [&](const CutFeature& known) { return known.feature == parent.feature; }))
                found.push_back(parent);
    return found;
}

ReducedFeature reduced(const Feature& feature, const std::vector<CutFeature>& parents,
                       const std::vector<CutFeature>& ancestors, const std::vector<Fixture>& fixtures,
                       const Tolerances& tol) {
    ReducedFeature found{feature, {}};
    stopAboveFixtures(found.feature, fixtures, tol);
    const InTheWay held = inTheWay(fixtures, feature);
    keepClear(found, held.standing, {Reason::Fixture, {}},
              fmt::format("another clamping than {}", fmt::join(held.names, ", ")), tol);
    // Where the parents left nothing it comes from farther up.
    const std::string near = namesOf(parents);
    const std::string names = near.empty() ? namesOf(ancestors) : near;
    keepClear(found, standingOf(ancestors), {Reason::BelowStanding, names}, "what " + names + " needs", tol);
    return found;
}

ReducedFeature reduced(const Feature& feature, const CutById& cut, const std::vector<Fixture>& fixtures,
                       const Tolerances& tol) {
    return reduced(feature, parentsOf(feature, cut), ancestorsOf(feature, cut), fixtures, tol);
}

}  // namespace stepmill
