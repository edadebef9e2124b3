#pragma once

#include <vector>

#include "planar/clearance/site.h"
#include "stepmill/planar/box_tree.h"
#include "stepmill/planar/edge_index.h"

namespace stepmill::clearance {

/// The first site a growing disc touches.
struct Stop {
    double clearance = kNever;
    int site = kNone;
};

/// The sites in their order along the boundary, indexed by their boxes. Queries cost O(log n) on ordinary
/// regions.
class SiteTree {
  public:
    SiteTree() = default;
    /// `outside`: see makeSites().
    SiteTree(const Region& region, bool outside);

    /// First site that stops the disc growing at `contact` on site `own` below the clearance `limit`;
    /// {limit, kNone} when none does. Neighbours at smooth joints and edges on the same circle never do.
    Stop firstStop(int own, const Contact& contact, double limit) const;

    /// Clearance at which `other` stops the disc growing at `contact` on `own`; kNever when it does not.
    double stoppedBySite(int own, const Contact& contact, int other) const;

    /// Distance to the nearest site, at most `limit`.
    double distance(const Vec2& p, double limit = kNever) const;

    const std::vector<Site>& sites() const { return sites_; }

  private:
    bool isFree(const Vec2& p) const;

    EdgeIndex boundary_;
    int free_winding_ = 1;
    std::vector<Site> sites_;
    BoxTree tree_;
};

}  // namespace stepmill::clearance
