#pragma once

#include <vector>

#include "planar/clearance/site.h"

namespace stepmill::clearance {

/// The first site a growing disc touches.
struct Stop {
    double clearance = kNever;
    int site = kNone;
};

/// Box tree over the sites in their order along the boundary. Queries cost O(log n) on ordinary regions.
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
    struct Node {
        Box2 box;
        int right = kNone;  ///< the left child follows its parent; kNone: a leaf
        int begin = 0;
        int end = 0;
    };
    int build(int begin, int end);
    bool isFree(const Vec2& p) const;
    template <typename Least, typename Limit, typename Visit>
    void descend(const Least& least, const Limit& limit, const Visit& visit) const;

    Region region_;
    int free_winding_ = 1;
    std::vector<Site> sites_;
    std::vector<Node> nodes_;
};

}  // namespace stepmill::clearance
