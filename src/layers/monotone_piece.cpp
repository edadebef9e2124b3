// Boundaries as pieces with one place at every height.

#include "layers/monotone_piece.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"

namespace stepmill::layers {

namespace {

/// Shares of an arc at which it passes the outermost points of its circle.
std::vector<double> turningShares(const Vec2& from, const Segment& segment) {
    const Arc& arc = *segment.arc;
    const Vec2 out = from - arc.centre;
    const double start = std::atan2(out.y(), out.x());
    const double sweep = sweepAngle(from, segment.to, arc);
    std::vector<double> shares;
    // A start in (-pi, pi] and a full turn either way: six quarter turns cover them.
    for (int quarter = -6; quarter <= 6; ++quarter) {
        const double share = (quarter * kPi / 2 - start) / sweep;
        if (share > 1e-9 && share < 1 - 1e-9) shares.push_back(share);
    }
    std::sort(shares.begin(), shares.end());
    return shares;
}

/// Area under half a circle of that radius about the origin, from its middle to u.
double underHalfCircle(double radius, double u) {
    const double share = std::clamp(u / radius, -1.0, 1.0);
    return 0.5 * radius * radius * (share * std::sqrt(1 - share * share) + std::asin(share));
}

}  // namespace

double MonotonePiece::xAt(double y) const {
    if (!arc) {
        const double rise = to.y() - from.y();
        return rise == 0 ? from.x()
                         : from.x() + (to.x() - from.x()) * std::clamp((y - from.y()) / rise, 0.0, 1.0);
    }
    const double up = y - arc->centre.y();
    const double out = std::sqrt(std::max(0.0, arc->radius_mm * arc->radius_mm - up * up));
    return arc->centre.x() + (right_of_centre ? out : -out);
}

double MonotonePiece::yAt(double x) const {
    if (!arc) {
        const double run = to.x() - from.x();
        return run == 0 ? from.y()
                        : from.y() + (to.y() - from.y()) * std::clamp((x - from.x()) / run, 0.0, 1.0);
    }
    const double aside = x - arc->centre.x();
    const double out = std::sqrt(std::max(0.0, arc->radius_mm * arc->radius_mm - aside * aside));
    return arc->centre.y() + ((from + to).y() / 2 > arc->centre.y() ? out : -out);
}

double MonotonePiece::integralOfX(double low_y, double high_y) const {
    if (!arc) return 0.5 * (xAt(low_y) + xAt(high_y)) * (high_y - low_y);
    const Vec2& centre = arc->centre;
    const double beside = underHalfCircle(arc->radius_mm, high_y - centre.y()) -
                          underHalfCircle(arc->radius_mm, low_y - centre.y());
    return centre.x() * (high_y - low_y) + (right_of_centre ? beside : -beside);
}

void addPieces(const Vec2& from, const Segment& segment, std::vector<MonotonePiece>& into) {
    if (!segment.arc) return into.push_back({from, segment.to, std::nullopt, false});
    std::vector<double> shares = turningShares(from, segment);
    shares.push_back(1);
    Vec2 at = from;
    double done = 0;
    for (const double share : shares) {
        const Vec2 to = share == 1 ? segment.to : pointAt(from, segment, share);
        const Vec2 middle = pointAt(from, segment, (done + share) / 2);
        into.push_back({at, to, segment.arc, middle.x() > segment.arc->centre.x()});
        at = to;
        done = share;
    }
}

std::vector<MonotonePiece> piecesOf(const Region& region) {
    std::vector<MonotonePiece> pieces;
    for (const auto& [from, segment] : eachEdge(region))
        addPieces(from, segment, pieces);
    return pieces;
}

}  // namespace stepmill::layers
