// Areas along scan lines.

#include "layers/stock/scanned_area.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <numeric>
#include <utility>

#include "stepmill/planar/edge.h"

namespace stepmill::layers {

namespace {

/// Corners nearer to each other than this share of the whole height have no lines between them: what lies
/// there is below the accuracy of the sums these areas go into.
constexpr double kLeastShare = 1.0 / 100;
/// A band whose direction across has no more than this of x lies along the lines.
constexpr double kLevel = 1e-9;
/// Gauss' two points on [0, 1].
constexpr double kFirstPoint = 0.21132486540518713;

struct Line {
    double y = 0;
    double height_mm = 0;  ///< the line stands for
};

/// A point or a stretch of the line with that number.
struct LineCrossing {
    int line = 0;
    double x = 0;

    auto operator<=>(const LineCrossing&) const = default;
};
struct Stretch {
    int line = 0;
    double from = 0;
    double to = 0;

    auto operator<=>(const Stretch&) const = default;
};

/// Heights between which lengths along the lines change evenly.
class Corners {
  public:
    Corners(double low, double high) : low_(low), high_(high), least_(kLeastShare * (high - low)) {}

    void add(const Vec2& from, const Vec2& to) {
        // Along an edge that lies level lengths jump: lines part there, however near other corners are.
        const bool level = std::abs(to.y() - from.y()) < least_ && std::abs(to.x() - from.x()) > least_;
        add(from.y(), level);
        if (level) add(to.y(), level);
    }
    void add(double y, bool level) {
        if (y > low_ && y < high_) all_.push_back({y, level});
    }
    std::vector<Line> lines() {
        std::sort(all_.begin(), all_.end(), [](const Corner& a, const Corner& b) { return a.y < b.y; });
        all_.push_back({high_, true});
        std::vector<Line> found;
        double from = low_;
        for (const Corner& corner : all_) {
            const double height = corner.y - from;
            if (height <= kGridMm || (height < least_ && !corner.level)) continue;
            found.push_back({from + kFirstPoint * height, height / 2});
            found.push_back({corner.y - kFirstPoint * height, height / 2});
            from = corner.y;
        }
        return found;
    }

  private:
    struct Corner {
        double y = 0;
        bool level = false;
    };

