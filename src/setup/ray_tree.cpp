#include "setup/ray_tree.h"

#include <limits>

namespace stepmill::setup {

namespace {

constexpr int kLeafFacets = 4;
/// Hits nearer than that are the start itself [mm].
constexpr double kStartMm = 1e-9;
/// Sine of the angle between a ray and a facet below which it runs along it: rounding of doubles.
constexpr double kAlong = 1e-12;

Vec3 middleOf(const Facet& facet) {
    return (facet[0] + facet[1] + facet[2]) / 3;
}

/// Distance along the ray to the facet, or infinity [Moeller and Trumbore].
double hitDistance(const Facet& facet, const Vec3& from, const Vec3& direction) {
    constexpr double kMiss = std::numeric_limits<double>::infinity();
    const Vec3 u = facet[1] - facet[0];
    const Vec3 v = facet[2] - facet[0];
    const Vec3 across = direction.cross(v);
    const double det = u.dot(across);
    if (std::abs(det) < kAlong * u.norm() * v.norm()) return kMiss;
    const Vec3 to = from - facet[0];
    const double s = to.dot(across) / det;
    if (s < 0 || s > 1) return kMiss;
    const Vec3 other = to.cross(u);
    const double t = direction.dot(other) / det;
    if (t < 0 || s + t > 1) return kMiss;
    const double along = v.dot(other) / det;
    return along > kStartMm ? along : kMiss;
}

bool meets(const Box3& box, const Vec3& from, const Vec3& inverse, double reach) {
    double enter = 0;
    double leave = reach;
    for (int i = 0; i < 3; ++i) {
        double a = (box.min()[i] - from[i]) * inverse[i];
        double b = (box.max()[i] - from[i]) * inverse[i];
        // On a box' side and parallel to it: 0 times infinity. The ray runs inside that slab.
        if (std::isnan(a) || std::isnan(b)) continue;
        if (a > b) std::swap(a, b);
        enter = std::max(enter, a);
        leave = std::min(leave, b);
    }
    return enter <= leave;
}

}  // namespace

RayTree::RayTree(Facets facets) : facets_(std::move(facets)) {
    nodes_.emplace_back();
    split(0, 0, static_cast<int>(facets_.size()));
}

void RayTree::split(int node, int first, int count) {
    Box3 box;
    Box3 middles;
    for (int i = first; i < first + count; ++i) {
        for (const Vec3& p : facets_[i])
            box.extend(p);
        middles.extend(middleOf(facets_[i]));
    }
    nodes_[node].box = box;
    if (count <= kLeafFacets) {
        nodes_[node].first = first;
        nodes_[node].count = count;
        return;
    }
    Eigen::Index axis = 0;
    middles.sizes().maxCoeff(&axis);
    const int half = count / 2;
    std::nth_element(facets_.begin() + first, facets_.begin() + first + half, facets_.begin() + first + count,
                     [&](const Facet& a, const Facet& b) { return middleOf(a)[axis] < middleOf(b)[axis]; });
    const int children = static_cast<int>(nodes_.size());
    nodes_[node].first = children;
    nodes_.resize(nodes_.size() + 2);
    split(children, first, half);
    split(children + 1, first + half, count - half);
}

template <typename Hit>
void RayTree::walk(const Vec3& from, const Vec3& direction, Hit&& hit) const {
    if (facets_.empty()) return;
    const Vec3 inverse = direction.cwiseInverse();
    std::array<int, 128> stack{};
    int depth = 0;
    double reach = std::numeric_limits<double>::infinity();
    stack[depth++] = 0;
    while (depth > 0) {
        const Node& node = nodes_[stack[--depth]];
        if (!meets(node.box, from, inverse, reach)) continue;
        if (node.count == 0) {
            stack[depth++] = node.first;
            stack[depth++] = node.first + 1;
            continue;
        }
        for (int i = node.first; i < node.first + node.count; ++i) {
            const double at = hitDistance(facets_[i], from, direction);
            if (at >= reach) continue;
            reach = at;
            if (hit(at)) return;
        }
    }
}

bool RayTree::blocked(const Vec3& from, const Vec3& direction) const {
    bool any = false;
    walk(from, direction, [&](double) { return any = true; });
    return any;
}

double RayTree::distance(const Vec3& from, const Vec3& direction) const {
    double nearest = std::numeric_limits<double>::infinity();
    walk(from, direction, [&](double at) {
        nearest = at;
        return false;
    });
    return nearest;
}

}  // namespace stepmill::setup
