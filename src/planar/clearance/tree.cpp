#include "planar/clearance/tree.h"

#include <algorithm>

#include "planar/segment.h"

namespace stepmill::clearance {

namespace {

/// The disc that has grown to some clearance at a contact.
class Disc {
  public:
    Disc(const Contact& contact, double clearance)
        : foot_(contact.foot), centre_(clearance * contact.normal), clearance_(clearance) {}

    /// Does the disc touch the box? |w|^2 < 2 c (w . n) for a point w seen from the foot; the least of
    /// |w|^2 - 2 c (w . n) is found along each axis on its own.
    bool touches(const Box2& box) const {
        const Vec2 nearest = centre_.cwiseMax(box.min() - foot_).cwiseMin(box.max() - foot_);
        return nearest.dot(nearest - 2 * centre_) < 0;
    }
    /// Does the disc lie clear of the whole carrier of a line, or its foot behind it? Then no point of the
    /// line stops the disc. Of arcs nothing is said.
    bool clearsLine(const Site& site) const {
        if (site.round()) return false;
        const double height = (foot_ - site.start).dot(site.normal);
        return height + centre_.dot(site.normal) > clearance_ + kTouchMm || height < -2 * kOverlapMm;
    }

  private:
    Vec2 foot_;
    Vec2 centre_;  // seen from the foot
    double clearance_;
};

/// No disc growing at `contact` touches the box below this clearance: |w|^2 = 2 c (w . n) at the first touch
/// of a point w.
double leastClearance(const Box2& box, const Contact& contact) {
    const double dx = std::max({box.min().x() - contact.foot.x(), contact.foot.x() - box.max().x(), 0.0});
    const double dy = std::max({box.min().y() - contact.foot.y(), contact.foot.y() - box.max().y(), 0.0});
    const double distance2 = dx * dx + dy * dy;
    if (distance2 == 0) return 0;
    const Vec2& n = contact.normal;
    const double ahead = ((n.x() > 0 ? box.max().x() : box.min().x()) - contact.foot.x()) * n.x() +
                         ((n.y() > 0 ? box.max().y() : box.min().y()) - contact.foot.y()) * n.y();
    return ahead <= 0 ? kNever : distance2 / (2 * ahead);
}

std::vector<Box2> boxesOf(const std::vector<Site>& sites) {
    std::vector<Box2> boxes;
    boxes.reserve(sites.size());
    for (const Site& site : sites)
        boxes.push_back(boxOf(site));
    return boxes;
}

}  // namespace

SiteTree::SiteTree(const Region& region, bool outside)
    : boundary_(region),
      free_winding_(outside ? 0 : 1),
      sites_(makeSites(region, outside)),
      tree_(boxesOf(sites_)) {}

double SiteTree::stoppedBySite(int own_index, const Contact& contact, int other_index) const {
    const Site& own = sites_[own_index];
    const Site& other = sites_[other_index];
    if (other_index == own_index) return kNever;
    if (other_index == own.next && !own.sharp_end) return kNever;
    if (other_index == own.previous && !own.sharp_start) return kNever;
    const bool same_circle = own.round() && own.kind == other.kind && own.centre == other.centre &&
                             own.radius == other.radius && own.kind != SiteKind::Corner;
    if (same_circle) return kNever;
    const Meeting meeting = meetingOf(other, contact, own);
    if (meeting.clearance == kNever || meeting.height > kTouchMm) return meeting.clearance;
    // The edges of a convex corner meet at a point, whatever their heights say there.
    if (other_index == own.next || other_index == own.previous) return meeting.clearance;
    const bool round_the_corner = (own.corner_end && other_index == sites_[own.next].next) ||
                                  (own.corner_start && other_index == sites_[own.previous].previous);
    // Boundaries that touch at an angle leave no room for a disc; side by side they may be a thin wall's.
    if (!meeting.back_to_back && !round_the_corner)
        return meeting.height >= -kTouchMm ? meeting.clearance : kNever;
    return isFree(contact.centreAt(2 * kOverlapMm)) ? kNever : meeting.clearance;
}

/// Is p where discs grow? The winding number is told by the edges that a ray along +x comes near.
bool SiteTree::isFree(const Vec2& p) const {
    int winding = 0;
    const Vec2 end(std::max(boundary_.box().max().x(), p.x()), p.y());
    boundary_.forEachIn(grown(Box2(p, end), kTouchMm), [&](const Edge& edge) {
        winding += planar::windingShare(edge.from, edge.segment, p);
    });
    return winding == free_winding_;
}

Stop SiteTree::firstStop(int own, const Contact& contact, double limit) const {
    Stop best{limit, kNone};
    Disc disc(contact, limit);
    tree_.nearestFirst([&](const Box2& box) { return leastClearance(box, contact); },
                       [&](const Box2& box) { return disc.touches(box); },
                       [&](std::size_t i) {
                           if (disc.clearsLine(sites_[i])) return;
                           const int site = static_cast<int>(i);
                           const double clearance = stoppedBySite(own, contact, site);
                           if (clearance >= best.clearance) return;
                           best = {clearance, site};
                           disc = Disc(contact, clearance);
                       });
    return best;
}

double SiteTree::distance(const Vec2& p, double limit) const {
    double best = limit;
    tree_.nearestBelow([&](const Box2& box) { return box.exteriorDistance(p); }, [&] { return best; },
                       [&](std::size_t site) { best = std::min(best, distanceTo(sites_[site], p)); });
    return best;
}

}  // namespace stepmill::clearance
