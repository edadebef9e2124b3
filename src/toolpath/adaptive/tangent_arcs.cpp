// Long arcs through the steps of a way.

#include "toolpath/adaptive/tangent_arcs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/tangent_arc.h"

namespace stepmill::toolpath {
namespace {

/// Steps that one pair of arcs spans at most.
constexpr std::size_t kMostSpan = 24;
/// Shorter arcs are none: their ends may fall together [mm].
constexpr double kLeastArcMm = 1e-3;
/// Where the way turns by more it has met a wall: no arc goes through.
constexpr double kCornerDeg = 25;

/// Two arcs with one tangent where they meet, from one point and direction to another: equal lengths of the
/// control polygon. Nothing where the directions do not allow it.
std::optional<std::array<Segment, 2>> biarc(const Vec2& from, const Vec2& along, const Vec2& to,
                                            const Vec2& along_end) {
    const Vec2 v = to - from;
    const Vec2 t = along + along_end;
    const double a = 2 * (1 - along.dot(along_end));
    const double b = 2 * v.dot(t);
    const double c = -v.squaredNorm();
    double d = 0;
    if (a > 1e-9) {
        d = (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
    } else {
        if (b <= 0) return std::nullopt;
        d = -c / b;
    }
    if (!(d > 0)) return std::nullopt;
    const Vec2 middle = snapToGrid(Vec2((from + d * along + to - d * along_end) / 2));
    if (std::min((middle - from).norm(), (to - middle).norm()) < kLeastArcMm) return std::nullopt;
    const Segment first = arcTo(from, along, middle);
    // The second arc, run backwards from its end.
    const Segment back = arcTo(to, Vec2(-along_end), middle);
    Segment second{to, back.arc};
    if (second.arc) second.arc->ccw = !second.arc->ccw;
    return std::array<Segment, 2>{first, second};
}

/// Fits as long arcs as go through the points between two corners.
class Fitter {
  public:
    Fitter(const std::vector<Vec2>& points, double most_off_mm) : points_(points), most_off_mm_(most_off_mm) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2& from = points[i > 0 ? i - 1 : 0];
            const Vec2& to = points[std::min(i + 1, points.size() - 1)];
            tangents_.push_back((to - from).normalized());
        }
    }

    void add(Path& path) const {
        for (std::size_t i = 0; i + 1 < points_.size();) {
            std::size_t span = std::min(kMostSpan, points_.size() - 1 - i);
            while (span > 1 && !fits(i, i + span))
                span = span / 2;
            const auto arcs = between(i, i + span);
            if (arcs)
                path.segments.insert(path.segments.end(), arcs->begin(), arcs->end());
            else
                path.segments.push_back({points_[i + span], std::nullopt});
            i += span;
        }
    }

  private:
    std::optional<std::array<Segment, 2>> between(std::size_t i, std::size_t j) const {
        return biarc(points_[i], tangents_[i], points_[j], tangents_[j]);
    }

    bool fits(std::size_t i, std::size_t j) const {
        const auto arcs = between(i, j);
        if (!arcs) return false;
        const Edge first = makeEdge(points_[i], (*arcs)[0]);
        const Edge second = makeEdge((*arcs)[0].to, (*arcs)[1]);
        for (std::size_t k = i + 1; k < j; ++k)
            if (std::min(distanceTo(points_[k], first), distanceTo(points_[k], second)) > most_off_mm_)
                return false;
        return true;
    }

    const std::vector<Vec2>& points_;
    double most_off_mm_;
    std::vector<Vec2> tangents_;
};

}  // namespace

Path tangentArcs(const std::vector<Vec2>& points, double most_off_mm) {
    Path path{points.front(), {}};
    const double corner = std::cos(degToRad(kCornerDeg));
    std::vector<Vec2> run{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
        run.push_back(points[i]);
        const bool last = i + 1 == points.size();
        const bool turns =
            !last &&
            (points[i] - points[i - 1]).normalized().dot((points[i + 1] - points[i]).normalized()) < corner;
        if (!last && !turns) continue;
        Fitter(run, most_off_mm).add(path);
        run = {points[i]};
    }
    return path;
}

}  // namespace stepmill::toolpath
