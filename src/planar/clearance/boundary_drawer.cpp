#include "planar/clearance/boundary_drawer.h"

#include "planar/segment.h"

namespace stepmill::clearance {

namespace {

/// The contact of the disc around `centre` with the whole line or circle of a site.
Contact facingContact(const Site& site, const Vec2& centre) {
    if (!site.round()) return {centre - (centre - site.start).dot(site.normal) * site.normal, site.normal};
    const Vec2 out = (centre - site.centre).normalized();
    return {site.centre + site.radius * out, site.kind == SiteKind::Concave ? Vec2(-out) : out};
}

/// Two sites of one disc disagree by no more than this about its centre [mm].
constexpr double kGapMm = 10 * kGridMm;

}  // namespace

Vec2 BoundaryDrawer::pointAt(const Place& place) const {
    const Contact contact = contactAt(sites_[place.site], place.u);
    const Vec2 centre = contact.centreAt(distance_);
    if (place.stop < 0 || distance_ == 0) return snapToGrid(centre);
    const Contact facing = facingContact(sites_[place.stop], centre);
    const double missing = distance_ - (centre - facing.foot).dot(facing.normal);
    if (std::abs(missing) > kGapMm) return snapToGrid(centre);  // of another level
    const Vec2 along = leftOf(contact.normal);
    const double gain = facing.normal.dot(along);
    // Where the two meet at a small angle, each keeps its own point.
    constexpr double kLeastGain = 0.1;
    if (std::abs(gain) < kLeastGain) return snapToGrid(centre);
    return snapToGrid(Vec2(centre + missing / gain * along));
}

void BoundaryDrawer::draw(const Place& from, const Place& to, LoopDrawer& loop) const {
    int site = from.site;
    double u = from.u;
    // A run that ends on its own site before it began goes all the way round.
    bool round_trip = to.site == from.site && to.u < from.u;
    while (site != to.site || round_trip) {
        drawSite(site, u, sites_[site].extent, endOf(site), loop);
        site = sites_[site].next;
        u = 0;
        round_trip = false;
    }
    drawSite(site, u, to.u, pointAt(to), loop);
}

void BoundaryDrawer::drawAll(int first_site, LoopDrawer& loop) const {
    loop.start(endOf(sites_[first_site].previous));
    int site = first_site;
    do {
        drawSite(site, 0, sites_[site].extent, endOf(site), loop);
        site = sites_[site].next;
    } while (site != first_site);
}

/// The joint of a site with the next one, moved along their common normal.
Vec2 BoundaryDrawer::endOf(int index) const {
    const Site& site = sites_[index];
    const Site& next = sites_[site.next];
    const Vec2 normal = contactAt(site, site.extent).normal + contactAt(next, 0).normal;
    return distance_ == 0 ? site.end : snapToGrid(Vec2(site.end + distance_ * normal.normalized()));
}

void BoundaryDrawer::drawSite(int index, double from_u, double to_u, const Vec2& to, LoopDrawer& loop) const {
    const Site& site = sites_[index];
    if (!site.round()) {
        loop.lineTo(to, site.edge);
        return;
    }
    const double radius = site.radius + (site.kind == SiteKind::Concave ? -distance_ : distance_);
    const Arc arc{site.centre, snapToGrid(radius), site.turn > 0};
    loop.arcTo(to, arc, to_u - from_u, site.edge);
}

std::vector<int> firstSites(const Profile& profile) {
    std::vector<int> first;
    for (std::size_t i = 0; i < profile.sites().size(); ++i)
        if (profile.sites()[i].loop == static_cast<int>(first.size())) first.push_back(static_cast<int>(i));
    return first;
}

}  // namespace stepmill::clearance
