// Equal holes as one feature.

#include "stepmill/feature/hole_group.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "feature/group_holes.h"
#include "stepmill/core/units.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/planar/path_parts.h"

namespace stepmill {
namespace {

/// Circles whose radii differ by less are equal [mm].
constexpr double kEqualRadiusMm = 1e-4;

}  // namespace

bool isFullCircles(const Region& target) {
    if (target.empty() || !std::all_of(target.loops.begin(), target.loops.end(), isFullCircle)) return false;
    const double radius_mm = target.loops.front().segments.front().arc->radius_mm;
    return std::all_of(target.loops.begin(), target.loops.end(), [&](const Loop& loop) {
        return std::abs(loop.segments.front().arc->radius_mm - radius_mm) <= kEqualRadiusMm;
    });
}

std::vector<Vec2> holeCentres(const Feature& feature) {
    std::vector<Vec2> centres;
    for (const Loop& loop : feature.target.loops)
        if (signedArea(loop) > 0) centres.push_back(centroid(Region{{loop}}));  // else something stands in it
    return centres;
}

double radiusOfCircles(const Region& circles) {
    if (circles.empty()) return 0;
    return std::sqrt(area(circles) / static_cast<double>(circles.loops.size()) / kPi);
}

double holeRadiusMm(const Feature& feature) {
    return radiusOfCircles(feature.target);
}

namespace feature {
namespace {

/// Walls no higher than this over a hole's top are in no holder's way [mm].
constexpr double kLowWallMm = 10;
/// Nor are walls farther from its axis than this [mm].
constexpr double kFarWallMm = 30;
/// Holes as near to a wall as others to this are beside the same room [mm].
constexpr double kSameRoomMm = 1;

/// How near to the hole's axis something stands that a holder may meet.
double nearestWallMm(const Feature& hole) {
    const Vec2 axis = holeCentres(hole).front();
    double nearest_mm = kFarWallMm;
    for (const Obstacle& obstacle : hole.obstacles)
        if (obstacle.top_z_mm > hole.top_z_mm + kLowWallMm && !obstacle.section.empty())
            nearest_mm = std::min(nearest_mm, distanceToRegion(obstacle.section, axis));
    return nearest_mm;
}

bool isEqual(const Feature& one, const Feature& other, const Tolerances& tol) {
    if (one.feature_class != other.feature_class || one.parents != other.parents) return false;
    if (one.top_z_mm != other.top_z_mm || one.floor_z_mm != other.floor_z_mm) return false;
    if (std::abs(one.point_mm - other.point_mm) > tol.linear_mm) return false;
    if (std::abs(holeRadiusMm(one) - holeRadiusMm(other)) > kEqualRadiusMm) return false;
    if (std::abs(nearestWallMm(one) - nearestWallMm(other)) > kSameRoomMm) return false;
    return identical(one.obstruction, other.obstruction);
}

/// Every name once.
std::vector<std::string> renamed(const std::vector<std::string>& names,
                                 const std::map<std::string, std::string>& joined) {
    std::vector<std::string> all;
    for (const std::string& name : names) {
        const auto group = joined.find(name);
        const std::string& now = group != joined.end() ? group->second : name;
        if (std::find(all.begin(), all.end(), now) == all.end()) all.push_back(now);
    }
    return all;
}

void add(Feature& group, const Feature& hole) {
    append(group.target, hole.target);
    group.boundary.insert(group.boundary.end(), hole.boundary.begin(), hole.boundary.end());
    group.open_length_mm += hole.open_length_mm;
    group.closed_length_mm += hole.closed_length_mm;
    group.area_mm2 += hole.area_mm2;
    group.volume_mm3 += hole.volume_mm3;
    if (hole.room_below_mm)
        group.room_below_mm =
            std::min(*hole.room_below_mm, group.room_below_mm.value_or(*hole.room_below_mm));
}

}  // namespace

void groupEqualHoles(std::vector<Feature>& features, const Tolerances& tol) {
    std::vector<Feature> grouped;
    std::map<std::string, std::string> joined;  // a hole's id to its group's
    for (Feature& feature : features) {
        feature.parents = renamed(feature.parents, joined);
        const auto equal = std::find_if(grouped.begin(), grouped.end(), [&](const Feature& known) {
            return isHole(feature.feature_class) && isEqual(known, feature, tol);
        });
        if (equal == grouped.end()) {
            grouped.push_back(std::move(feature));
            continue;
        }
        joined[feature.id] = equal->id;
        add(*equal, feature);
    }
    features = std::move(grouped);
}

}  // namespace feature
}  // namespace stepmill
