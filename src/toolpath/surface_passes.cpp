// Lines of form cutters over shallow ground.

#include "stepmill/toolpath/surface_passes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "stepmill/core/parallel.h"
#include "stepmill/feature/heights.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::toolpath {
namespace {

/// Directions of lines that are weighed.
constexpr int kDirections = 12;
/// This share of a patch's cells may ask for lines that are nearer to each other.
constexpr double kLeftOutShare = 0.05;
/// Turning to the next line takes as long as cutting so much [mm].
constexpr double kTurnMm = 3.0;
/// Stretches of a line over other ground that are no longer than so many radii are gone along.
constexpr double kBridgeRadii = 1.0;
/// From one line to the next the tip keeps to the ground where that is no farther than so many radii.
constexpr double kLinkRadii = 2.0;
/// ... and does not rise higher than this over both [mm].
constexpr double kLinkRiseMm = 0.5;
/// Pieces of a line over which the ground rises no more than this are one; none is longer or shorter [mm].
constexpr double kPieceRiseMm = 0.01;
constexpr double kLongestPieceMm = 0.25;
constexpr double kShortestPieceMm = 0.02;
/// How steep a line gets is looked at over stretches of this length [mm].
constexpr double kStretchMm = 1.0;
/// Moves rise no more than this over the way that their pieces ask for [mm].
constexpr double kSmoothMm = 0.003;

double square(double x) {
    return x * x;
}

/// How far apart lines in a direction may lie over one cell.
double apartMm(const ShallowGround::Cell& cell, const Vec2& along, const CutterForm& form,
               const LineSpacing& spacing) {
    const double corner_mm = form.heightMm();
    const double flat_mm = form.fullRadiusMm() - corner_mm;
    const double slope = cell.rise.norm();
    const double sine = slope / std::sqrt(1 + slope * slope);
    const Vec2 across(-along.y(), along.x());
    const double uphill = slope > 0 ? square(along.dot(cell.rise) / slope) : 1.0;
    const double bulge = square(across.x()) * cell.bulge_x + square(across.y()) * cell.bulge_y;
    // Of the ring that the corner draws; a ball is round to its very tip, on level ground too.
    const double round = flat_mm > 0 ? sine / (flat_mm + corner_mm * sine) : 1 / corner_mm;
    const double curvature = (1 - uphill) / corner_mm + uphill * round + bulge;
    if (curvature <= 0) return spacing.step_over_mm;
    const double ridge_mm = std::min(spacing.scallop_mm, 1 / curvature);
    return std::min(spacing.step_over_mm, 2 * std::sqrt(2 * ridge_mm / curvature - square(ridge_mm)));
}

/// Parallel lines over a patch.
struct Hatch {
    Vec2 along = Vec2::UnitX();
    double apart_mm = 0;
    double long_mm = 0;  ///< all of them, with what it takes to turn round
};

/// The cells that lines are spaced by.
ShallowGround::Patch withinRim(const ShallowGround::Patch& patch) {
    ShallowGround::Patch within;
    std::copy_if(patch.begin(), patch.end(), std::back_inserter(within),
                 [](const ShallowGround::Cell& cell) { return !cell.on_rim; });
    return within.empty() ? patch : within;
}

Hatch bestHatch(const ShallowGround::Patch& patch, const CutterForm& form, const LineSpacing& spacing,
                double cell_mm) {
    Hatch best;
    double least_mm = std::numeric_limits<double>::infinity();
    const ShallowGround::Patch within = withinRim(patch);
    std::vector<double> apart_mm(within.size());
    for (int i = 0; i < kDirections; ++i) {
        const double angle = std::numbers::pi * i / kDirections;
        const Vec2 along(std::cos(angle), std::sin(angle));
        const Vec2 across(-along.y(), along.x());
        double first_mm = std::numeric_limits<double>::infinity();
        double last_mm = -first_mm;
        for (const ShallowGround::Cell& cell : patch) {
            first_mm = std::min(first_mm, across.dot(cell.at));
            last_mm = std::max(last_mm, across.dot(cell.at));
        }
        std::transform(within.begin(), within.end(), apart_mm.begin(),
                       [&](const ShallowGround::Cell& cell) { return apartMm(cell, along, form, spacing); });
        const auto asked = apart_mm.begin() +
                           static_cast<std::ptrdiff_t>(kLeftOutShare * static_cast<double>(apart_mm.size()));
        std::nth_element(apart_mm.begin(), asked, apart_mm.end());
        const double cut_mm = static_cast<double>(patch.size()) * cell_mm * cell_mm / *asked;
        const double long_mm = cut_mm + kTurnMm * (last_mm - first_mm) / *asked;
        if (long_mm < least_mm) {
            least_mm = long_mm;
            best = {along, *asked, long_mm};
        }
    }
    return best;
}

struct Line {
    Vec2 from = Vec2::Zero();
    Vec2 to = Vec2::Zero();
};

class LineMaker {
  public:
    LineMaker(const ShallowGround& ground, const FormFloor& floor, const CutterForm& form,
              const Tolerances& tol)
        : ground_(ground), floor_(floor), radius_mm_(form.fullRadiusMm()), tol_(tol) {}

