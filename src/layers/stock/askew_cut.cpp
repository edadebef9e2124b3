// Cuts along axes askew to a setup's.

#include "layers/stock/askew_cut.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "layers/clip_polygon.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"

namespace stepmill::layers {

namespace {

/// Arcs become polygons that stay this near to them [mm]. They leave that much stock standing on walls that
/// earlier setups cut along other axes; finer ones cost every slab edges and tell no more.
constexpr double kAskewChordMm = 0.02;

/// Adds an arc as a polygon on the region's side of it: chords where the region lies inside the circle,
/// tangents where it lies outside.
void addArc(const Vec2& from, const Segment& segment, double sagitta_mm, std::vector<Vec2>& corners) {
    const Arc& arc = *segment.arc;
    const double sweep = sweepAngle(from, segment.to, arc);
    const double widest = 2 * std::acos(1 - std::min(sagitta_mm / arc.radius_mm, 0.5));
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / widest)));
    const double step = sweep / parts;
    const double start = std::atan2(from.y() - arc.centre.y(), from.x() - arc.centre.x());
    const double reach = arc.ccw ? arc.radius_mm : arc.radius_mm / std::cos(step / 2);
    for (int i = 0; i < parts; ++i) {
        const double angle = start + (arc.ccw ? i + 1 : i + 0.5) * step;
        if (arc.ccw && i + 1 == parts) break;
        corners.push_back(arc.centre + reach * Vec2(std::cos(angle), std::sin(angle)));
    }
    corners.push_back(segment.to);
}

Loop closedPath(const std::vector<Vec2>& corners) {
    Loop loop;
    loop.start = snapToGrid(corners.front());
    for (std::size_t i = 1; i <= corners.size(); ++i)
        loop.segments.push_back({snapToGrid(corners[i % corners.size()]), std::nullopt});
    return loop;
}

/// Polygons within the region. Of a loop thinner than its arcs' sagitta nothing may lie within: the polygon
/// turns over and is left out, so that the cut takes less.
Region insidePolygon(const Region& region) {
    Region inside;
    for (const Loop& loop : region.loops) {
        std::vector<Vec2> corners;
        for (const auto& [from, segment] : eachEdge(loop)) {
            if (segment.arc)
                addArc(from, segment, kAskewChordMm, corners);
            else
                corners.push_back(segment.to);
        }
        Loop polygon = closedPath(corners);
        if ((signedArea(polygon) > 0) == (signedArea(loop) > 0)) inside.loops.push_back(std::move(polygon));
    }
    return inside;
}

std::vector<Vec2> clipped(const std::vector<Vec2>& corners, const HalfPlane& half) {
    std::vector<Vec2> kept;
    clipPolygon(
        std::span(corners), [&](const Vec2& p) { return half.inside(p); },
        [](const Vec2& a, const Vec2& b, double share) { return snapToGrid(Vec2(a + share * (b - a))); },
        [&](const Vec2& p) { kept.push_back(p); });
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    while (kept.size() > 1 && kept.front() == kept.back())
        kept.pop_back();
    return kept;
}

/// The polygons' part in all of the half planes. Mostly they lie in each or beside it as a whole.
Region clipped(const Region& polygons, const std::vector<HalfPlane>& halves) {
    Region inside;
    for (const Loop& loop : polygons.loops) {
        std::vector<Vec2> corners;
        for (const Segment& segment : loop.segments)
            corners.push_back(segment.to);
        for (const HalfPlane& half : halves) {
            const auto is_out = [&](const Vec2& p) { return half.inside(p) < 0; };
            if (std::any_of(corners.begin(), corners.end(), is_out)) corners = clipped(corners, half);
        }
        if (corners.size() > 2) inside.loops.push_back(closedPath(corners));
    }
    return inside;
}

void addSides(const Box2& box, std::vector<HalfPlane>& halves) {
    for (int axis = 0; axis < 2; ++axis) {
        halves.push_back({Vec2::Unit(axis), box.max()[axis]});
        halves.push_back({-Vec2::Unit(axis), -box.min()[axis]});
    }
}

