#pragma once

#include <limits>
#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill::clearance {

inline constexpr double kNever = std::numeric_limits<double>::infinity();
inline constexpr int kNone = -1;

/// A boundary point that lies behind an edge by no more than this touches it. Edges of a region may overlap
/// by Tolerances::linear_mm, because Booleans take curves that close for one curve [mm].
inline constexpr double kOverlapMm = 1e-4;
/// A ring or a disc may come nearer to the boundary than asked by this much: half of kOverlapMm, a twentieth
/// of Tolerances::gouge_mm [mm].
inline constexpr double kNearerMm = kOverlapMm / 2;
/// Points closer than this count as one: rounding of end points and centres may part them so far [mm].
inline constexpr double kTouchMm = 2 * kGridMm;

enum class SiteKind {
    Line,
    Concave,  ///< arc seen from within its circle: a pocket's corner
    Convex,   ///< arc seen from outside: an island
    Corner    ///< reflex corner: a convex arc of radius zero
};

/// One edge of the boundary, seen from the side its discs grow to: the left of the direction of travel.
/// A point of it is named by a parameter u in [0, extent]: millimetres along a line, radians along an arc
/// or around a corner.
struct Site {
    SiteKind kind = SiteKind::Line;
    int edge = kNone;  ///< edge of the region, numbered through all loops; the one before for a corner
    int loop = 0;
    Vec2 start = Vec2::Zero();
    Vec2 end = Vec2::Zero();
    double extent = 0;
    Vec2 direction = Vec2::Zero();  ///< of a line
    Vec2 normal = Vec2::Zero();     ///< of a line, to its left
    Vec2 centre = Vec2::Zero();     ///< of an arc; of a corner the corner
    double radius = 0;
    double start_angle = 0;
    double turn = 1;                ///< +1: counter-clockwise
    Vec2 first_ray = Vec2::Zero();  ///< unit vectors from the centre to both ends of an arc
    Vec2 last_ray = Vec2::Zero();
    int previous = 0;  ///< neighbours in the loop
    int next = 0;
    bool corner_start = false;  ///< the neighbour is a reflex corner, a site of its own
    bool corner_end = false;
    bool sharp_start = false;  ///< convex corner: nothing fits there
    bool sharp_end = false;

    bool round() const { return kind != SiteKind::Line; }
};

/// Where a disc touches the boundary and which way it grows.
struct Contact {
    Vec2 foot;
    Vec2 normal;

    Vec2 centreAt(double clearance) const { return foot + clearance * normal; }
};

Contact contactAt(const Site& site, double u);

/// How far around an arc or a corner a ray from its centre lies past the first one, in (-pi, pi].
double turnedTo(const Site& arc, const Vec2& ray_mm);

/// Parameter of the point of the site nearest to p, within [0, extent].
double parameterOf(const Site& site, const Vec2& p);

/// How `site` stops the disc that grows at a contact on another one.
struct Meeting {
    double clearance = kNever;  ///< radius at the first touch from the site's free side; kNever without one
    /// Height of the disc's foot over the site. Behind it by up to kOverlapMm the clearance is 0: either the
    /// two edges overlap, or they are the sides of a thin wall and do not meet at all.
    double height = kNever;
    /// Do the disc and the site's free side point away from each other, as the sides of a thin wall do?
    bool back_to_back = false;
};

/// The ends of `site` stop the disc too, so that no disc slips through a joint that rounding has opened. Ends
/// that are reflex corners, sites of their own, or ends of `own` are left out.
Meeting meetingOf(const Site& site, const Contact& contact, const Site& own);

/// Distance from p to the site.
double distanceTo(const Site& site, const Vec2& p);

Box2 boxOf(const Site& site);

/// The boundary as sites, loop by loop in the order of travel, reflex corners between their edges. Arcs
/// beyond a half circle become two sites. `outside`: seen from the other side, each loop reversed.
std::vector<Site> makeSites(const Region& region, bool outside);

}  // namespace stepmill::clearance
