// Two sets of loops cut into pieces that meet at nodes only.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "planar/boolean/arrangement.h"
#include "planar/boolean/curve_pairs.h"
#include "planar/intersection.h"
#include "planar/segment.h"
#include "stepmill/core/units.h"

namespace stepmill::planar {

namespace {

/// A curve is cut at a node.
struct Cut {
    int curve;
    double share;
    int node;
};

/// A curve moved to the nodes of its ends.
struct Stretch {
    Vec2 from;
    Segment segment;
};

/// Finds the node near a point, or makes one. Nodes lie in square cells, and cells in buckets: lists linked
/// through the nodes, since a list of its own for every cell would cost more than all that is looked up.
class NodeIndex {
  public:
    NodeIndex(std::vector<Vec2>& nodes, double snap_mm, std::size_t expected)
        : nodes_(nodes), snap_mm_(snap_mm), last_in_(std::bit_ceil(2 * expected + 1), kNone) {}

    int add(const Vec2& p) {
        int nearest = kNone;
        double distance = snap_mm_;
        const std::int64_t x0 = cell(p.x() - snap_mm_), x1 = cell(p.x() + snap_mm_);
        const std::int64_t y0 = cell(p.y() - snap_mm_), y1 = cell(p.y() + snap_mm_);
        for (std::int64_t x = x0; x <= x1; ++x)
            for (std::int64_t y = y0; y <= y1; ++y)
                for (int node = last_in_[bucket(x, y)]; node != kNone; node = before_[at(node)]) {
                    const double d = (nodes_[at(node)] - p).norm();
                    if (d > distance || (d == distance && nearest != kNone && nearest < node)) continue;
                    nearest = node;
                    distance = d;
                }
        if (nearest != kNone) return nearest;
        nodes_.push_back(snapToGrid(p));
        const int node = static_cast<int>(nodes_.size()) - 1;
        before_.push_back(std::exchange(last_in_[bucket(cell(p.x()), cell(p.y()))], node));
        return node;
    }

  private:
    static constexpr int kNone = -1;

    std::int64_t cell(double value) const {
        return static_cast<std::int64_t>(std::floor(value / (4 * snap_mm_)));
    }
    std::size_t bucket(std::int64_t x, std::int64_t y) const {
        const std::uint64_t key = (static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15ULL) ^
                                  (static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4FULL);
        return static_cast<std::size_t>(key >> 32) & (last_in_.size() - 1);
    }

    std::vector<Vec2>& nodes_;
    double snap_mm_;
    std::vector<int> last_in_;  // of each bucket, its last node
    std::vector<int> before_;   // of each node, the one before it in its bucket
};

/// Points sorted along x and along y: those in a long thin box are found along its short side.
class NodesInBox {
  public:
    explicit NodesInBox(const std::vector<Vec2>& nodes) : nodes_(nodes) {
        for (const int axis : {0, 1}) {
            std::vector<std::pair<double, int>>& list = sorted_[at(axis)];
            list.reserve(nodes.size());
            for (std::size_t i = 0; i < nodes.size(); ++i)
                list.emplace_back(nodes[i][axis], static_cast<int>(i));
            std::sort(list.begin(), list.end());
        }
    }

    template <typename Visit>
    void forEachIn(const Box2& box, Visit visit) const {
        const int axis = box.sizes().x() <= box.sizes().y() ? 0 : 1;
        const int across = 1 - axis;
        const std::vector<std::pair<double, int>>& list = sorted_[at(axis)];
        auto it = std::lower_bound(list.begin(), list.end(), std::pair{box.min()[axis], 0});
        for (; it != list.end() && it->first <= box.max()[axis]; ++it) {
            const double y = nodes_[at(it->second)][across];
            if (y >= box.min()[across] && y <= box.max()[across]) visit(it->second);
        }
    }

  private:
    const std::vector<Vec2>& nodes_;
    std::array<std::vector<std::pair<double, int>>, 2> sorted_;
};

/// The nodes at which the curves are cut, curve by curve.
class Cuts {
  public:
    explicit Cuts(std::size_t curves) : last_(curves, kNone) {}

    bool has(int curve, int node) const {
        for (int i = last_[at(curve)]; i != kNone; i = before_[at(i)])
            if (cuts_[at(i)].node == node) return true;
        return false;
    }
    void add(int curve, double share, int node) {
        before_.push_back(std::exchange(last_[at(curve)], static_cast<int>(cuts_.size())));
        cuts_.push_back({curve, share, node});
    }
    /// All of them in the order of the curves and along each.
    std::vector<Cut> inOrder() && {
        std::stable_sort(cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) {
            return a.curve != b.curve ? a.curve < b.curve : a.share < b.share;
        });
        return std::move(cuts_);
    }

  private:
    static constexpr int kNone = -1;

    std::vector<Cut> cuts_;
    std::vector<int> before_;  // the cut of the same curve that was added before
    std::vector<int> last_;
};

/// Cuts curves at each other and makes pieces of them.
class CurveNoder {
  public:
    CurveNoder(const std::vector<Curve>& curves, double snap_mm) : snap_mm_(snap_mm) {
        result_.curves = curves;
    }

