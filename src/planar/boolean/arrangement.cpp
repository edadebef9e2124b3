// Two sets of loops cut into pieces that meet at nodes only.

#include "planar/boolean/arrangement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "planar/intersection.h"
#include "planar/segment.h"
#include "stepmill/core/units.h"

namespace stepmill::planar {

namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

Vec2 mirrored(const Vec2& p) {
    return {p.y(), p.x()};
}

/// Calls visit(i, j) for all pairs of boxes that overlap.
template <typename Visit>
void forOverlappingBoxes(const std::vector<Curve>& curves, double slack_mm, Visit visit) {
    std::vector<int> order(curves.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return curves[at(a)].box.min().x() < curves[at(b)].box.min().x(); });
    std::vector<int> active;
    for (const int i : order) {
        const Box2 box = grown(curves[at(i)].box, slack_mm);
        std::erase_if(active, [&](int j) { return curves[at(j)].box.max().x() < box.min().x(); });
        for (const int j : active)
            if (curves[at(j)].box.intersects(box)) visit(std::min(i, j), std::max(i, j));
        active.push_back(i);
    }
}

bool adjacent(const Curve& a, const Curve& b) {
    return a.loop == b.loop && (a.segment.to == b.from || b.segment.to == a.from);
}

/// Do two neighbouring edges cross at p, rather than meet at their corner? Rounding lets edges that touch
/// tangentially at their corner cross once more, micrometres away and a nanometre deep.
bool crossesBesideCorner(const Curve& a, const Curve& b, const Vec2& p) {
    double from_corner = std::numeric_limits<double>::infinity();
    if (a.segment.to == b.from) from_corner = std::min(from_corner, (p - b.from).norm());
    if (b.segment.to == a.from) from_corner = std::min(from_corner, (p - a.from).norm());
    constexpr double kDeepMm = 10 * kGridMm;
    if (from_corner / 4 <= kDeepMm) return false;
    const Vec2 ta = tangentAt(a.from, a.segment, shareOf(p, a.from, a.segment));
    const Vec2 tb = tangentAt(b.from, b.segment, shareOf(p, b.from, b.segment));
    // The two curves part by about a quarter of chord times angle in between.
    return from_corner * std::abs(cross(ta, tb)) / 4 > kDeepMm;
}

}  // namespace

void appendCurves(const Region& region, int operand, std::vector<Curve>& curves) {
    int loop = curves.empty() ? 0 : curves.back().loop + 1;
    for (const Loop& path : region.loops) {
        Vec2 from = path.start;
        for (const Segment& segment : path.segments) {
            const Vec2 to = segment.to;
            if (segment.arc && std::abs(sweepAngle(from, to, *segment.arc)) > kPi + 1e-6) {
                const Segment half{snapToGrid(pointAt(from, segment, 0.5)), segment.arc};
                curves.push_back({makeEdge(from, half), operand, loop});
                from = half.to;
            }
            curves.push_back({makeEdge(from, segment), operand, loop});
            from = to;
        }
        ++loop;
    }
}

// Nodes --------------------------------------------------------------------------------------------------

/// Finds the node near a point, or makes one.
struct Arrangement::NodeIndex {
    NodeIndex(std::vector<Vec2>& nodes, double snap_mm) : nodes_(nodes), snap_mm_(snap_mm) {}

    int add(const Vec2& p) {
        int nearest = -1;
        double distance = snap_mm_;
        const std::int64_t x0 = cell(p.x() - snap_mm_), x1 = cell(p.x() + snap_mm_);
        const std::int64_t y0 = cell(p.y() - snap_mm_), y1 = cell(p.y() + snap_mm_);
        for (std::int64_t x = x0; x <= x1; ++x)
            for (std::int64_t y = y0; y <= y1; ++y) {
                const auto found = cells_.find(key(x, y));
                if (found == cells_.end()) continue;
                for (const int node : found->second) {
                    const double d = (nodes_[at(node)] - p).norm();
                    if (d > distance || (d == distance && nearest >= 0 && nearest < node)) continue;
                    nearest = node;
                    distance = d;
                }
            }
        if (nearest >= 0) return nearest;
        nodes_.push_back(snapToGrid(p));
        const int node = static_cast<int>(nodes_.size()) - 1;
        cells_[key(cell(p.x()), cell(p.y()))].push_back(node);
        return node;
    }