    std::vector<SurfaceWay> over(const ShallowGround::Patch& patch, const Hatch& hatch) const {
        const std::vector<Line> stretches = stretchesOver(patch, hatch);
        std::vector<SurfaceWay> ways(stretches.size());
        parallelFor(stretches.size(),
                    [&](std::size_t i) { ways[i] = wayOver(stretches[i].from, stretches[i].to); });
        return joined(std::move(ways));
    }

  private:
    std::vector<Line> stretchesOver(const ShallowGround::Patch& patch, const Hatch& hatch) const {
        const Vec2 across(-hatch.along.y(), hatch.along.x());
        Box2 extent;
        for (const ShallowGround::Cell& cell : patch)
            extent.extend(Vec2(hatch.along.dot(cell.at), across.dot(cell.at)));
        const double wide_mm = extent.sizes().y();
        const int lines = static_cast<int>(std::ceil(wide_mm / hatch.apart_mm)) + 1;
        std::vector<Line> found;
        for (int i = 0; i < lines; ++i) {
            const double at_mm = extent.min().y() + (lines > 1 ? wide_mm * i / (lines - 1) : wide_mm / 2);
            const Vec2 from = hatch.along * (extent.min().x() - ground_.cellMm()) + across * at_mm;
            const Vec2 to = hatch.along * (extent.max().x() + ground_.cellMm()) + across * at_mm;
            const Path whole{snapToGrid(from), {{snapToGrid(to), std::nullopt}}};
            for (const Path& piece : split(whole, ground_.centres(), tol_).inside)
                addShallow({piece.start, piece.segments.back().to}, found);
        }
        return found;
    }

    /// What of a line lies over shallow ground, a cell longer at both ends.
    void addShallow(const Line& line, std::vector<Line>& into) const {
        const double long_mm = (line.to - line.from).norm();
        const int steps = std::max(1, static_cast<int>(std::ceil(2 * long_mm / ground_.cellMm())));
        const double bridge = kBridgeRadii * radius_mm_ / long_mm;
        const double beyond = ground_.cellMm() / long_mm;
        std::optional<double> begun;
        double seen = 0;
        const auto end = [&] {
            if (!begun || seen - *begun <= 0) return;
            const double first = std::max(0.0, *begun - beyond);
            const double last = std::min(1.0, seen + beyond);
            into.push_back({snapToGrid(Vec2(line.from + first * (line.to - line.from))),
                            snapToGrid(Vec2(line.from + last * (line.to - line.from)))});
        };
        for (int i = 0; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            if (!ground_.isUnder(line.from + share * (line.to - line.from))) continue;
            if (begun && share - seen > bridge) {
                end();
                begun.reset();
            }
            if (!begun) begun = share;
            seen = share;
        }
        end();
    }

    /// As low as may be between the two points, and a little over it, as the proof asks.
    SurfaceWay wayOver(const Vec2& from, const Vec2& to) const {
        const std::vector<Vec2> ends = piecesOver(from, to);
        const std::vector<double> lowest_mm = floor_.over(ends);
        SurfaceWay way;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const double before_mm = lowest_mm[i == 0 ? 0 : i - 1];
            const double after_mm = lowest_mm[i == lowest_mm.size() ? i - 1 : i];
            const double tip_mm = std::max(before_mm, after_mm) + kSlopeRiseMm;
            way.emplace_back(ends[i].x(), ends[i].y(), upOnHeightStep(tip_mm));
        }
        return smoothed(way);
    }

    /// The ends of pieces so short that the ground rises little over each: by how steep it is over each of
    /// its short stretches.
    std::vector<Vec2> piecesOver(const Vec2& from, const Vec2& to) const {
        const int stretches = std::max(1, static_cast<int>(std::ceil((to - from).norm() / kStretchMm)));
        const double long_mm = (to - from).norm() / stretches;
        const int least = std::max(2, static_cast<int>(std::ceil(long_mm / kLongestPieceMm)));
        const int most = std::max(least, static_cast<int>(long_mm / kShortestPieceMm));
        const std::vector<double> lowest_mm = floor_.over(equalPieces(from, to, stretches * least));
        const std::vector<Vec2> marks = equalPieces(from, to, stretches);
        std::vector<Vec2> ends{from};
        for (int i = 0; i < stretches; ++i) {
            const auto first = lowest_mm.begin() + static_cast<std::ptrdiff_t>(i) * least;
            const auto [low, high] = std::minmax_element(first, first + least);
            const int pieces =
                std::clamp(static_cast<int>(std::ceil((*high - *low) / kPieceRiseMm)), least, most);
            const std::vector<Vec2> stretch = equalPieces(marks[i], marks[i + 1], pieces);
            ends.insert(ends.end(), stretch.begin() + 1, stretch.end());
        }
        return ends;
    }

