// Ground that nested features share, as a feature of its own.

#include "stepmill/plan/common_ground.h"

#include <algorithm>
#include <cmath>

#include "stepmill/access/slivers.h"
#include "stepmill/core/error.h"
#include "stepmill/feature/describe_boundary.h"
#include "stepmill/feature/heights.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/plan/reduced_feature.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

std::vector<Feature>::const_iterator find(const std::vector<Feature>& features, const std::string& id) {
    return std::find_if(features.begin(), features.end(),
                        [&](const Feature& feature) { return feature.id == id; });
}

bool endsAbove(const CommonGround& ground, const Feature& level) {
    return ground.floor_z_mm > level.floor_z_mm + kSameWrittenHeightMm;
}

/// What a level keeps below ground that takes all of it down to there.
Feature belowGround(Feature level, double ground_floor_z_mm) {
    const double depth_mm = level.depth_mm();
    level.top_z_mm = ground_floor_z_mm;
    level.volume_mm3 *= level.depth_mm() / depth_mm;
    return level;
}

/// What a level keeps beside the ground.
Feature besideGround(Feature level, const Region& ground, const Tolerances& tol) {
    const double before_mm2 = level.area_mm2;
    level.target = access::withoutSliverComponents(subtract(level.target, ground, tol), tol);
    level.area_mm2 = area(level.target);
    level.volume_mm3 *= before_mm2 > 0 ? level.area_mm2 / before_mm2 : 0;
    if (!level.target.empty()) describeBoundary(level, tol);
    return level;
}

/// The ground as a feature.
/// \param levels  before it was taken out
/// \param kept  what they keep
Feature groundFeature(const CommonGround& ground, const std::vector<Feature>& levels,
                      const std::vector<Feature>& kept, const Tolerances& tol) {
    Feature feature = levels.back();
    feature.id = ground.id;
    feature.band.reset();
    feature.ground_of = ground.levels;
    feature.parents = levels.front().parents;
    feature.top_z_mm = levels.front().top_z_mm;
    if (endsAbove(ground, levels.back())) {
        feature.floor_z_mm = ground.floor_z_mm;
        feature.through = false;
    }
    feature.target = ground.region;
    feature.area_mm2 = area(ground.region);
    feature.volume_mm3 = 0;
    std::vector<Standing> standing;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        feature.volume_mm3 += levels[i].volume_mm3 - kept[i].volume_mm3;
        const Region around = subtract(levels[i].target, ground.region, tol);
        if (!around.empty()) standing.push_back({around, levels[i].top_z_mm});
    }
    feature = beside(std::move(feature), standing, tol);
    describeBoundary(feature, tol);
    return feature;
}

/// Replaces parents that are gone by what stands in for them.
void replaceParent(std::vector<std::string>& parents, const std::string& gone,
                   const std::vector<std::string>& by) {
    const auto found = std::find(parents.begin(), parents.end(), gone);
    if (found == parents.end()) return;
    parents.erase(found);
    for (const std::string& id : by)
        if (std::find(parents.begin(), parents.end(), id) == parents.end()) parents.push_back(id);
}

}  // namespace

bool isCommonGround(const std::vector<Feature>& features, const CommonGround& ground, const Tolerances& tol) {
    if (feature::isSliver(ground.region, tol)) return false;
    if (ground.levels.empty()) return false;
    std::string above;
    for (const std::string& id : ground.levels) {
        const auto level = find(features, id);
        if (level == features.end()) return false;
        if (!above.empty()) {
            const auto parent = find(features, above);
            if (level->parents != std::vector<std::string>{above}) return false;
            if (std::abs(parent->floor_z_mm - level->top_z_mm) > kSameWrittenHeightMm) return false;
        }
        const Region outside = subtract(ground.region, level->target, tol);
        if (!feature::isSliver(outside, tol)) return false;
        above = id;
    }
    const auto last = find(features, above);
    const bool takes_all = feature::isSliver(subtract(last->target, ground.region, tol), tol);
    if (endsAbove(ground, *last))
        return takes_all && ground.floor_z_mm < last->top_z_mm - kSameWrittenHeightMm;
    return ground.levels.size() > 1 || !takes_all;
}

std::vector<Feature> withCommonGround(std::vector<Feature> features, const CommonGround& ground,
                                      const Tolerances& tol) {
    std::vector<Feature> levels;
    std::vector<Feature> kept;
    for (const std::string& id : ground.levels) {
        const auto level = find(features, id);
        STEPMILL_CHECK(level != features.end(), "the levels of common ground are features");
        levels.push_back(*level);
        const bool goes_on_below = id == ground.levels.back() && endsAbove(ground, *level);
        kept.push_back(goes_on_below ? belowGround(*level, ground.floor_z_mm)
                                     : besideGround(*level, ground.region, tol));
    }
    std::vector<Feature> result;
    for (Feature& feature : features) {
        const auto level = std::find(ground.levels.begin(), ground.levels.end(), feature.id);
        if (level == ground.levels.end()) {
            result.push_back(std::move(feature));
            continue;
        }
        const auto i = static_cast<std::size_t>(level - ground.levels.begin());
        if (i == 0) {
            result.push_back(groundFeature(ground, levels, kept, tol));
            kept[0].parents = {ground.id};
        }
        if (!kept[i].target.empty()) result.push_back(kept[i]);
    }
    for (std::size_t i = 0; i < kept.size(); ++i) {
        if (!kept[i].target.empty()) continue;
        for (std::size_t below = i + 1; below < kept.size(); ++below)
            replaceParent(kept[below].parents, kept[i].id, kept[i].parents);
        for (Feature& feature : result)
            replaceParent(feature.parents, kept[i].id, kept[i].parents);
    }
    return result;
}

}  // namespace stepmill
