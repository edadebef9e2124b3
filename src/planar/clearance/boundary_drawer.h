#pragma once

#include "planar/clearance/level.h"
#include "planar/clearance/loop_drawer.h"

namespace stepmill::clearance {

/// Draws stretches of boundary, moved into the free side by a distance.
class BoundaryDrawer {
  public:
    BoundaryDrawer(const Profile& profile, double distance) : sites_(profile.sites()), distance_(distance) {}

    /// The ring's vertex at a place. Its distances to the stop and to the place's own site are equal but for
    /// a few nanometres, because both are rounded and the level steps aside.
    Vec2 pointAt(const Place& place) const;
    /// The boundary from one place to the next in the direction of travel.
    void draw(const Place& from, const Place& to, LoopDrawer& loop) const;
    /// A whole loop of the boundary.
    void drawAll(int first_site, LoopDrawer& loop) const;

  private:
    Vec2 endOf(int index) const;
    void drawSite(int index, double from_u, double to_u, const Vec2& to, LoopDrawer& loop) const;

    const std::vector<Site>& sites_;
    double distance_;
};

/// First site of each loop.
std::vector<int> firstSites(const Profile& profile);

}  // namespace stepmill::clearance