    /// The same way or a little above it in fewer moves.
    static SurfaceWay smoothed(const SurfaceWay& way) {
        SurfaceWay moves{way.front()};
        std::size_t from = 0;
        while (from + 1 < way.size()) {
            std::size_t to = from + 1;
            while (to + 1 < way.size() && isSmooth(way, from, to + 1))
                ++to;
            moves.push_back(way[to]);
            from = to;
        }
        return moves;
    }

    /// Is the straight line nowhere below the way between, and nowhere much above it?
    static bool isSmooth(const SurfaceWay& way, std::size_t from, std::size_t to) {
        const double long_mm = (way[to] - way[from]).head<2>().norm();
        for (std::size_t i = from + 1; i < to; ++i) {
            const double share = (way[i] - way[from]).head<2>().norm() / long_mm;
            const double over_mm = way[from].z() + share * (way[to].z() - way[from].z()) - way[i].z();
            if (over_mm < 0 || over_mm > kSmoothMm) return false;
        }
        return true;
    }

    /// One after the other, the nearest end next, and joined over the ground where that is short.
    std::vector<SurfaceWay> joined(std::vector<SurfaceWay> ways) const {
        std::vector<SurfaceWay> chains;
        while (!ways.empty()) {
            std::size_t next = 0;
            bool turned = false;
            if (!chains.empty()) {
                const Vec2 at = chains.back().back().head<2>();
                double least_mm = std::numeric_limits<double>::infinity();
                for (std::size_t i = 0; i < ways.size(); ++i)
                    for (const bool backwards : {false, true}) {
                        const Vec3& start = backwards ? ways[i].back() : ways[i].front();
                        const double away_mm = (start.head<2>() - at).norm();
                        if (away_mm >= least_mm) continue;
                        least_mm = away_mm;
                        next = i;
                        turned = backwards;
                    }
            }
            SurfaceWay way = std::move(ways[next]);
            ways.erase(ways.begin() + static_cast<std::ptrdiff_t>(next));
            if (turned) std::reverse(way.begin(), way.end());
            if (chains.empty() || !join(chains.back(), way)) chains.push_back(std::move(way));
        }
        return chains;
    }

    bool join(SurfaceWay& chain, const SurfaceWay& way) const {
        const Vec2 from = chain.back().head<2>();
        const Vec2 to = way.front().head<2>();
        if ((to - from).norm() > kLinkRadii * radius_mm_) return false;
        if (to != from) {
            const Path link{from, {{to, std::nullopt}}};
            if (!split(link, ground_.centres(), tol_).outside.empty()) return false;
            const SurfaceWay over = wayOver(from, to);
            const double most_mm = std::max(chain.back().z(), way.front().z()) + kLinkRiseMm;
            if (std::any_of(over.begin(), over.end(), [&](const Vec3& p) { return p.z() > most_mm; }))
                return false;
            chain.insert(chain.end(), over.begin(), over.end());
        }
        chain.insert(chain.end(), way.begin(), way.end());
        chain.erase(std::unique(chain.begin(), chain.end()), chain.end());
        return true;
    }

    const ShallowGround& ground_;
    const FormFloor& floor_;
    double radius_mm_;
    const Tolerances& tol_;
};

}  // namespace

double surfacePassesMm(const ShallowGround& ground, const CutterForm& form, const LineSpacing& spacing) {
    double sum = 0;
    for (const ShallowGround::Patch& patch : ground.patches())
        sum += bestHatch(patch, form, spacing, ground.cellMm()).long_mm;
    return sum;
}

std::vector<SurfaceWay> surfacePasses(const ShallowGround& ground, const FormFloor& floor,
                                      const CutterForm& form, const LineSpacing& spacing,
                                      const Tolerances& tol) {
    const LineMaker maker(ground, floor, form, tol);
    std::vector<SurfaceWay> ways;
    for (const ShallowGround::Patch& patch : ground.patches())
        for (SurfaceWay& way : maker.over(patch, bestHatch(patch, form, spacing, ground.cellMm())))
            ways.push_back(std::move(way));
    return ways;
}

}  // namespace stepmill::toolpath
