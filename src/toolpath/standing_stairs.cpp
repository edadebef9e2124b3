// What flat layers left over leaning walls, while form cutters take it off.

#include "stepmill/toolpath/standing_stairs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "stepmill/core/parallel.h"
#include "stepmill/feature/heights.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/edge_index.h"
#include "stepmill/planar/unsure_offset.h"
#include "stepmill/planar/walk_inside.h"
#include "stepmill/toolpath/swept_region.h"

namespace stepmill {
namespace {

/// Heights at which the stairs are known are at least this far apart, but for the bands' own ends [mm].
constexpr double kSliceMm = 0.1;
/// Ways farther below a slice than the cutter's form is high, and this much, add nothing to it [mm].
constexpr double kBelowFormMm = 0.5;
/// Cuts thinner than this do not count [mm].
constexpr double kSkinMm = 2e-3;
/// Over ways that go up and down the cutter counts with the radius that it has so far over its tip [mm].
constexpr double kCountedOverTipMm[] = {0.05, 0.5};

/// The band over that height, the upper one where two meet.
const Obstacle* bandAt(const std::vector<Obstacle>& bands, double z_mm) {
    const auto found = std::find_if(bands.begin(), bands.end(), [&](const Obstacle& band) {
        return band.bottom_z_mm <= z_mm + kSameHeightMm && z_mm + kSameHeightMm < band.top_z_mm;
    });
    return found == bands.end() ? nullptr : &*found;
}

/// Where slices end: at the ends of every stair, and at those of bands between that are kSliceMm apart or
/// more.
std::vector<double> endsOfSlices(const Obstacle& stair, const std::vector<Obstacle>& bands) {
    std::vector<double> ends{stair.bottom_z_mm};
    double last_mm = stair.bottom_z_mm;  // of a band
    const auto end = [&](double z_mm) {
        if (z_mm - ends.back() > kSliceMm + kSameHeightMm && last_mm > ends.back() + kSameHeightMm)
            ends.push_back(last_mm);
        last_mm = z_mm;
    };
    for (const Obstacle& band : bands)
        if (band.top_z_mm > stair.bottom_z_mm + kSameHeightMm &&
            band.top_z_mm < stair.top_z_mm - kSameHeightMm)
            end(band.top_z_mm);
    end(stair.top_z_mm);
    ends.push_back(stair.top_z_mm);
    return ends;
}

/// What of a region lies in each of several places apart from each other; places with nothing are left out.
std::vector<Region> inPlaces(const Region& region, const std::vector<Region>& places) {
    std::vector<Region> parts;
    for (const Region& place : places) {
        Region part;
        for (const Loop& loop : region.loops)
            if (contains(place, loop.start)) part.loops.push_back(loop);
        if (!part.empty()) parts.push_back(std::move(part));
    }
    return parts;
}

/// What a disc sweeps along one way, for several radii. Safe to share between threads.
class SweptWay {
  public:
    SweptWay(const Path& way, const Tolerances& tol) : edges_(edgesOf(way)), at_(way.start), tol_(tol) {
        box_ = boundingBox(way);
        box_.extend(way.start);
        if (way.closed()) around_.emplace(Region{{signedArea(way) > 0 ? way : reversed(way)}}, tol);
    }

    /// False where the disc cuts nothing of the region.
    bool takeFrom(Region& region, double radius_mm) const {
        if (region.empty() || !grown(box_, radius_mm).intersects(boundingBox(region))) return false;
        if (edges_.empty()) return takeDisc(region, radius_mm);
        const IndexedRegion indexed(region);
        std::size_t count = 0;
        const std::vector<Path> near = stretchesNear(WalkInside(indexed), radius_mm, count);
        if (near.empty()) return false;
        const bool around = around_ && 2 * count > edges_.size() && takeAround(region, radius_mm);
        if (!around) region = toolpath::notSwept(region, near, radius_mm, tol_);
        return true;
    }

  private:
    /// Of a way without length.
    bool takeDisc(Region& region, double radius_mm) const {
        Region left = toolpath::notSwept(region, {{at_, {}}}, radius_mm, tol_);
        const bool cuts = area(left) < area(region);
        if (cuts) region = std::move(left);
        return cuts;
    }

    /// The stretches of the way on which the disc cuts, and how many edges they have.
    std::vector<Path> stretchesNear(WalkInside walk, double radius_mm, std::size_t& count) const {
        std::vector<Path> near;
        bool goes_on = false;
        for (const Edge& edge : edges_) {
            const bool meets = walk.meets(edge, radius_mm - kSkinMm);
            if (meets && !goes_on) near.push_back({edge.from, {}});
            if (meets) near.back().segments.push_back(edge.segment);
            if (meets) ++count;
            goes_on = meets;
        }
        return near;
    }