/// How a way crosses the boundary of a region.
enum class WallCrossing { Leaves, Enters };

/// What meets the walls of a loop on its way: the ground between each run of edges that the way crosses like
/// that and the run moved back.
void addSwept(const Loop& loop, const Vec2& travel, WallCrossing how, const Box2& reached,
              std::vector<Region>& into) {
    std::vector<Vec2> run;
    const auto finish = [&] {
        Box2 wall;
        for (const Vec2& p : run)
            wall.extend(p);
        if (run.size() > 1 && wall.intersects(reached)) {
            for (std::size_t i = run.size(); i > 0; --i)
                run.push_back(run[i - 1] - travel);
            // Edges that are entered run against those that are left.
            if (how == WallCrossing::Enters) std::reverse(run.begin(), run.end());
            into.push_back(makePolygon(run));
        }
        run.clear();
    };
    for (const auto& [from, segment] : eachEdge(loop)) {
        const double turn = cross(travel, segment.to - from);
        const bool crosses = how == WallCrossing::Leaves ? turn > kGridMm : turn < -kGridMm;
        if (!crosses) finish();
        if (crosses && run.empty()) run.push_back(from);
        if (crosses) run.push_back(segment.to);
    }
    finish();
}

/// Points of `from_where`, inside the outline, that stay inside all the way to where `travel` takes them.
Region staysInside(const Region& from_where, const Region& outline, const Vec2& travel,
                   const Tolerances& tol) {
    const Box2 reached = grown(boundingBox(from_where), travel.norm());
    std::vector<Region> meets_wall;
    for (const Loop& loop : outline.loops)
        addSwept(loop, travel, WallCrossing::Leaves, reached, meets_wall);
    return subtract(from_where, meets_wall, tol);
}

}  // namespace

AskewCut::AskewCut(const Prism& prism, const Eigen::Isometry3d& to_setup)
    : outline_(insidePolygon(prism.region)),
      top_mm_(prism.top_z_mm),
      bottom_mm_(prism.bottom_z_mm),
      to_setup_(to_setup),
      up_(to_setup.linear().transpose() * Vec3::UnitZ()) {
    for (Region& piece : components(outline_)) {
        const Box2 box = boundingBox(piece);
        pieces_.push_back({std::move(piece), box});
    }
    for (const Loop& loop : outline_.loops) {
        for (const Segment& segment : loop.segments) {
            for (const double reach : {top_mm_, bottom_mm_}) {
                const double z = (to_setup_ * Vec3(segment.to.x(), segment.to.y(), reach)).z();
                low_mm_ = std::min(low_mm_, z);
                high_mm_ = std::max(high_mm_, z);
            }
        }
    }
}

Region AskewCut::between(double low_mm, double high_mm, const Tolerances& tol,
                         const std::optional<Box2>& near) const {
    const double rise_mm = high_mm - low_mm;
    const double along_mm = rise_mm * up_.z();
    const std::optional<Window> window =
        windowAt(low_mm, high_mm, std::max(bottom_mm_, bottom_mm_ - along_mm),
                 std::min(top_mm_, top_mm_ - along_mm), near);
    if (!window) return {};
    Region inside;
    for (const Piece& piece : pieces_) {
        if (!piece.box.intersects(window->box)) continue;
        Region part = clipped(piece.region, window->sides);
        std::move(part.loops.begin(), part.loops.end(), std::back_inserter(inside.loops));
    }
    if (rise_mm > 0 && !inside.empty()) inside = staysInside(inside, outline_, up_.head<2>() * rise_mm, tol);
    return toSetup(inside, low_mm);
}

