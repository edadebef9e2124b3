#include "planar/clearance_diagram_check.h"

#include <numeric>

namespace stepmill::clearance {

namespace {

constexpr std::size_t kLeafSites = 4;

Box2 boxOf(const Site& site) {
    Segment segment{site.end, std::nullopt};
    if (site.kind == SiteKind::Arc) segment.arc = Arc{site.centre, site.radius, site.ccw};
    return boundingBox(Path{site.start, {segment}});
}

double squaredDistance(const Box2& box, const Vec2& p) {
    return (box.min - p).cwiseMax(p - box.max).cwiseMax(0.0).squaredNorm();
}

}  // namespace

SiteIndex::SiteIndex(const SiteSet& set) {
    for (const Site& site : set.sites) {
        if (site.kind == SiteKind::Corner) continue;
        sites_.push_back(site);
        boxes_.push_back(boxOf(site));
    }
    if (!sites_.empty()) build(0, sites_.size());
}

/// Halves the sites along the longer side of their box.
int SiteIndex::build(std::size_t begin, std::size_t end) {
    Node node;
    node.begin = begin;
    node.end = end;
    for (std::size_t k = begin; k < end; ++k) {
        node.box.add(boxes_[k].min);
        node.box.add(boxes_[k].max);
    }
    const int index = static_cast<int>(nodes_.size());
    nodes_.push_back(node);
    if (end - begin <= kLeafSites) return index;
    const Eigen::Index axis = node.box.size().x() >= node.box.size().y() ? 0 : 1;
    std::vector<std::size_t> order(end - begin);
    std::iota(order.begin(), order.end(), begin);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return boxes_[a].min[axis] + boxes_[a].max[axis] < boxes_[b].min[axis] + boxes_[b].max[axis];
    });
    std::vector<Site> sites;
    std::vector<Box2> boxes;
    for (std::size_t k : order) {
        sites.push_back(sites_[k]);
        boxes.push_back(boxes_[k]);
    }
    std::copy(sites.begin(), sites.end(), sites_.begin() + static_cast<std::ptrdiff_t>(begin));
    std::copy(boxes.begin(), boxes.end(), boxes_.begin() + static_cast<std::ptrdiff_t>(begin));
    const std::size_t middle = begin + (end - begin) / 2;
    const int left = build(begin, middle), right = build(middle, end);
    nodes_[static_cast<std::size_t>(index)].left = left;
    nodes_[static_cast<std::size_t>(index)].right = right;
    return index;
}

bool SiteIndex::closerThan(const Vec2& p, double distance_mm) const {
    if (nodes_.empty() || distance_mm <= 0) return false;
    const double limit = distance_mm * distance_mm;
    int open[64];
    int count = 0;
    open[count++] = 0;
    while (count > 0) {
        const Node& node = nodes_[static_cast<std::size_t>(open[--count])];
        if (squaredDistance(node.box, p) >= limit) continue;
        if (node.left >= 0) {
            open[count++] = node.left;
            open[count++] = node.right;
            continue;
        }
        for (std::size_t k = node.begin; k < node.end; ++k)
            if (squaredDistance(boxes_[k], p) < limit && distanceToSite(sites_[k], p) < distance_mm)
                return true;
    }
    return false;
}

bool keepDistance(const SiteIndex& index, const std::vector<Loop>& loops, const DistanceBand& band) {
    for (const Loop& loop : loops) {
        Vec2 from = loop.start;
        for (const Segment& segment : loop.segments) {
            for (double share : {0.0, 0.25, 0.5, 0.75}) {
                const Vec2 p = pointAt(from, segment, share);
                if (index.closerThan(p, band.least_mm) || !index.closerThan(p, band.most_mm)) return false;
            }
            from = segment.to;
        }
    }
    return true;
}

}  // namespace stepmill::clearance