    /// Round a closed way the disc sweeps what lies within its radius on both sides. False where the offsets
    /// of a way that was rounded in a program are not sure.
    bool takeAround(Region& region, double radius_mm) const {
        try {
            Region ring = around_->offset(radius_mm);
            // Nowhere do the two come nearer than twice the radius: together they are a region.
            if (!intersect(region, around_->region(), tol_).empty())
                for (const Loop& loop : around_->offset(-radius_mm).loops)
                    ring.loops.push_back(reversed(loop));
            region = subtract(region, ring, tol_);
            return true;
        } catch (const UnsureOffset&) {
            return false;
        }
    }

    std::vector<Edge> edges_;
    Vec2 at_;  ///< where it begins
    const Tolerances& tol_;
    Box2 box_;
    std::optional<ClearanceDiagram> around_;  ///< of the ground that a closed way encloses
};

/// Joins moves to ways, and parts a way where it comes back to a point it has been at.
class WayBuilder {
  public:
    explicit WayBuilder(std::vector<Path>& into) : into_(into) {}

    void begin(const Vec2& at) {
        end();
        way_ = {at, {}};
        seen_ = {{{at.x(), at.y()}, 0}};
    }

    void add(const Segment& segment) {
        way_.segments.push_back(segment);
        const auto [found, is_new] =
            seen_.try_emplace({segment.to.x(), segment.to.y()}, way_.segments.size());
        if (is_new) return;
        const auto loop_begin = way_.segments.begin() + static_cast<std::ptrdiff_t>(found->second);
        into_.push_back({segment.to, {loop_begin, way_.segments.end()}});
        way_.segments.erase(loop_begin, way_.segments.end());
        const std::size_t left = way_.segments.size();
        std::erase_if(seen_, [&](const auto& entry) { return entry.second > left; });
    }

    void end() {
        if (!way_.segments.empty()) into_.push_back(std::move(way_));
        way_ = {};
    }

  private:
    std::vector<Path>& into_;
    Path way_;
    std::map<std::pair<double, double>, std::size_t> seen_;  ///< points by the number of segments before them
};

}  // namespace

StandingStairs::StandingStairs(const FormGround& ground, const Tolerances& tol) : tol_(tol) {
    const std::vector<Region> places = components(ground.window);
    for (const Obstacle& stair : ground.stairs) {
        const std::vector<double> ends = endsOfSlices(stair, ground.must_stand);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            addSlices(stair, ends[i], ends[i + 1], ground.must_stand, places);
    }
}

/// Half-way up the band's section covers the part, and the cutter has the radius that it has there.
void StandingStairs::addSlices(const Obstacle& stair, double bottom_mm, double top_mm,
                               const std::vector<Obstacle>& bands, const std::vector<Region>& places) {
    const double middle_mm = (bottom_mm + top_mm) / 2;
    const Obstacle* band = bandAt(bands, middle_mm);
    if (band == nullptr) return;
    const Region left = toolpath::beyondSkins(subtract(stair.section, band->section, tol_), tol_);
    for (Region& place : inPlaces(left, places))
        slices_.push_back({middle_mm, bottom_mm, top_mm, std::move(place)});
}

double StandingStairs::volumeMm3() const {
    double sum = 0;
    for (const Slice& slice : slices_)
        sum += area(slice.region) * slice.height_mm();
    return sum;
}

void StandingStairs::cut(const LevelWays& level, const CutterForm& form) {
    std::vector<SweptWay> ways;
    ways.reserve(level.ways.size());
    for (const Path& way : level.ways)
        ways.emplace_back(way, tol_);
    parallelFor(slices_.size(), [&](std::size_t i) {
        Slice& slice = slices_[i];
        const double over_mm = slice.z_mm - level.tip_z_mm;
        const double radius_mm = form.radiusAt(over_mm);
        if (slice.region.empty() || radius_mm <= kSkinMm || over_mm > form.heightMm() + kBelowFormMm) return;
        bool changed = false;
        for (const SweptWay& way : ways)
            changed = way.takeFrom(slice.region, radius_mm) || changed;
        if (changed) slice.region = toolpath::beyondSkins(slice.region, tol_);
    });
}

namespace {

/// Goes on straight to a point; the point before falls out where it lies on that way.
void goOn(Path& path, const Vec2& to) {
    if (path.segments.size() > 1) {
        const Vec2& start = path.segments[path.segments.size() - 2].to;
        const Vec2 along = to - start;
        const Vec2 last = path.segments.back().to - start;
        const bool in_line = std::abs(cross(along, last)) < kSkinMm / 2 * along.norm();
        if (in_line && along.dot(last) > 0 && last.norm() <= along.norm()) path.segments.pop_back();
    }
    const Vec2& at = path.segments.empty() ? path.start : path.segments.back().to;
    if (to != at) path.segments.push_back({to, std::nullopt});
}

/// What of the ways lies at or below a height, seen from above, as far as a disc on it may meet the region.
std::vector<Path> waysBelow(const std::vector<SurfaceWay>& ways, double z_mm, const IndexedRegion& region,
                            double radius_mm) {
    WalkInside walk(region);
    std::vector<Path> below;
    for (const SurfaceWay& way : ways) {
        bool goes_on = false;
        for (std::size_t i = 0; i + 1 < way.size(); ++i) {
            const Vec3& a = way[i];
            const Vec3& b = way[i + 1];
            const Edge line = makeLine(a.head<2>(), b.head<2>());
            if (std::min(a.z(), b.z()) > z_mm || !walk.meets(line, radius_mm)) {
                goes_on = false;
                continue;
            }
            // Where it goes through the height.
            const auto through = [&] {
                return snapToGrid(Vec2((a + (z_mm - a.z()) / (b.z() - a.z()) * (b - a)).head<2>()));
            };
            if (!goes_on || a.z() > z_mm) below.push_back({a.z() > z_mm ? through() : line.from, {}});
            goOn(below.back(), b.z() > z_mm ? through() : line.to());
            goes_on = b.z() <= z_mm;
        }
    }
    return below;
}

/// Moves, the first and the one after the last.
using Run = std::pair<std::size_t, std::size_t>;

/// Straight feeds one after another, some of which go up or down sideways.
std::vector<Run> surfaceRuns(const Vec3& start, const std::vector<Move>& moves) {
    std::vector<Run> runs;
    Vec3 from = start;
    std::size_t first = 0;
    bool slopes = false;
    const auto end = [&](std::size_t at) {
        if (slopes) runs.emplace_back(first, at);
        first = at + 1;
        slopes = false;
    };
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const Move& move = moves[i];
        if (move.kind == MoveKind::Rapid || move.arc)
            end(i);
        else if (move.to.head<2>() != from.head<2>() && std::abs(move.to.z() - from.z()) > kSameHeightMm)
            slopes = true;
        from = move.to;
    }
    end(moves.size());
    return runs;
}

}  // namespace