  private:
    std::int64_t cell(double value) const {
        return static_cast<std::int64_t>(std::floor(value / (4 * snap_mm_)));
    }
    static std::uint64_t key(std::int64_t x, std::int64_t y) {
        return static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15ULL ^ static_cast<std::uint64_t>(y);
    }

    std::vector<Vec2>& nodes_;
    double snap_mm_;
    std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

// Pieces -------------------------------------------------------------------------------------------------

Arrangement::Arrangement(const std::vector<Curve>& curves, double snap_mm)
    : curves_(curves), snap_mm_(snap_mm) {
    cutCurves();
    dropDeadPieces();
    sortIntoStrips();
}

/// Points sorted along x and along y: those in a long thin box are found along its short side.
class Arrangement::NodesInBox {
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
class Arrangement::Cuts {
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

void Arrangement::cutCurves() {
    NodeIndex index(nodes_, snap_mm_);
    Cuts cuts(curves_.size());
    std::vector<Stretch> snapped;  // the curves between the nodes of their ends
    snapped.reserve(curves_.size());
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        const int begin = index.add(curves_[i].from), end = index.add(curves_[i].to());
        cuts.add(static_cast<int>(i), 0, begin);
        cuts.add(static_cast<int>(i), 1, end);
        snapped.push_back(betweenNodes(curves_[i], begin, end));
    }
    const auto cut = [&](int curve, int node) {
        if (cuts.has(curve, node)) return;
        const Stretch& c = snapped[at(curve)];
        const double share = shareOf(nodes_[at(node)], c.from, c.segment);
        if (share > 0 && share < 1) cuts.add(curve, share, node);
    };
    std::vector<std::pair<int, int>> pairs;
    forOverlappingBoxes(curves_, snap_mm_, [&](int i, int j) { pairs.emplace_back(i, j); });
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [i, j] : pairs) {
        const Curve& a = curves_[at(i)];
        const Curve& b = curves_[at(j)];
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
    const NodesInBox nodes(nodes_);
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        const Curve& c = curves_[i];
        const Stretch& bent = snapped[i];
        nodes.forEachIn(grown(c.box, 2 * snap_mm_), [&](int node) {
            if (cuts.has(static_cast<int>(i), node)) return;
            const Vec2& p = nodes_[at(node)];
            if (distanceTo(p, c) <= snap_mm_ || distanceTo(p, bent.from, bent.segment) <= snap_mm_)
                cut(static_cast<int>(i), node);
        });
    }
    addPieces(std::move(cuts).inOrder());
}

void Arrangement::addPieces(const std::vector<Cut>& cuts) {
    first_at_.assign(nodes_.size(), -1);
    for (std::size_t k = 1; k < cuts.size(); ++k)
        if (cuts[k].curve == cuts[k - 1].curve) addPiece(cuts[k - 1].node, cuts[k].node, cuts[k].curve);
}

Arrangement::Stretch Arrangement::betweenNodes(const Curve& curve, int begin, int end) const {
    const Segment bent{node(end), curve.segment.arc};
    // Snapping can turn a short arc about its centre the wrong way, and short curves into points.
    const bool turned = bent.arc && std::abs(sweepAngle(node(begin), bent.to, *bent.arc)) > 1.5 * kPi;
    if (begin == end || turned) return {curve.from, curve.segment};
    return {node(begin), bent};
}

Segment Arrangement::segment(const Piece& piece) const {
    Segment result{node(piece.end), std::nullopt};
    if (piece.straight) return result;
    result.arc = curves_[at(piece.curve)].segment.arc;
    if (result.arc && !piece.along) result.arc->ccw = !result.arc->ccw;
    return result;
}

const Vec2& Arrangement::place(int index) const {
    return places_.empty() ? node(index) : places_[at(index)];
}

Segment Arrangement::onCurve(const Piece& piece) const {
    if (chord_mm_ == 0) return segment(piece);
    Segment result{place(piece.end), curves_[at(piece.curve)].segment.arc};
    if (!result.arc) return result;
    if (!piece.along) result.arc->ccw = !result.arc->ccw;
    // Rounding can turn a short chord about the centre the wrong way.
    if (std::abs(sweepAngle(place(piece.begin), result.to, *result.arc)) > 1.5 * kPi) result.arc.reset();
    return result;
}

void Arrangement::addPiece(int begin, int end, int curve) {
    // Shorter than the snapping distance: a point.
    if (begin == end) return;
    Piece piece{begin, end, curve, true, false, {}, -1};
    const std::optional<Arc>& arc = curves_[at(curve)].segment.arc;
    // Snapping can turn the ends of a short arc about its centre until the arc seems to go all the way round.
    piece.straight = arc && std::abs(sweepAngle(node(begin), node(end), *arc)) > 1.5 * kPi;
    const Vec2 middle = pointAt(node(begin), segment(piece), 0.5);
    const int operand = curves_[at(curve)].operand;
    int* link = &first_at_[at(std::min(begin, end))];
    for (; *link >= 0; link = &next_at_[at(*link)]) {
        Piece& other = pieces_[at(*link)];
        const bool same_way = other.begin == begin && other.end == end;
        const bool other_way = other.begin == end && other.end == begin;
        if (!same_way && !other_way) continue;
        if ((pointAt(node(other.begin), segment(other), 0.5) - middle).norm() > snap_mm_) continue;
        other.step[at(operand)] += same_way ? 1 : -1;
        other.twin = curve;
        return;
    }
    piece.step[at(operand)] = 1;
    *link = static_cast<int>(pieces_.size());
    pieces_.push_back(piece);
    next_at_.push_back(-1);
}

void Arrangement::dropDeadPieces() {
    const auto alive = [](const Piece& piece) { return piece.step != std::array<int, 2>{}; };
    const auto dead = std::stable_partition(pieces_.begin(), pieces_.end(), alive);
    cancelled_.assign(dead, pieces_.end());
    pieces_.erase(dead, pieces_.end());
}

// Inside and outside ---------------------------------------------------------------------------------------

/// Pieces by the strip of x or y they lie in, so that a ray meets few of them in vain.
void Arrangement::sortIntoStrips() {
    // Long pieces enter many strips: more than this costs more memory than it saves time.
    const auto count = std::clamp<std::size_t>(pieces_.size() / 4, 1, 512);
    std::vector<Box2> boxes;
    boxes.reserve(pieces_.size());
    Box2 all;
    for (const Piece& piece : pieces_) {
        Box2 box = curves_[at(piece.curve)].segment.arc ? curves_[at(piece.curve)].box : Box2{};
        box.extend(node(piece.begin));
        box.extend(node(piece.end));
        all.extend(box);
        boxes.push_back(box);
    }
    if (pieces_.empty()) return;
    for (const int axis : {0, 1}) {
        Strips& strips = strips_[at(axis)];
        strips.count = count;
        strips.low_mm = all.min()[axis];
        strips.per_mm = static_cast<double>(count) / std::max(all.sizes()[axis], kGridMm);
        std::vector<int> entered;
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            for (std::size_t k = strips.of(boxes[i].min()[axis]); k <= strips.of(boxes[i].max()[axis]); ++k) {
                entered.push_back(static_cast<int>(k));
                strips.pieces.push_back(static_cast<int>(i));
            }
        strips.entries = Grouped(entered, count);
    }
}

std::size_t Arrangement::Strips::of(double value_mm) const {
    const double strip = (value_mm - low_mm) * per_mm;
    return std::min(count - 1, static_cast<std::size_t>(std::max(0.0, strip)));
}

std::array<int, 2> Arrangement::windingsOnTheRight(const Piece& piece) const {
    // A ray along +x from the middle of the piece. Where the piece runs rather along x, everything is
    // mirrored at x = y first, which turns left into right and the sign of every winding.
    const Segment own = segment(piece);
    const Vec2 middle = pointAt(node(piece.begin), own, 0.5);
    const Vec2 tangent = tangentAt(node(piece.begin), own, 0.5);
    const bool mirror = std::abs(tangent.x()) > std::abs(tangent.y());
    const Vec2 p = mirror ? mirrored(middle) : middle;
    std::array<int, 2> windings{};
    const Strips& strips = strips_[mirror ? 0 : 1];
    for (const int entry : strips.entries[strips.of(p.y())]) {
        const Piece& other = pieces_[at(strips.pieces[at(entry)])];
        Vec2 from = node(other.begin);
        Segment s = segment(other);
        if (mirror) {
            from = mirrored(from);
            s.to = mirrored(s.to);
            if (s.arc) s.arc = Arc{mirrored(s.arc->centre), s.arc->radius_mm, !s.arc->ccw};
        }
        const int side = &other != &piece ? 0 : mirror ? 1 : -1;
        const int share = windingShare(from, s, p, side);
        for (std::size_t k = 0; k < 2; ++k)
            windings[k] += (mirror ? -share : share) * other.step[k];
    }
    return windings;
}

namespace {

/// The ends of pieces by their nodes: number 2 i is where piece i begins, 2 i + 1 where it ends.
template <typename PieceOf>
Grouped endsByNode(std::size_t pieces, std::size_t nodes, const PieceOf& piece_of) {
    std::vector<int> node_of;
    node_of.reserve(2 * pieces);
    for (std::size_t i = 0; i < pieces; ++i) {
        node_of.push_back(piece_of(i).begin);
        node_of.push_back(piece_of(i).end);
    }
    return {node_of, nodes};
}

}  // namespace

/// For every piece the one that stands for it: pieces in a row without a junction between them have the
/// same windings on both sides, and the longest is the safest to measure.
std::vector<int> Arrangement::chains() const {
    const Grouped incident =
        endsByNode(pieces_.size(), nodes_.size(), [&](std::size_t i) { return pieces_[i]; });
    std::vector<int> leader(pieces_.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto find = [&](int i) {
        while (leader[at(i)] != i)
            i = leader[at(i)] = leader[at(leader[at(i)])];
        return i;
    };
    const auto size = [&](int i) {
        return (node(pieces_[at(i)].end) - node(pieces_[at(i)].begin)).squaredNorm();
    };
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        if (incident[n].size() != 2) continue;
        const int first = incident[n][0] / 2, second = incident[n][1] / 2;
        const Piece& a = pieces_[at(first)];
        const Piece& b = pieces_[at(second)];
        const bool in_a_row = a.end == b.begin || a.begin == b.end;
        if (!in_a_row || a.step != b.step) continue;
        const int i = find(first);
        const int j = find(second);
        if (size(i) > size(j) || (size(i) == size(j) && i < j))
            leader[at(j)] = i;
        else
            leader[at(i)] = j;
    }
    for (std::size_t i = 0; i < leader.size(); ++i)
        leader[i] = find(static_cast<int>(i));
    return leader;
}

std::vector<LabelledPiece> Arrangement::labelled() const {
    const std::vector<int> leader = chains();
    std::vector<std::optional<std::array<int, 2>>> windings(pieces_.size());
    std::vector<LabelledPiece> result;
    result.reserve(pieces_.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        auto& right = windings[at(leader[i])];
        if (!right) right = windingsOnTheRight(pieces_[at(leader[i])]);
        const std::array<int, 2>& step = pieces_[i].step;
        result.push_back({pieces_[i], {(*right)[0] + step[0], (*right)[1] + step[1]}, *right});
    }
    return result;
}

bool Arrangement::consistent(const std::vector<LabelledPiece>& labels) const {
    const Grouped incident =
        endsByNode(labels.size(), nodes_.size(), [&](std::size_t i) { return labels[i].piece; });
    std::vector<End> ends;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const std::span<const int> around = incident[n];
        if (around.size() < 3) continue;
        ends.clear();
        for (const int i : around)
            ends.push_back({&labels[at(i / 2)].piece, i % 2 == 0});
        const std::vector<std::size_t> order = counterClockwise(ends);
        for (std::size_t k = 0; k < order.size(); ++k) {
            const std::size_t here = order[k];
            const std::size_t next = order[(k + 1) % order.size()];
            const LabelledPiece& label = labels[at(around[here] / 2)];
            const LabelledPiece& next_label = labels[at(around[next] / 2)];
            const auto& after = ends[here].leaves ? label.left : label.right;
            const auto& before = ends[next].leaves ? next_label.right : next_label.left;
            if (after != before) return false;
        }
    }
    return true;
}