    double low_;
    double high_;
    double least_;
    std::vector<Corner> all_;
};

std::vector<Line> linesOf(const IndexedRegion& within, const std::vector<BandedPolygon>& polygons) {
    Corners corners(within.box().min().y(), within.box().max().y());
    for (const MonotonePiece& piece : within.pieces())
        corners.add(piece.from, piece.to);
    for (const BandedPolygon& polygon : polygons) {
        for (const BandedPolygon::Side& side : polygon.sides)
            corners.add(side.from, side.to);
        // A band that lies along the lines ends like a level side.
        if (std::abs(polygon.across.x()) < kLevel && polygon.across.y() != 0)
            for (const double end : {polygon.low, polygon.high})
                corners.add(end / polygon.across.y(), true);
    }
    return corners.lines();
}

/// Sorts by line, then along it. O(n log m) for m on one line.
template <typename OnLine>
void sortByLine(std::vector<OnLine>& all, std::size_t lines) {
    std::vector<std::size_t> ends(lines + 1, 0);
    for (const OnLine& one : all)
        ++ends[static_cast<std::size_t>(one.line) + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<OnLine> sorted(all.size());
    std::vector<std::size_t> next = ends;
    for (const OnLine& one : all)
        sorted[next[static_cast<std::size_t>(one.line)]++] = one;
    for (std::size_t i = 0; i < lines; ++i)
        std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(ends[i]),
                  sorted.begin() + static_cast<std::ptrdiff_t>(ends[i + 1]));
    all = std::move(sorted);
}

/// Adds where lines cross an edge between two heights.
template <typename XAt>
void crossLines(const std::vector<Line>& lines, double one_y, double other_y, const XAt& x_at,
                std::vector<LineCrossing>& into) {
    const double low = std::min(one_y, other_y);
    const double high = std::max(one_y, other_y);
    const auto below = [](const Line& line, double y) { return line.y < y; };
    for (auto it = std::lower_bound(lines.begin(), lines.end(), low, below);
         it != lines.end() && it->y < high; ++it)
        into.push_back({static_cast<int>(it - lines.begin()), x_at(it->y)});
}

/// What of the line lies in the band.
std::pair<double, double> inBand(const BandedPolygon& polygon, double y) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    const double base = polygon.across.y() * y;
    const double slope = polygon.across.x();
    if (std::abs(slope) < kLevel)
        return base >= polygon.low && base <= polygon.high ? std::pair{-kFar, kFar} : std::pair{kFar, -kFar};
    const double one = (polygon.low - base) / slope;
    const double other = (polygon.high - base) / slope;
    return {std::min(one, other), std::max(one, other)};
}

/// What of the lines lies inside, between each two crossings.
void addInside(const std::vector<LineCrossing>& crossings, std::vector<Stretch>& into) {
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        if (crossings[i].line == crossings[i + 1].line)
            into.push_back({crossings[i].line, crossings[i].x, crossings[i + 1].x});
}

void addInside(const BandedPolygon& polygon, const std::vector<Line>& lines, std::vector<Stretch>& into) {
    std::vector<LineCrossing> crossings;
    crossings.reserve(4 * lines.size());
    for (const BandedPolygon::Side& side : polygon.sides) {
        const Vec2 run = side.to - side.from;
        crossLines(
            lines, side.from.y(), side.to.y(),
            [&](double y) { return side.from.x() + run.x() * (y - side.from.y()) / run.y(); }, crossings);
    }
    sortByLine(crossings, lines.size());
    const std::size_t first = into.size();
    addInside(crossings, into);
    const bool bounded = std::isfinite(polygon.low) || std::isfinite(polygon.high);
    for (std::size_t i = first; bounded && i < into.size(); ++i) {
        const auto [low, high] = inBand(polygon, lines[static_cast<std::size_t>(into[i].line)].y);
        into[i].from = std::max(into[i].from, low);
        into[i].to = std::min(into[i].to, high);
    }
}

std::vector<Stretch> regionOnLines(const IndexedRegion& within, const std::vector<Line>& lines) {
    std::vector<LineCrossing> crossings;
    for (const MonotonePiece& piece : within.pieces())
        crossLines(
            lines, piece.from.y(), piece.to.y(), [&](double y) { return piece.xAt(y); }, crossings);
    sortByLine(crossings, lines.size());
    std::vector<Stretch> inside;
    addInside(crossings, inside);
    return inside;
}

}  // namespace

BandedPolygon banded(const Region& polygon) {
    BandedPolygon result;
    for (const auto& [from, segment] : eachEdge(polygon))
        result.sides.push_back({from, segment.to});
    return result;
}

BandedPolygon banded(const Box2& box) {
    return banded(makeRectangle(box.min(), box.max()));
}

double scannedArea(const IndexedRegion& within, const std::vector<BandedPolygon>& polygons) {
    const std::vector<Line> lines = linesOf(within, polygons);
    const std::vector<Stretch> region = regionOnLines(within, lines);
    std::vector<Stretch> covered;
    for (const BandedPolygon& polygon : polygons)
        addInside(polygon, lines, covered);
    sortByLine(covered, lines.size());
    double area_mm2 = 0;
    std::size_t at = 0;
    Stretch done{-1, 0, 0};
    for (Stretch stretch : covered) {
        // What an earlier stretch of the line has covered does not count again.
        if (stretch.line == done.line) stretch.from = std::max(stretch.from, done.to);
        if (stretch.to <= stretch.from) continue;
        done = stretch;
        const auto isBefore = [&](const Stretch& inside) {
            return inside.line < stretch.line || (inside.line == stretch.line && inside.to <= stretch.from);
        };
        while (at < region.size() && isBefore(region[at]))
            ++at;
        const double height = lines[static_cast<std::size_t>(stretch.line)].height_mm;
        for (std::size_t i = at; i < region.size() && region[i].line == stretch.line; ++i) {
            if (region[i].from >= stretch.to) break;
            area_mm2 +=
                height * (std::min(stretch.to, region[i].to) - std::max(stretch.from, region[i].from));
        }
    }
    return area_mm2;
}

}  // namespace stepmill::layers