    Arrangement run() && {
        addPieces(cutsOfCurves());
        result_.setCancelledApart();
        return std::move(result_);
    }

  private:
    std::vector<Cut> cutsOfCurves();
    Stretch betweenNodes(const Curve& curve, int begin, int end) const;
    void addPieces(const std::vector<Cut>& cuts);
    void addPiece(int begin, int end, int curve);

    double snap_mm_;
    Arrangement result_;
    std::vector<int> first_at_;  // the first piece at its lower node
    std::vector<int> next_at_;   // of each piece, the next one at its lower node
};

std::vector<Cut> CurveNoder::cutsOfCurves() {
    NodeIndex index(result_.nodes, snap_mm_, result_.curves.size());
    Cuts cuts(result_.curves.size());
    std::vector<Stretch> snapped;  // the curves between the nodes of their ends
    snapped.reserve(result_.curves.size());
    for (std::size_t i = 0; i < result_.curves.size(); ++i) {
        const int begin = index.add(result_.curves[i].from), end = index.add(result_.curves[i].to());
        cuts.add(static_cast<int>(i), 0, begin);
        cuts.add(static_cast<int>(i), 1, end);
        snapped.push_back(betweenNodes(result_.curves[i], begin, end));
    }
    const auto cut = [&](int curve, int node) {
        if (cuts.has(curve, node)) return;
        const Stretch& c = snapped[at(curve)];
        const double share = shareOf(result_.nodes[at(node)], c.from, c.segment);
        if (share > 0 && share < 1) cuts.add(curve, share, node);
    };
    for (const auto& [i, j] : overlappingBoxes(result_.curves, snap_mm_)) {
        const Curve& a = result_.curves[at(i)];
        const Curve& b = result_.curves[at(j)];
        const bool neighbours = adjacent(a, b);
        for (const Vec2& p : contacts(a, b, snap_mm_)) {
            if (neighbours && !crossesBesideCorner(a, b, p)) continue;
            const int node = index.add(p);
            cut(i, node);
            cut(j, node);
        }
    }
    // A curve passes through every node within the snapping distance, its own or not. Otherwise two curves
    // that snapped onto each other could be cut at different nodes, and their pieces would lie on each other
    // without being one.
    const NodesInBox nodes(result_.nodes);
    for (std::size_t i = 0; i < result_.curves.size(); ++i) {
        const Curve& c = result_.curves[i];
        const Stretch& bent = snapped[i];
        nodes.forEachIn(grown(c.box, 2 * snap_mm_), [&](int node) {
            if (cuts.has(static_cast<int>(i), node)) return;
            const Vec2& p = result_.nodes[at(node)];
            if (distanceTo(p, c) <= snap_mm_ || distanceTo(p, bent.from, bent.segment) <= snap_mm_)
                cut(static_cast<int>(i), node);
        });
    }
    return std::move(cuts).inOrder();
}

void CurveNoder::addPieces(const std::vector<Cut>& cuts) {
    first_at_.assign(result_.nodes.size(), -1);
    for (std::size_t k = 1; k < cuts.size(); ++k)
        if (cuts[k].curve == cuts[k - 1].curve) addPiece(cuts[k - 1].node, cuts[k].node, cuts[k].curve);
}

Stretch CurveNoder::betweenNodes(const Curve& curve, int begin, int end) const {
    const Segment bent{result_.node(end), curve.segment.arc};
    // Snapping can turn a short arc about its centre the wrong way, and short curves into points.
    const bool turned = bent.arc && sweepsMoreThan(1.5 * kPi, result_.node(begin), bent.to, *bent.arc);
    if (begin == end || turned) return {curve.from, curve.segment};
    return {result_.node(begin), bent};
}

void CurveNoder::addPiece(int begin, int end, int curve) {
    // Shorter than the snapping distance: a point.
    if (begin == end) return;
    Piece piece{begin, end, curve, true, false, {}, -1};
    const std::optional<Arc>& arc = result_.curves[at(curve)].segment.arc;
    // Snapping can turn the ends of a short arc about its centre until the arc seems to go all the way round.
    piece.straight = arc && sweepsMoreThan(1.5 * kPi, result_.node(begin), result_.node(end), *arc);
    const Vec2 middle = pointAt(result_.node(begin), result_.segment(piece), 0.5);
    const int operand = result_.curves[at(curve)].operand;
    int* link = &first_at_[at(std::min(begin, end))];
    for (; *link >= 0; link = &next_at_[at(*link)]) {
        Piece& other = result_.pieces[at(*link)];
        const bool same_way = other.begin == begin && other.end == end;
        const bool other_way = other.begin == end && other.end == begin;
        if (!same_way && !other_way) continue;
        if ((pointAt(result_.node(other.begin), result_.segment(other), 0.5) - middle).norm() > snap_mm_)
            continue;
        other.step[at(operand)] += same_way ? 1 : -1;
        other.twin = curve;
        return;
    }
    piece.step[at(operand)] = 1;
    *link = static_cast<int>(result_.pieces.size());
    result_.pieces.push_back(piece);
    next_at_.push_back(-1);
}

}  // namespace

Arrangement arrange(const std::vector<Curve>& curves, double snap_mm) {
    return CurveNoder(curves, snap_mm).run();
}

}  // namespace stepmill::planar
