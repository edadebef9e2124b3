// Questions to a region without booleans.

#include "layers/indexed_region.h"

#include <algorithm>
#include <limits>

namespace stepmill::layers {

namespace {

std::vector<Box2> boxesOf(const std::vector<MonotonePiece>& pieces) {
    std::vector<Box2> boxes;
    boxes.reserve(pieces.size());
    for (const MonotonePiece& piece : pieces) {
        Box2 around(piece.from);
        around.extend(piece.to);
        boxes.push_back(around);
    }
    return boxes;
}

/// Everything at those heights that is not left of x.
Box2 rightOf(double x, double low, double high) {
    return {Vec2(x, low), Vec2(std::numeric_limits<double>::infinity(), high)};
}

/// Integral of x - left, held between 0 and the box's width, over the heights of the piece in the box.
double areaBeside(const MonotonePiece& piece, const Box2& box) {
    const double low = std::max(piece.low(), box.min().y());
    const double high = std::min(piece.high(), box.max().y());
    if (low >= high) return 0;
    const double left = box.min().x();
    const double right = box.max().x();
    const bool whole = low == piece.low() && high == piece.high();
    const double at_low =
        whole ? (piece.from.y() < piece.to.y() ? piece.from : piece.to).x() : piece.xAt(low);
    const double at_high =
        whole ? (piece.from.y() < piece.to.y() ? piece.to : piece.from).x() : piece.xAt(high);
    const double least = std::min(at_low, at_high);
    const double most = std::max(at_low, at_high);
    if (most <= left) return 0;
    if (least >= right) return (right - left) * (high - low);
    if (least >= left && most <= right) return piece.integralOfX(low, high) - left * (high - low);
    // The piece enters or leaves the box sideways: three stretches at most, left of it, in it, right of it.
    const bool rightward = at_high > at_low;
    const double at_left = least < left ? std::clamp(piece.yAt(left), low, high) : rightward ? low : high;
    const double at_right = most > right ? std::clamp(piece.yAt(right), low, high) : rightward ? high : low;
    const double first = std::min(at_left, at_right);
    const double last = std::max(at_left, at_right);
    const double beyond = rightward ? high - last : first - low;
    return piece.integralOfX(first, last) - left * (last - first) + (right - left) * beyond;
}

}  // namespace

IndexedRegion::IndexedRegion(const Region& region)
    : pieces_(piecesOf(region)), tree_(boxesOf(pieces_)), edges_(region) {}

double IndexedRegion::areaIn(const Box2& box) const {
    // Green's theorem: the area is the integral of x over y along the boundary. Held between the sides of
    // the box, x gives what of the area lies between them; a piece left of the box gives nothing.
    double area_mm2 = 0;
    tree_.forEachNear(rightOf(box.min().x(), box.min().y(), box.max().y()), [&](std::size_t i) {
        const double beside = areaBeside(pieces_[i], box);
        area_mm2 += pieces_[i].to.y() > pieces_[i].from.y() ? beside : -beside;
    });
    return area_mm2;
}

bool IndexedRegion::holds(const Vec2& p) const {
    bool inside = false;
    tree_.forEachNear(rightOf(p.x(), p.y(), p.y()), [&](std::size_t i) {
        const MonotonePiece& piece = pieces_[i];
        const bool crosses = (piece.from.y() > p.y()) != (piece.to.y() > p.y());
        if (crosses && piece.xAt(p.y()) > p.x()) inside = !inside;
    });
    return inside;
}

bool IndexedRegion::isBeyond(const Vec2& p, double by_mm) const {
    return !holds(p) && edges_.distanceTo(p, 2 * by_mm) > by_mm;
}

bool IndexedRegion::isDeep(const Vec2& p, double by_mm) const {
    return holds(p) && edges_.distanceTo(p, 2 * by_mm) > by_mm;
}

}  // namespace stepmill::layers
