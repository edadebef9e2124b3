// Parallel lines across a region, their best angle, and the groups they are joined to.

#include "toolpath/patterns/parallel_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "stepmill/core/units.h"
#include "stepmill/planar/path_parts.h"

namespace stepmill::toolpath {

namespace {

/// Tried beside the directions of straight edges.
constexpr std::array kNamedAnglesDeg{0.0, 90.0, 45.0, 135.0};
/// Of the straight edges, the longest distinct directions.
constexpr std::size_t kEdgeAngles = 4;
constexpr double kSameAngleRad = 1e-3;
/// Links round the boundary are worth it up to this many times the straight way.
constexpr double kLongestDetour = 3;
/// Lines shorter than this share of the step-over lie in corners that the ring along the wall clears.
constexpr double kLeastLineShare = 1e-3;

struct Direction {
    Vec2 along;
    Vec2 across;  ///< rows follow each other this way; on the left of `along`
};

Direction directionOf(double angle_rad) {
    const Vec2 along(std::cos(angle_rad), std::sin(angle_rad));
    return {along, leftOf(along)};
}

double halfTurn(double angle_rad) {
    const double turned = std::fmod(angle_rad, kPi);
    const double positive = turned < 0 ? turned + kPi : turned;
    return kPi - positive < kSameAngleRad ? 0 : positive;
}

std::vector<double> anglesToTry(const RingFamily::Component& component) {
    std::vector<std::pair<double, double>> by_length;  // length, angle
    for (const Edge& edge : component.indexed.boundary().edges()) {
        if (edge.segment.arc) continue;
        const Vec2 along = edge.segment.to - edge.from;
        const double angle = halfTurn(std::atan2(along.y(), along.x()));
        const auto same = std::find_if(by_length.begin(), by_length.end(), [&](const auto& other) {
            return std::abs(other.second - angle) < kSameAngleRad;
        });
        if (same == by_length.end())
            by_length.emplace_back(along.norm(), angle);
        else
            same->first += along.norm();
    }
    std::stable_sort(by_length.begin(), by_length.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<double> angles;
    const auto add = [&](double angle) {
        const bool known = std::any_of(angles.begin(), angles.end(),
                                       [&](double other) { return std::abs(other - angle) < kSameAngleRad; });
        if (!known) angles.push_back(angle);
    };
    for (std::size_t i = 0; i < std::min(by_length.size(), kEdgeAngles); ++i)
        add(by_length[i].second);
    for (const double named : kNamedAnglesDeg)
        add(degToRad(named));
    return angles;
}

/// Extent of a region's boundary along a direction.
std::pair<double, double> extent(const std::vector<Edge>& boundary, const Vec2& direction) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    const auto add = [&](double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    };
    for (const Edge& edge : boundary) {
        add(direction.dot(edge.from));
        if (!edge.segment.arc) continue;
        const Arc& arc = *edge.segment.arc;
        for (const double side : {1.0, -1.0}) {
            const Vec2 p = arc.centre + side * arc.radius_mm * direction;
            if (distanceTo(p, edge) <= kGridMm) add(direction.dot(p));
        }
    }
    return {low, high};
}

class LineMaker {
  public:
    LineMaker(const RingFamily::Component& component, double step_over_mm)
        : ground_(component.line_ground),
          edges_(component.line_ground),
          guarded_edges_(edgesOf(component.guarded)),
          step_over_mm_(step_over_mm) {}

    RingFamily::Variant make(double angle_rad) const {
        RingFamily::Variant variant;
        variant.pattern = Pattern::Zigzag;
        variant.angle_rad = angle_rad;
        const Direction direction = directionOf(angle_rad);
        const auto [low, high] = extent(guarded_edges_, direction.across);
        const int gaps = std::max(1, static_cast<int>(std::ceil((high - low) / step_over_mm_ - 1e-9)));
        variant.line_spacing_mm = (high - low) / gaps;
        const auto [left, right] = extent(guarded_edges_, direction.along);
        for (int row = 1; row < gaps; ++row) {
            const Vec2 on = (low + row * variant.line_spacing_mm) * direction.across;
            const double beyond = step_over_mm_;
            addRow(on + (left - beyond) * direction.along, on + (right + beyond) * direction.along, row,
                   variant.lines);
        }
        return variant;
    }

  private:
    /// The pieces of a line inside the ground.
    void addRow(const Vec2& from, const Vec2& to, int row, std::vector<RingFamily::Ring>& lines) const {
        const Edge line = makeLine(snapToGrid(from), snapToGrid(to));
        const std::vector<double> shares = sharesWhereMet(line, edges_);
        for (std::size_t i = 1; i < shares.size(); ++i) {
            const std::optional<Edge> part = cutOut(line, shares[i - 1], shares[i]);
            if (!part || length(*part) < kLeastLineShare * step_over_mm_) continue;
            if (!contains(ground_, pointAt(*part, 0.5))) continue;
            Path path{part->from, {part->segment}};
            std::vector<RingFamily::Ring>& into = lines;
            const bool goes_on =
                !into.empty() && into.back().level == row && into.back().path.end() == part->from;
            if (goes_on)
                into.back().path.segments.back().to = part->segment.to;
            else
                into.push_back({std::move(path), row, true});
        }
    }

