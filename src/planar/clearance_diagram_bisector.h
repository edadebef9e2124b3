#pragma once

#include <optional>
#include <vector>

#include "planar/clearance_diagram_sites.h"

namespace stepmill::clearance {

/// Distance from p to the site's full line or circle, positive on that side of it.
double signedDistance(const Site& site, Side side, const Vec2& p);

/// Distance from p to the site itself.
double distanceToSite(const Site& site, const Vec2& p);

/// Point of the site's full line or circle nearest to p.
Vec2 footOn(const Site& site, const Vec2& p);

/// The curve at distance d from a site: a line, or a circle about the site's centre.
struct OffsetCurve {
    bool round = false;
    Vec2 point = Vec2::Zero();  ///< a point of the line; the circle's centre
    Vec2 dir = Vec2::Zero();    ///< of the line, along the site
    double radius = 0;
};
OffsetCurve offsetCurve(const Site& site, Side side, double distance);
Vec2 project(const OffsetCurve& curve, const Vec2& p);

/// The common normal of two sites at the end point they share, where it is their bisector: a corner and its
/// own line or arc, or two that meet tangentially. If they share both ends, the normal that passes nearer.
struct Ray {
    Vec2 from = Vec2::Zero();
    Vec2 normal = Vec2::Zero();  ///< unit, into the side asked for
};
std::optional<Ray> sharedNormal(const SiteSet& set, int p, int q, Side side, const Vec2& near);

/// The line on which the nearest and farthest points of two sites face each other; none for two lines and for
/// concentric circles.
struct Axis {
    Vec2 point = Vec2::Zero();
    Vec2 dir = Vec2::Zero();
};
std::optional<Axis> axisOf(const Site& p, const Site& q);

/// Points where clearance along the bisector of two sites can have its minimum or maximum: half way between
/// facing points of the sites. None for two lines.
std::vector<Vec2> criticalPoints(const Site& p, const Site& q, Side side);

/// The point at that distance from both sites, on the same side of their axis of symmetry as the monotone
/// piece of the bisector from a to b. Nothing for parallel lines and concentric circles.
std::optional<Vec2> equidistantPoint(const Site& p, const Site& q, Side side, double distance, const Vec2& a,
                                     const Vec2& b);

}  // namespace stepmill::clearance
