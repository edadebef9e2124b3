// Passes of form cutters as one path.

#include <algorithm>
#include <cmath>

#include "stepmill/planar/boolean.h"
#include "stepmill/planar/path_parts.h"
#include "stepmill/toolpath/form_passes.h"
#include "stepmill/toolpath/path_frame.h"
#include "toolpath/emit.h"

namespace stepmill::toolpath {
namespace {

/// Ways at depth are no longer than this many diameters; farther ones go over the retract height.
constexpr double kLongestWayDiameters = 4;

/// The pass as it is run when the tool comes from there: a closed one from its nearest point.
Path startedNear(const Path& pass, const Vec2& from) {
    if (!pass.closed()) return pass;
    const NearestPoint nearest = nearestOn(pass, from);
    return startingAt(pass, nearest.edge, nearest.share);
}

double wayTo(const Path& pass, const Vec2& from) {
    return pass.closed() ? nearestOn(pass, from).distance_mm : (pass.start - from).norm();
}

class FormPathWriter {
  public:
    FormPathWriter(const FormTask& task, double radius_mm, const Machine& machine, const Tolerances& tol,
                   Toolpath& path)
        : task_(task),
          radius_mm_(radius_mm),
          beside_mm_(std::max(tol.guard_mm, machine.inside_clearance_mm)),
          over_top_mm_(std::max(kApproachMm, machine.top_clearance_mm)),
          tol_(tol),
          path_(path) {}

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
        goTo(pass.start, level);
        Vec2 from = pass.start;
        for (const Segment& segment : pass.segments) {
            if (segment.arc || segment.to != from)
                add(MoveKind::Feed, {segment.to.x(), segment.to.y(), level.tip_z_mm}, segment.arc);
            from = segment.to;
        }
        before_ = &level;
    }

    void goTo(const Vec2& to, const FormLevel& level) {
        if (path_.moves.empty()) {
            path_.start = at_ = {to.x(), to.y(), task_.retract_z_mm};
            return comeDown(to, level.tip_z_mm);
        }
        if (!isWay(to)) {
            add(MoveKind::Rapid, {at_.x(), at_.y(), task_.retract_z_mm});
            add(MoveKind::Rapid, {to.x(), to.y(), task_.retract_z_mm});
            return comeDown(to, level.tip_z_mm);
        }
        if (to != at_.head<2>()) add(MoveKind::Feed, {to.x(), to.y(), at_.z()});
        if (at_.z() > level.tip_z_mm) add(MoveKind::Plunge, {to.x(), to.y(), level.tip_z_mm});
    }

    /// Is the straight way at the height where the tool is short and free?
    bool isWay(const Vec2& to) const {
        const Vec2 from = at_.head<2>();
        if (task_.plain_ways || before_ == nullptr) return false;
        if ((to - from).norm() > kLongestWayDiameters * 2 * radius_mm_) return false;
        if (to == from) return true;
        return split({from, {{to, std::nullopt}}}, before_->free_centres, tol_).outside.empty();
    }

    /// Down in rapid as far as the whole width of the tool is clear of all that may stand, then at the feed.
    void comeDown(const Vec2& at, double z_mm) {
        double clear_mm = task_.ground.obstacles.empty() ? z_mm : task_.ground.obstacles.back().top_z_mm;
        for (std::size_t i = task_.ground.obstacles.size(); i-- > 0;) {
            const Obstacle& obstacle = task_.ground.obstacles[i];
            if (distanceToRegion(obstacle.section, at) <= radius_mm_ + beside_mm_) break;
            clear_mm = obstacle.bottom_z_mm;
        }
        const double over_mm = isRawTop(clear_mm) ? over_top_mm_ : kApproachMm;
        const double rapid_to_mm = std::max(clear_mm, z_mm) + over_mm;
        if (rapid_to_mm < at_.z()) add(MoveKind::Rapid, {at.x(), at.y(), rapid_to_mm});
        add(MoveKind::Plunge, {at.x(), at.y(), z_mm});
    }

    void add(MoveKind kind, const Vec3& to, const std::optional<Arc>& arc = std::nullopt) {
        path_.moves.push_back({kind, to, arc, false});
        at_ = to;
    }

    const FormTask& task_;
    double radius_mm_;
    double beside_mm_;    ///< rapids down keep this off what stands
    double over_top_mm_;  ///< they end so far over a raw top
    const Tolerances& tol_;
    Toolpath& path_;
    const FormLevel* before_ = nullptr;  ///< whose free centres the tool is in
    Vec3 at_ = Vec3::Zero();
};

}  // namespace

Toolpath formPath(const FormTask& task, const std::vector<FormLevel>& levels, const ToolAssembly& tool,
                  const CuttingData& cutting, const Machine& machine, const Tolerances& tol) {
    std::vector<const FormLevel*> cut;
    for (const FormLevel& level : levels)
        if (!level.passes.empty()) cut.push_back(&level);
    if (cut.empty()) return {};
    ClearingTask heights;
    heights.floor_z_mm = cut.back()->tip_z_mm;
    heights.top_z_mm = task.ground.stairs.back().top_z_mm;
    Toolpath path = pathFrame(heights, static_cast<int>(cut.size()), tool.radius_mm(), cutting, machine);
    // Levels without stairs fall out: between others it is farther than any cut is deep.
    if (cutting.step_down_mm > 0) path.step_down_mm = std::min(path.step_down_mm, cutting.step_down_mm);
    path.pattern = tool.isCountersink()               ? kCountersinkPattern
                   : tool.type == ToolType::Chamfer ? "chamfer pass"
                                                    : "z-levels";
    FormPathWriter writer(task, tool.radius_mm(), machine, tol, path);
    for (const FormLevel* level : cut)
        writer.write(*level);
    writer.end();
    path.totals = measure(path, machine);
    return path;
}

}  // namespace stepmill::toolpath