    const Region& ground_;
    EdgeIndex edges_;
    std::vector<Edge> guarded_edges_;
    double step_over_mm_;
};

/// Where a piece lies along the lines.
struct Span {
    double from;
    double to;
    bool overlaps(const Span& other) const { return from < other.to && other.from < to; }
};

Span spanOf(const Path& line, const Vec2& along) {
    const double a = along.dot(line.start);
    const double b = along.dot(line.end());
    return {std::min(a, b), std::max(a, b)};
}

/// Pieces of the next row beside a piece; -1 where there is none, -2 where there are several.
std::vector<int> onlyNeighbours(const std::vector<RingFamily::Ring>& pieces, const Vec2& along, int step) {
    std::vector<int> neighbours(pieces.size(), -1);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (std::size_t j = 0; j < pieces.size(); ++j) {
            if (pieces[j].level != pieces[i].level + step) continue;
            if (!spanOf(pieces[i].path, along).overlaps(spanOf(pieces[j].path, along))) continue;
            neighbours[i] = neighbours[i] == -1 ? static_cast<int>(j) : -2;
        }
    return neighbours;
}

/// The shorter way along the boundary between two points on one of its loops.
std::optional<Path> alongBoundary(const Region& region, const Vec2& a, const Vec2& b, double on_mm) {
    for (const Loop& loop : region.loops) {
        const NearestPoint from = nearestOn(loop, a);
        if (from.distance_mm > on_mm || nearestOn(loop, b).distance_mm > on_mm) continue;
        const Loop turned = startingAt(loop, from.edge, from.share);
        const NearestPoint to = nearestOn(turned, b);
        const std::vector<Edge> edges = edgesOf(turned);
        double gone = to.share * length(edges[to.edge]);
        for (std::size_t i = 0; i < to.edge; ++i)
            gone += length(edges[i]);
        const double whole = length(turned);
        const bool forward = gone <= whole - gone;
        Path way = forward ? firstPart(turned, gone) : firstPart(reversed(turned), whole - gone);
        if (way.segments.empty()) return std::nullopt;
        way.start = a;
        way.segments.back().to = b;
        return way;
    }
    return std::nullopt;
}

double linkLength(const RingFamily::Variant& variant) {
    const Vec2 along = directionOf(variant.angle_rad).along;
    const std::vector<int> next = onlyNeighbours(variant.lines, along, 1);
    double sum = 0;
    for (std::size_t i = 0; i < variant.lines.size(); ++i) {
        // Lines that end here have to be left for another place; count the way back over this one.
        if (next[i] < 0) {
            if (variant.lines[i].level < variant.lines.back().level) sum += length(variant.lines[i].path);
            continue;
        }
        const Path& a = variant.lines[i].path;
        const Path& b = variant.lines[static_cast<std::size_t>(next[i])].path;
        sum += std::min((a.end() - b.end()).norm(), (a.start - b.start).norm());
    }
    return sum;
}

double lineLength(const RingFamily::Variant& variant) {
    double sum = 0;
    for (const RingFamily::Ring& line : variant.lines)
        sum += length(line.path);
    return sum;
}

}  // namespace

RingFamily::Variant zigzag(const RingFamily::Component& component,
                           const std::vector<RingFamily::Ring>& wall_rings, double step_over_mm) {
    const LineMaker maker(component, step_over_mm);
    RingFamily::Variant best;
    double best_mm = std::numeric_limits<double>::infinity();
    for (const double angle : anglesToTry(component)) {
        RingFamily::Variant variant = maker.make(angle);
        const double length_mm = lineLength(variant) + linkLength(variant);
        if (length_mm >= best_mm * (1 - 1e-9)) continue;
        best_mm = length_mm;
        best = std::move(variant);
    }
    if (!best.lines.empty()) best.rings = wall_rings;
    return best;
}

RingFamily::Variant oneWay(const RingFamily::Variant& zigzag) {
    RingFamily::Variant variant = zigzag;
    variant.pattern = Pattern::OneWay;
    // Rows follow each other to the left of the lines as made; climb milling has the uncut side on the right.
    for (RingFamily::Ring& line : variant.lines)
        line.path = reversed(line.path);
    return variant;
}

std::vector<Path> joinedLines(const RingFamily::Component& component, const RingFamily::Variant& variant,
                              const std::vector<RingFamily::Ring>& pieces, const Tolerances& tol) {
    const Vec2 along = directionOf(variant.angle_rad).along;
    const std::vector<int> next = onlyNeighbours(pieces, along, 1);
    const std::vector<int> previous = onlyNeighbours(pieces, along, -1);
    const auto linkFrom = [&](const Vec2& a, const Vec2& b) -> std::optional<Path> {
        if (isFreeWay(component, a, b, tol)) return Path{a, {{b, {}}}};
        std::optional<Path> way = alongBoundary(component.line_ground, a, b, onBoundaryMm(tol));
        if (way && length(*way) > kLongestDetour * (b - a).norm()) way.reset();
        return way;
    };
    std::vector<char> joined(pieces.size(), 0);
    std::vector<Path> paths;
    for (std::size_t first = 0; first < pieces.size(); ++first) {
        if (joined[first]) continue;
        Path path = pieces[first].path;
        joined[first] = 1;
        for (std::size_t at = first;;) {
            const int to = next[at];
            if (to < 0 || previous[static_cast<std::size_t>(to)] != static_cast<int>(at)) break;
            const Path& line = pieces[static_cast<std::size_t>(to)].path;
            const bool straight_on = (line.start - path.end()).norm() <= (line.end() - path.end()).norm();
            const Path run = straight_on ? line : reversed(line);
            const std::optional<Path> way = linkFrom(path.end(), run.start);
            if (!way) break;
            append(path, *way);
            append(path, run);
            at = static_cast<std::size_t>(to);
            joined[at] = 1;
        }
        paths.push_back(std::move(path));
    }
    return paths;
}

}  // namespace stepmill::toolpath
