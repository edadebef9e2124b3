// Passes of form cutters as one path.

#include <algorithm>
#include <cmath>
#include <limits>

#include "stepmill/access/collision.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/indexed_region.h"
#include "stepmill/planar/path_parts.h"
#include "stepmill/toolpath/form_passes.h"
#include "stepmill/toolpath/path_frame.h"
#include "toolpath/emit.h"

namespace stepmill::toolpath {
namespace {

/// Ways at depth are no longer than this many diameters; farther ones go over what stands between.
constexpr double kLongestWayDiameters = 4;

/// A program's places may be so far off [mm].
constexpr double kRoundingMm = 1e-3;

/// The tool may come down to a pass at so many places off its start, so many radii apart.
constexpr int kEntries = 8;
constexpr double kEntryRadii = 0.25;

/// The pass as it is run when the tool comes from there: a closed one from its nearest point.
Path startedNear(const Path& pass, const Vec2& from) {
    if (!pass.closed()) return pass;
    const NearestPoint nearest = nearestOn(pass, from);
    return startingAt(pass, nearest.edge, nearest.share);
}

double wayTo(const Path& pass, const Vec2& from) {
    return pass.closed() ? nearestOn(pass, from).distance_mm : (pass.start - from).norm();
}

/// What may stand, from below, each with all above it.
class StandingSections {
  public:
    explicit StandingSections(const std::vector<Obstacle>& obstacles) : obstacles_(obstacles) {
        sections_.reserve(obstacles.size());
        for (const Obstacle& obstacle : obstacles)
            sections_.emplace_back(obstacle.section);
    }

    /// Over what stands no farther from the way than that; -infinity where nothing does.
    double clearOver(const Edge& way, double distance_mm) const {
        for (std::size_t i = obstacles_.size(); i-- > 0;)
            if (sections_[i].isNear(way, distance_mm)) return obstacles_[i].top_z_mm;
        return -std::numeric_limits<double>::infinity();
    }

  private:
    const std::vector<Obstacle>& obstacles_;
    std::vector<IndexedRegion> sections_;
};

class FormPathWriter {
  public:
    FormPathWriter(const FormTask& task, const ToolAssembly& tool, const Machine& machine,
                   const Tolerances& tol, FormPath& written)
        : task_(task),
          radius_mm_(tool.radius_mm()),
          cylinders_(access::cylindersOf(tool)),
          over_retract_(task.plain_ways || tool.isCountersink()),
          standing_(task.ground.obstacles),
          window_(task.ground.window),
          beside_mm_(std::max(tol.guard_mm, machine.inside_clearance_mm)),
          over_top_mm_(std::max(kApproachMm, machine.top_clearance_mm)),
          tol_(tol),
          path_(written.path),
          between_(written.between) {}

    void write(const FormLevel& level) {
        std::vector<const Path*> left;
        for (const Path& pass : level.passes)
            left.push_back(&pass);
        while (!left.empty()) {
            const auto next = nextOf(left);
            writePass(startedNear(**next, at_.head<2>()), level);
            left.erase(next);
        }
        before_ = &level;
    }

    /// Straight down to where it begins, and from there on over the ground.
    void write(const SurfaceWay& line) {
        const Vec2 to = line.front().head<2>();
        goOver(to, line.front().z());
        comeDown(to, line.front().z());
        for (const Vec3& point : line) {
            if (point == at_) continue;
            const bool down = point.head<2>() == at_.head<2>() && point.z() < at_.z();
            const double feed = feedTowards(point);
            add(down ? MoveKind::Plunge : MoveKind::Feed, point);
            if (!down && feed < path_.feedOf(MoveKind::Feed)) path_.moves.back().feed_mm_per_min = feed;
        }
        before_ = nullptr;
    }

    void end() {
        if (!path_.moves.empty()) add(MoveKind::Rapid, {at_.x(), at_.y(), task_.retract_z_mm});
    }

  private:
    /// The nearest of those that lie equally far from the walls; they come in that order.
    std::vector<const Path*>::iterator nextOf(std::vector<const Path*>& left) const {
        if (path_.moves.empty()) return left.begin();
        return std::min_element(left.begin(), left.end(), [&](const Path* a, const Path* b) {
            return wayTo(*a, at_.head<2>()) < wayTo(*b, at_.head<2>());
        });
    }