Vec2 Arrangement::seen(const End& end, double reach_mm) const {
    const Piece& piece = *end.piece;
    const double share = reach_mm / lengthOf(piece);
    const Vec2 p = pointAt(node(piece.begin), segment(piece), end.leaves ? share : 1 - share);
    return p - node(end.leaves ? piece.begin : piece.end);
}

std::vector<std::size_t> Arrangement::counterClockwise(std::span<const End> ends) const {
    std::vector<std::size_t> order(ends.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    sortAround(ends, order);
    return order;
}

void Arrangement::sortAround(std::span<const End> ends, std::span<std::size_t> order) const {
    // All are looked at from the same distance: of two tangent pieces the one that bends away to the left
    // comes later. A short piece forces short sight on all; rounding then hides which way the others bend,
    // so those that seem to run together are looked at once more without it.
    constexpr double kTogetherRad = 0.3;
    double reach_mm = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order)
        reach_mm = std::min(reach_mm, lengthOf(*ends[i].piece) / 2);
    std::vector<std::pair<double, std::size_t>> by_angle;
    for (const std::size_t i : order) {
        const Vec2 direction = seen(ends[i], reach_mm);
        by_angle.emplace_back(std::atan2(direction.y(), direction.x()), i);
    }
    std::sort(by_angle.begin(), by_angle.end());
    // Start after the widest gap, so that no bundle lies across the start.
    const auto gapBefore = [&](std::size_t k) {
        return k == 0 ? by_angle.front().first + 2 * kPi - by_angle.back().first
                      : by_angle[k].first - by_angle[k - 1].first;
    };
    std::size_t start = 0;
    for (std::size_t k = 1; k < by_angle.size(); ++k)
        if (gapBefore(k) > gapBefore(start)) start = k;
    std::size_t bundle = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        order[k] = by_angle[(start + k) % order.size()].second;
        const bool ends_here =
            k + 1 == order.size() || gapBefore((start + k + 1) % order.size()) > kTogetherRad;
        if (!ends_here) continue;
        const std::size_t count = k + 1 - bundle;
        if (count > 1 && count < order.size()) sortAround(ends, order.subspan(bundle, count));
        bundle = k + 1;
    }
}

double Arrangement::lengthOf(const Piece& piece) const {
    return length(node(piece.begin), segment(piece));
}

std::vector<Piece> Arrangement::boundary(const std::vector<LabelledPiece>& labels,
                                         const std::function<bool(int, int)>& inside) {
    std::vector<Piece> result;
    for (const LabelledPiece& label : labels) {
        const bool in_left = inside(label.left[0], label.left[1]);
        if (in_left == inside(label.right[0], label.right[1])) continue;
        Piece piece = label.piece;
        if (!in_left) {
            std::swap(piece.begin, piece.end);
            piece.along = !piece.along;
        }
        result.push_back(piece);
    }
    return result;
}

}  // namespace stepmill::planar
