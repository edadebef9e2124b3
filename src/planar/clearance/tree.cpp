#include "planar/clearance/tree.h"

#include <array>

#include "planar/segment.h"

namespace stepmill::clearance {

namespace {

constexpr int kLeafSites = 4;
constexpr std::size_t kDeepest = 64;
/// No disc growing at `contact` touches the box below this clearance: |w|^2 = 2 c (w . n) at the first touch
/// of a point w.
double leastClearance(const Box2& box, const Contact& contact) {
    const double dx = std::max({box.min.x() - contact.foot.x(), contact.foot.x() - box.max.x(), 0.0});
    const double dy = std::max({box.min.y() - contact.foot.y(), contact.foot.y() - box.max.y(), 0.0});
    const double distance2 = dx * dx + dy * dy;
    if (distance2 == 0) return 0;
    const Vec2& n = contact.normal;
    const double ahead = ((n.x() > 0 ? box.max.x() : box.min.x()) - contact.foot.x()) * n.x() +
                         ((n.y() > 0 ? box.max.y() : box.min.y()) - contact.foot.y()) * n.y();
    return ahead <= 0 ? kNever : distance2 / (2 * ahead);
}

double distanceTo(const Box2& box, const Vec2& p) {
    return (box.min - p).cwiseMax(p - box.max).cwiseMax(0.0).norm();
}

}  // namespace

SiteTree::SiteTree(const Region& region, bool outside)
    : region_(region), free_winding_(outside ? 0 : 1), sites_(makeSites(region, outside)) {
    if (!sites_.empty()) build(0, static_cast<int>(sites_.size()));
}

int SiteTree::build(int begin, int end) {
    const int index = static_cast<int>(nodes_.size());
    nodes_.push_back({{}, kNone, begin, end});
    Box2 box;
    if (end - begin <= kLeafSites) {
        for (int i = begin; i < end; ++i) {
            const Box2 own = boxOf(sites_[i]);
            box.add(own.min);
            box.add(own.max);
        }
    } else {
        const int middle = begin + (end - begin) / 2;
        const int left = build(begin, middle);
        const int right = build(middle, end);
        nodes_[index].right = right;
        for (const int child : {left, right}) {
            box.add(nodes_[child].box.min);
            box.add(nodes_[child].box.max);
        }
    }
    nodes_[index].box = box;
    return index;
}

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

/// Is p where discs grow? O(n).
bool SiteTree::isFree(const Vec2& p) const {
    return planar::windingNumber(region_, p) == free_winding_;
}

/// Visits the leaves nearest first, as long as `least(box)` lies below `limit()`, which a visit may lower.
template <typename Least, typename Limit, typename Visit>
void SiteTree::descend(const Least& least, const Limit& limit, const Visit& visit) const {
    if (nodes_.empty()) return;
    struct Pending {
        int node;
        double least;
    };
    std::array<Pending, kDeepest> stack;
    std::size_t size = 0;
    stack[size++] = {0, 0};
    while (size > 0) {
        const Pending next = stack[--size];
        if (next.least >= limit()) continue;
        const Node& node = nodes_[next.node];
        if (node.right == kNone) {
            for (int i = node.begin; i < node.end; ++i)
                visit(i);
            continue;
        }
        Pending near{next.node + 1, least(nodes_[next.node + 1].box)};
        Pending far{node.right, least(nodes_[node.right].box)};
        if (far.least < near.least) std::swap(near, far);
        if (far.least < limit()) stack[size++] = far;
        if (near.least < limit()) stack[size++] = near;
    }
}

Stop SiteTree::firstStop(int own, const Contact& contact, double limit) const {
    Stop best{limit, kNone};
    descend([&](const Box2& box) { return leastClearance(box, contact); }, [&] { return best.clearance; },
            [&](int site) {
                const double clearance = stoppedBySite(own, contact, site);
                if (clearance < best.clearance) best = {clearance, site};
            });
    return best;
}

double SiteTree::distance(const Vec2& p, double limit) const {
    double best = limit;
    descend([&](const Box2& box) { return distanceTo(box, p); }, [&] { return best; },
            [&](int site) { best = std::min(best, clearance::distanceTo(sites_[site], p)); });
    return best;
}

}  // namespace stepmill::clearance