    void writePass(const Path& pass, const FormLevel& level) {
        goTo(pass, level);
        Vec2 from = pass.start;
        for (const Segment& segment : pass.segments) {
            if (segment.arc || segment.to != from)
                add(MoveKind::Feed, {segment.to.x(), segment.to.y(), level.tip_z_mm}, segment.arc);
            from = segment.to;
        }
        before_ = &level;
    }

    void goTo(const Path& pass, const FormLevel& level) {
        const Vec2& to = pass.start;
        if (!path_.moves.empty() && isWay(to)) {
            feedAcross(to);
            if (at_.z() > level.tip_z_mm) add(MoveKind::Plunge, {to.x(), to.y(), level.tip_z_mm});
            return;
        }
        const Vec2 entry = entryOf(pass, level);
        goOver(entry, level.tip_z_mm);
        comeDown(entry, level.tip_z_mm);
        feedAcross(to);
    }

    /// Over a place, no lower than that height; there the path begins.
    void goOver(const Vec2& to, double z_mm) {
        if (path_.moves.empty()) {
            path_.start = at_ = {to.x(), to.y(), task_.retract_z_mm};
            return;
        }
        const double over_mm = std::max({crossingZ(to), at_.z(), z_mm});
        if (over_mm > at_.z()) add(MoveKind::Rapid, {at_.x(), at_.y(), over_mm});
        add(MoveKind::Rapid, {to.x(), to.y(), over_mm});
    }

    /// Straight over at the height where the tool is.
    void feedAcross(const Vec2& to) {
        if (to == at_.head<2>()) return;
        between_.push_back({at_.z(), {{at_.head<2>(), {{to, std::nullopt}}}}});
        add(MoveKind::Feed, {to.x(), to.y(), at_.z()});
    }

    /// No faster down than in a plunge, however the program rounds the move.
    double feedTowards(const Vec3& to) const {
        const double feed = path_.feedOf(MoveKind::Feed);
        const double drop_mm = at_.z() - to.z() + kRoundingMm;
        if (drop_mm <= kRoundingMm) return feed;
        const double sine = std::min(1.0, drop_mm / (to - at_).norm());
        return rampFeed(feed, path_.feedOf(MoveKind::Plunge), std::asin(sine));
    }

    /// Where the tool comes down to a pass: at its start or, where it is there sooner, some way off the wall.
    /// Beside the wall all that may stand there keeps a rapid up.
    Vec2 entryOf(const Path& pass, const FormLevel& level) const {
        if (over_retract_ || pass.segments.empty()) return pass.start;
        const Vec2 off_wall = leftOf(tangentAt(makeEdge(pass.start, pass.segments.front()), 0));
        Vec2 best = pass.start;
        double best_min = downMin(best, level.tip_z_mm);
        for (int i = 1; i <= kEntries; ++i) {
            const double away_mm = i * kEntryRadii * radius_mm_;
            const double across_min = away_mm / path_.feedOf(MoveKind::Feed);
            if (across_min >= best_min) break;
            const Vec2 entry = snapToGrid(Vec2(pass.start + away_mm * off_wall));
            const double entry_min = downMin(entry, level.tip_z_mm) + across_min;
            if (entry_min >= best_min) continue;
            if (!split({entry, {{pass.start, std::nullopt}}}, level.free_centres, tol_).outside.empty())
                break;
            best = entry;
            best_min = entry_min;
        }
        return best;
    }

    /// What the feed takes on the way down there [min].
    double downMin(const Vec2& at, double z_mm) const {
        return (rapidDownTo(at, z_mm) - z_mm) / path_.feedOf(MoveKind::Plunge);
    }

    /// How high the tip goes straight to another place: cutter, shank and holder keep off all that may stand.
    double crossingZ(const Vec2& to) const {
        const Edge way = makeLine(at_.head<2>(), to);
        // What stands beyond the window is known from the retract height on.
        if (over_retract_ || window_.anyNearer(way, radius_mm_ + tol_.guard_mm)) return task_.retract_z_mm;
        double tip_mm = overStanding(way, radius_mm_);
        for (const HolderCylinder& cylinder : cylinders_)
            tip_mm = std::max(tip_mm, overStanding(way, cylinder.diameter_mm / 2) - cylinder.bottom_mm);
        return std::min(tip_mm, task_.retract_z_mm);
    }