std::vector<Region> AskewCut::somewhere(double low_mm, double high_mm,
                                        const std::optional<Box2>& near) const {
    const double rise_mm = high_mm - low_mm;
    const double along_mm = rise_mm * up_.z();
    const std::optional<Window> window =
        windowAt(low_mm, high_mm, std::min(bottom_mm_, bottom_mm_ - along_mm),
                 std::max(top_mm_, top_mm_ - along_mm), near);
    if (!window) return {};
    const Vec2 travel = up_.head<2>() * rise_mm;
    const Box2 reached = grown(window->box, travel.norm());
    // Points inside, and those that come in on the way.
    std::vector<Region> inside;
    for (const Piece& piece : pieces_) {
        if (!piece.box.intersects(reached)) continue;
        inside.push_back(piece.region);
        for (const Loop& loop : piece.region.loops)
            addSwept(loop, travel, WallCrossing::Enters, reached, inside);
    }
    for (Region& part : inside)
        part = toSetup(clipped(part, window->sides), low_mm);
    std::erase_if(inside, [](const Region& part) { return part.empty(); });
    return inside;
}

BandedPolygon AskewCut::at(double z_mm) const {
    const double base = z_mm - to_setup_.translation().z();
    const auto seen = [&](const Vec2& p) {
        const double reach = (base - up_.head<2>().dot(p)) / up_.z();
        return Vec2((to_setup_ * Vec3(p.x(), p.y(), reach)).head<2>());
    };
    BandedPolygon section;
    for (const Loop& loop : outline_.loops) {
        Vec2 from = seen(loop.start);
        for (const Segment& segment : loop.segments) {
            const Vec2 to = seen(segment.to);
            section.sides.push_back({from, to});
            from = to;
        }
    }
    // Heights along the prism's own axis lie between its ends.
    const Vec3 axis = to_setup_.linear().col(2);
    const double raised = axis.z() * z_mm - axis.dot(to_setup_.translation());
    section.across = axis.head<2>();
    section.low = bottom_mm_ - raised;
    section.high = top_mm_ - raised;
    return section;
}

/// The ground that is asked for, on that of the prism: where a point of the setup's plane at the lower height
/// lies between two places along the prism's axis, and near the box, if it is given. Nothing where the prism
/// does not reach.
std::optional<AskewCut::Window> AskewCut::windowAt(double low_mm, double high_mm, double lowest_mm,
                                                   double highest_mm, const std::optional<Box2>& near) const {
    if (outline_.empty() || high_mm <= low_mm_ || low_mm >= high_mm_ || lowest_mm >= highest_mm)
        return std::nullopt;
    const double base = low_mm - to_setup_.translation().z();
    const double aslant = up_.head<2>().norm();
    const double one = (base - up_.z() * lowest_mm) / aslant;
    const double other = (base - up_.z() * highest_mm) / aslant;
    const Vec2 across = up_.head<2>() / aslant;
    Window window{boundingBox(outline_), {{across, std::max(one, other)}, {-across, -std::min(one, other)}}};
    if (!near) return window;
    const Eigen::Isometry3d to_ground = to_setup_.inverse();
    window.box = Box2();
    for (const double x : {near->min().x(), near->max().x()})
        for (const double y : {near->min().y(), near->max().y()})
            window.box.extend(Vec2((to_ground * Vec3(x, y, low_mm)).head<2>()));
    // A little more, whatever the rounding.
    window.box = grown(window.box, kAskewChordMm);
    addSides(window.box, window.sides);
    return window;
}

Region AskewCut::toSetup(const Region& region, double z_mm) const {
    const double base = z_mm - to_setup_.translation().z();
    const bool mirrors = up_.z() < 0;
    Region result;
    for (const Loop& loop : region.loops) {
        std::vector<Vec2> corners;
        for (const Segment& segment : loop.segments) {
            const double reach = (base - up_.head<2>().dot(segment.to)) / up_.z();
            corners.push_back((to_setup_ * Vec3(segment.to.x(), segment.to.y(), reach)).head<2>());
        }
        if (mirrors) std::reverse(corners.begin(), corners.end());
        result.loops.push_back(closedPath(corners));
    }
    return result;
}

}  // namespace stepmill::layers
