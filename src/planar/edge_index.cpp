#include "stepmill/planar/edge_index.h"

#include <algorithm>

namespace stepmill {

namespace {

std::vector<Box2> boxesOf(const std::vector<Edge>& edges) {
    std::vector<Box2> boxes;
    boxes.reserve(edges.size());
    for (const Edge& edge : edges)
        boxes.push_back(edge.box);
    return boxes;
}

const Vec2& extentOf(const Vec2& p) {
    return p;
}
const Box2& extentOf(const Edge& edge) {
    return edge.box;
}

}  // namespace

EdgeIndex::EdgeIndex(std::vector<Edge> edges) : edges_(std::move(edges)), tree_(boxesOf(edges_)) {}

EdgeIndex::EdgeIndex(const Path& path) : EdgeIndex(edgesOf(path)) {}

EdgeIndex::EdgeIndex(const Region& region) : EdgeIndex(edgesOf(region)) {}

/// The least distance below the limit; with `first_will_do` the first one found below it.
template <typename Shape, typename Distance>
double EdgeIndex::least(const Shape& shape, const Distance& distance, double limit_mm,
                        bool first_will_do) const {
    double found = limit_mm;
    const auto limit = [&] { return first_will_do && found < limit_mm ? 0 : found; };
    tree_.nearestBelow([&](const Box2& box) { return box.exteriorDistance(extentOf(shape)); }, limit,
                       [&](std::size_t i) { found = std::min(found, distance(edges_[i])); });
    return found;
}

double EdgeIndex::distanceTo(const Vec2& p, double limit_mm) const {
    return least(
        p, [&](const Edge& edge) { return stepmill::distanceTo(p, edge); }, limit_mm, false);
}

double EdgeIndex::distanceTo(const Edge& edge, double limit_mm) const {
    return least(
        edge, [&](const Edge& other) { return separation(edge, other); }, limit_mm, false);
}

bool EdgeIndex::anyNearer(const Vec2& p, double distance_mm) const {
    const auto distance = [&](const Edge& edge) { return stepmill::distanceTo(p, edge); };
    return least(p, distance, distance_mm, true) < distance_mm;
}

bool EdgeIndex::anyNearer(const Edge& edge, double distance_mm) const {
    const auto distance = [&](const Edge& other) { return separation(edge, other); };
    return least(edge, distance, distance_mm, true) < distance_mm;
}

std::vector<double> sharesWhereMet(const Edge& edge, const EdgeIndex& others) {
    std::vector<double> shares{0, 1};
    others.forEachIn(grown(edge.box, kGridMm), [&](const Edge& other) {
        for (const Vec2& p : meetingPoints(edge, other))
            shares.push_back(shareOf(edge, p));
    });
    std::sort(shares.begin(), shares.end());
    return shares;
}

}  // namespace stepmill