    /// Where a cylinder that goes along with the tool keeps off all that may stand, and a little over it.
    double overStanding(const Edge& way, double radius_mm) const {
        const double clear_mm = standing_.clearOver(way, radius_mm + beside_mm_);
        return clear_mm + overMm(clear_mm);
    }
    double overMm(double clear_mm) const { return isRawTop(clear_mm) ? over_top_mm_ : kApproachMm; }

    /// Is the straight way at the height where the tool is short and free?
    bool isWay(const Vec2& to) const {
        const Vec2 from = at_.head<2>();
        if (task_.plain_ways || before_ == nullptr) return false;
        if ((to - from).norm() > kLongestWayDiameters * 2 * radius_mm_) return false;
        if (to == from) return true;
        return split({from, {{to, std::nullopt}}}, before_->free_centres, tol_).outside.empty();
    }

    /// How far down a rapid may go there to a height: as far as the whole width of the tool is clear of all
    /// that may stand.
    double rapidDownTo(const Vec2& at, double z_mm) const {
        const double clear_mm = standing_.clearOver(makeLine(at, at), radius_mm_ + beside_mm_);
        return std::max(clear_mm, z_mm) + overMm(clear_mm);
    }

    /// Down in rapid, the rest at the feed.
    void comeDown(const Vec2& at, double z_mm) {
        const double rapid_to_mm = rapidDownTo(at, z_mm);
        if (rapid_to_mm < at_.z()) add(MoveKind::Rapid, {at.x(), at.y(), rapid_to_mm});
        add(MoveKind::Plunge, {at.x(), at.y(), z_mm});
    }

    void add(MoveKind kind, const Vec3& to, const std::optional<Arc>& arc = std::nullopt) {
        path_.moves.push_back({kind, to, arc, false});
        at_ = to;
    }

    const FormTask& task_;
    double radius_mm_;
    std::vector<HolderCylinder> cylinders_;
    bool over_retract_;  ///< all ways across; the holes of a cycle are gone to at one height
    StandingSections standing_;
    EdgeIndex window_;
    double beside_mm_;    ///< rapids keep this off what stands
    double over_top_mm_;  ///< they end so far over a raw top
    const Tolerances& tol_;
    Toolpath& path_;
    std::vector<LevelWays>& between_;
    const FormLevel* before_ = nullptr;  ///< whose free centres the tool is in
    Vec3 at_ = Vec3::Zero();
};

}  // namespace

FormPath formPath(const FormTask& task, const std::vector<FormLevel>& levels,
                  const std::vector<SurfaceWay>& lines, const ToolAssembly& tool, const CuttingData& cutting,
                  const Machine& machine, const Tolerances& tol) {
    std::vector<const FormLevel*> cut;
    for (const FormLevel& level : levels)
        if (!level.passes.empty()) cut.push_back(&level);
    if (cut.empty()) return {};
    ClearingTask heights;
    heights.floor_z_mm = cut.back()->tip_z_mm;
    heights.top_z_mm = task.ground.stairs.back().top_z_mm;
    FormPath written{pathFrame(heights, static_cast<int>(cut.size()), tool.radius_mm(), cutting, machine),
                     {}};
    Toolpath& path = written.path;
    // Levels without stairs fall out: between others it is farther than any cut is deep.
    if (cutting.step_down_mm > 0) path.step_down_mm = std::min(path.step_down_mm, cutting.step_down_mm);
    path.pattern = tool.isCountersink()             ? kCountersinkPattern
                   : tool.type == ToolType::Chamfer ? "chamfer pass"
                   : lines.empty()                  ? "z-levels"
                                                    : "z-levels + lines over the surface";
    FormPathWriter writer(task, tool, machine, tol, written);
    for (const FormLevel* level : cut)
        writer.write(*level);
    for (const SurfaceWay& line : lines)
        writer.write(line);
    writer.end();
    path.totals = measure(path, machine);
    return written;
}

}  // namespace stepmill::toolpath