void StandingStairs::cut(const std::vector<SurfaceWay>& ways, const CutterForm& form) {
    if (ways.empty()) return;
    parallelFor(slices_.size(), [&](std::size_t i) {
        Slice& slice = slices_[i];
        const IndexedRegion before(slice.region);
        bool changed = false;
        for (const double over_mm : kCountedOverTipMm) {
            if (slice.region.empty()) return;
            const double radius_mm = form.radiusAt(over_mm) - kSkinMm;
            const std::vector<Path> below = waysBelow(ways, slice.z_mm - over_mm, before, radius_mm);
            if (below.empty()) continue;
            slice.region = toolpath::notSwept(slice.region, below, radius_mm, tol_);
            changed = true;
        }
        if (changed) slice.region = toolpath::beyondSkins(slice.region, tol_);
    });
}

std::vector<SurfaceWay> surfaceWays(const Vec3& start, const std::vector<Move>& moves) {
    std::vector<SurfaceWay> ways;
    for (const auto& [first, last] : surfaceRuns(start, moves)) {
        SurfaceWay& way = ways.emplace_back();
        way.push_back(first == 0 ? start : moves[first - 1].to);
        for (std::size_t i = first; i < last; ++i)
            way.push_back(moves[i].to);
    }
    return ways;
}

std::vector<LevelWays> levelWays(const Vec3& start, const std::vector<Move>& moves) {
    std::map<double, std::vector<Path>, std::greater<>> by_height;
    std::optional<WayBuilder> way;
    Vec3 from = start;
    bool came_down = false;  // and has not moved since
    std::vector<char> over_surface(moves.size(), 0);
    for (const auto& [first, last] : surfaceRuns(start, moves))
        std::fill(over_surface.begin() + static_cast<std::ptrdiff_t>(first),
                  over_surface.begin() + static_cast<std::ptrdiff_t>(last), 1);
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const Move& move = moves[i];
        const bool level = move.kind != MoveKind::Rapid && over_surface[i] == 0 &&
                           std::abs(from.z() - move.to.z()) < kSameHeightMm;
        if (came_down && !level) by_height[from.z()].push_back({Vec2(from.head<2>()), {}});
        came_down = move.kind != MoveKind::Rapid && over_surface[i] == 0 &&
                    move.to.z() < from.z() - kSameHeightMm && move.to.head<2>() == from.head<2>();
        if (!level && way) {
            way->end();
            way.reset();
        }
        if (level && !way) {
            way.emplace(by_height[move.to.z()]);
            way->begin(from.head<2>());
        }
        if (level) way->add({Vec2(move.to.head<2>()), move.arc});
        from = move.to;
    }
    if (way) way->end();
    std::vector<LevelWays> levels;
    levels.reserve(by_height.size());
    for (auto& [z_mm, ways] : by_height)
        levels.push_back({z_mm, std::move(ways)});
    return levels;
}

}  // namespace stepmill
