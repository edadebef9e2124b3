#include "toolpath/finishing/wall_leads.h"

#include <algorithm>

#include "toolpath/patterns/ring_family.h"

namespace stepmill::toolpath {

namespace {

/// The widest lead-in, as a share of the cutter's radius.
constexpr double kLeadShare = 0.5;
/// A lead-in no wider than the allowance would begin in material; this much wider it is tried last.
constexpr double kLeastLeadShare = 1.1;
/// How far beside the material a pass begins and ends past an open edge [mm].
constexpr double kRunOutMm = 1.0;

}  // namespace

WallLeads::WallLeads(const WallTask& task, double radius_mm, const Tolerances& tol)
    : task_(task),
      radius_mm_(radius_mm),
      tol_(tol),
      target_(task.clearing.target),
      cleared_(task.clearing.cleared_centres),
      obstruction_(task.clearing.obstruction) {
    for (const KeptOff& kept : task.clearing.kept_off)
        kept_.emplace_back(kept.section);
}

bool WallLeads::isFree(const Edge& way) const {
    if (obstruction_.isNear(way, radius_mm_ + tol_.guard_mm / 2)) return false;
    for (std::size_t i = 0; i < kept_.size(); ++i)
        if (kept_[i].isNear(way, task_.clearing.kept_off[i].distance_mm - tol_.guard_mm)) return false;
    return true;
}

bool WallLeads::isFree(const Path& way) const {
    const std::vector<Edge> edges = edgesOf(way);
    return std::all_of(edges.begin(), edges.end(), [&](const Edge& edge) { return isFree(edge); });
}

/// May the cutter go down there at any depth?
bool WallLeads::isAir(const Vec2& p) const {
    return cutsNothing(target_, radius_mm_, p, tol_) || cleared_.contains(p);
}

std::vector<double> WallLeads::radii() const {
    std::vector<double> radii;
    const double least_mm = kLeastLeadShare * task_.allowance_mm;
    double radius_mm = kLeadShare * radius_mm_;
    for (; radius_mm > least_mm; radius_mm /= 2)
        radii.push_back(snapToGrid(radius_mm));
    radii.push_back(snapToGrid(least_mm));
    return radii;
}

/// The quarter circle that ends at p in that direction.
std::optional<Path> WallLeads::arcInto(const Vec2& p, const Vec2& along, double lead_mm) const {
    const Vec2 centre = snapToGrid(Vec2(p + lead_mm * leftOf(along)));
    const Path arc{snapToGrid(Vec2(centre - lead_mm * along)), {{p, Arc{centre, lead_mm, true}}}};
    if (!isAir(arc.start) || !isFree(arc)) return std::nullopt;
    return arc;
}

/// The quarter circle that leaves p in that direction.
std::optional<Path> WallLeads::arcFrom(const Vec2& p, const Vec2& along, double lead_mm) const {
    const Vec2 centre = snapToGrid(Vec2(p + lead_mm * leftOf(along)));
    const Path arc{p, {{snapToGrid(Vec2(centre + lead_mm * along)), Arc{centre, lead_mm, true}}}};
    if (!isAir(arc.end()) || !isFree(arc)) return std::nullopt;
    return arc;
}

/// Straight between p and ground beside it that is cleared.
std::optional<Vec2> WallLeads::airBeside(const Vec2& p, const Vec2& along) const {
    for (const double share : {kLeastLeadShare, 2.0, 4.0}) {
        const Vec2 beside = snapToGrid(Vec2(p + share * task_.allowance_mm * leftOf(along)));
        if (isAir(beside) && isFree(makeLine(p, beside))) return beside;
    }
    return std::nullopt;
}

Lead WallLeads::into(const Vec2& p, const Vec2& along) const {
    if (cutsNothing(target_, radius_mm_, p, tol_)) {
        const Vec2 before = snapToGrid(Vec2(p - kRunOutMm * along));
        const Path run{before, {{p, {}}}};
        if (isAir(before) && isFree(run)) return {run};
        return {Path{p, {}}};
    }
    for (const double lead_mm : radii())
        if (const auto arc = arcInto(p, along, lead_mm)) return {*arc};
    if (const auto beside = airBeside(p, along)) return {Path{*beside, {{p, {}}}}};
    return {Path{p, {}}, true};
}

Path WallLeads::from(const Vec2& p, const Vec2& along) const {
    if (cutsNothing(target_, radius_mm_, p, tol_)) {
        const Vec2 after = snapToGrid(Vec2(p + kRunOutMm * along));
        const Path run{p, {{after, {}}}};
        return isAir(after) && isFree(run) ? run : Path{p, {}};
    }
    for (const double lead_mm : radii())
        if (const auto arc = arcFrom(p, along, lead_mm)) return *arc;
    if (const auto beside = airBeside(p, along)) return {p, {{*beside, {}}}};
    return {p, {}};
}

}  // namespace stepmill::toolpath
