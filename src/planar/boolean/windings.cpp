// What lies on both sides of the pieces of an arrangement.

#include "planar/boolean/windings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "planar/boolean/grouped.h"
#include "planar/boolean/junction.h"
#include "planar/boolean/strips.h"
#include "planar/segment.h"
#include "stepmill/core/units.h"

namespace stepmill::planar {

namespace {

Vec2 mirrored(const Vec2& p) {
    return {p.y(), p.x()};
}

/// Counts windings along rays. The pieces are sorted by the strip of x or y they lie in, so that a ray meets
/// few of them in vain.
class Windings {
  public:
    explicit Windings(const Arrangement& arrangement);

    /// Of both operands on the right of the middle of a piece of the arrangement.
    std::array<int, 2> onTheRight(const Piece& piece) const;

  private:
    const Arrangement& arrangement_;
    std::array<Strips, 2> strips_;  // along x, along y
};

Windings::Windings(const Arrangement& arrangement) : arrangement_(arrangement) {
    // Long pieces enter many strips: more than this costs more memory than it saves time.
    const auto count = std::clamp<std::size_t>(arrangement_.pieces.size() / 4, 1, 512);
    std::vector<Box2> boxes;
    boxes.reserve(arrangement_.pieces.size());
    for (const Piece& piece : arrangement_.pieces) {
        Box2 box = arrangement_.curves[at(piece.curve)].segment.arc ? arrangement_.curves[at(piece.curve)].box
                                                                    : Box2{};
        box.extend(arrangement_.node(piece.begin));
        box.extend(arrangement_.node(piece.end));
        boxes.push_back(box);
    }
    if (arrangement_.pieces.empty()) return;
    std::vector<int> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    for (const int axis : {0, 1})
        strips_[at(axis)] = Strips(boxes, axis, count, order);
}

std::array<int, 2> Windings::onTheRight(const Piece& piece) const {
    // A ray along +x from the middle of the piece. Where the piece runs rather along x, everything is
    // mirrored at x = y first, which turns left into right and the sign of every winding.
    const Segment own = arrangement_.segment(piece);
    const Vec2 middle = pointAt(arrangement_.node(piece.begin), own, 0.5);
    const Vec2 tangent = tangentAt(arrangement_.node(piece.begin), own, 0.5);
    const bool mirror = std::abs(tangent.x()) > std::abs(tangent.y());
    const Vec2 p = mirror ? mirrored(middle) : middle;
    std::array<int, 2> windings{};
    const Strips& strips = strips_[mirror ? 0 : 1];
    for (const int i : strips[strips.of(p.y())]) {
        const Piece& other = arrangement_.pieces[at(i)];
        Vec2 from = arrangement_.node(other.begin);
        Segment s = arrangement_.segment(other);
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

/// For every piece the one that stands for it: pieces in a row without a junction between them have the
/// same windings on both sides, and the longest is the safest to measure.
std::vector<int> chains(const Arrangement& arrangement) {
    const Grouped incident = endsByNode(arrangement.pieces.size(), arrangement.nodes.size(),
                                        [&](std::size_t i) { return arrangement.pieces[i]; });
    std::vector<int> leader(arrangement.pieces.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto find = [&](int i) {
        while (leader[at(i)] != i)
            i = leader[at(i)] = leader[at(leader[at(i)])];
        return i;
    };
    const auto size = [&](int i) {
        return (arrangement.node(arrangement.pieces[at(i)].end) -
                arrangement.node(arrangement.pieces[at(i)].begin))
            .squaredNorm();
    };
    for (std::size_t n = 0; n < arrangement.nodes.size(); ++n) {
        if (incident[n].size() != 2) continue;
        const int first = incident[n][0] / 2, second = incident[n][1] / 2;
        const Piece& a = arrangement.pieces[at(first)];
        const Piece& b = arrangement.pieces[at(second)];
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

}  // namespace

std::vector<LabelledPiece> labelled(const Arrangement& arrangement) {
    const Windings windings(arrangement);
    const std::vector<int> leader = chains(arrangement);
    std::vector<std::optional<std::array<int, 2>>> right_of(arrangement.pieces.size());
    std::vector<LabelledPiece> result;
    result.reserve(arrangement.pieces.size());
    for (std::size_t i = 0; i < arrangement.pieces.size(); ++i) {
        auto& right = right_of[at(leader[i])];
        if (!right) right = windings.onTheRight(arrangement.pieces[at(leader[i])]);
        const std::array<int, 2>& step = arrangement.pieces[i].step;
        result.push_back({arrangement.pieces[i], {(*right)[0] + step[0], (*right)[1] + step[1]}, *right});
    }
    return result;
}

bool consistent(const Arrangement& arrangement, const std::vector<LabelledPiece>& labels) {
    const Grouped incident =
        endsByNode(labels.size(), arrangement.nodes.size(), [&](std::size_t i) { return labels[i].piece; });
    std::vector<PieceEnd> ends;
    for (std::size_t n = 0; n < arrangement.nodes.size(); ++n) {
        const std::span<const int> around = incident[n];
        if (around.size() < 3) continue;
        ends.clear();
        for (const int i : around)
            ends.push_back({&labels[at(i / 2)].piece, i % 2 == 0});
        const std::vector<std::size_t> order = counterClockwise(arrangement, ends);
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

std::vector<Piece> boundary(const std::vector<LabelledPiece>& labels,
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
