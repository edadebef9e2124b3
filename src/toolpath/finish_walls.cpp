// The pass along the walls that takes off what roughing has left there.

#include "toolpath/finish_walls.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/path_parts.h"
#include "toolpath/emit.h"
#include "toolpath/path_frame.h"
#include "toolpath/ring_family.h"
#include "toolpath/swept_ground.h"
#include "toolpath/swept_region.h"
#include "toolpath/visit_order.h"

namespace stepmill::toolpath {
namespace {

/// The widest lead-in, as a share of the cutter's radius.
constexpr double kLeadShare = 0.5;
/// A lead-in no wider than the allowance would begin in material; this much wider it is tried last.
constexpr double kLeastLeadShare = 1.1;
/// How far beside the material a pass begins and ends past an open edge [mm].
constexpr double kRunOutMm = 1.0;
/// Edges of a closed pass on which a place to begin is sought, the longest first, and where on each.
constexpr std::size_t kStartEdges = 16;
constexpr double kStartShares[] = {0.5, 0.25, 0.75};
/// Stretches between two cuts that are shorter than this many radii are gone along rather than lifted over.
constexpr double kBridgeRadii = 2;

/// A stretch of a boundary of the free centres, in climb direction.
struct Chain {
    Path path;
    bool closed = false;
};

/// A way to or from a pass at depth: to where it ends, or from where it starts.
struct Lead {
    Path path;
    bool through_material = false;  ///< there is no way: straight down
};

/// A pass with its leads.
struct WallPass {
    Path path;
    bool plunges = false;  ///< begins in material
};

class WallPasses {
  public:
    WallPasses(const WallTask& task, double radius_mm, const Tolerances& tol)
        : task_(task),
          clearing_(task.clearing),
          radius_mm_(radius_mm),
          tol_(tol),
          left_edges_(task.left),
          obstruction_edges_(task.clearing.obstruction) {
        for (const KeptOff& kept : task.clearing.kept_off)
            kept_edges_.emplace_back(kept.section);
    }

    std::vector<WallPass> make() const {
        std::vector<WallPass> passes;
        for (const Region& component : components(clearing_.free_centres)) {
            const Region guarded = ClearanceDiagram(component, tol_).offset(-tol_.guard_mm);
            for (const Loop& loop : guarded.loops)
                for (const Chain& chain : chainsOf(loop))
                    passes.push_back(chain.closed ? allRound(chain.path) : alongWall(chain.path));
        }
        return passes;
    }

  private:
    // Where there is something to cut ------------------------------------------------------------------

    bool isNeeded(const Edge& edge) const {
        return left_edges_.anyNearer(edge, radius_mm_ - onBoundaryMm(tol_));
    }

    std::vector<Chain> chainsOf(const Loop& loop) const {
        const std::vector<Edge> edges = edgesOf(loop);
        std::vector<char> needed(edges.size());
        std::transform(edges.begin(), edges.end(), needed.begin(),
                       [&](const Edge& edge) { return static_cast<char>(isNeeded(edge)); });
        if (std::find(needed.begin(), needed.end(), 1) == needed.end()) return {};
        bridge(edges, needed);
        const auto gap = std::find(needed.begin(), needed.end(), 0);
        if (gap == needed.end()) return {{loop, true}};
        std::vector<Chain> chains;
        const auto first = static_cast<std::size_t>(gap - needed.begin());
        for (std::size_t k = 1; k <= edges.size(); ++k) {
            const std::size_t i = (first + k) % edges.size();
            const std::size_t before = (first + k - 1) % edges.size();
            if (needed[i] == 0) continue;
            if (needed[before] == 0) chains.push_back({Path{edges[i].from, {}}, false});
            chains.back().path.segments.push_back(edges[i].segment);
        }
        return chains;
    }

    /// Fills short gaps, which would cost more to lift over than to go along.
    void bridge(const std::vector<Edge>& edges, std::vector<char>& needed) const {
        const std::size_t count = edges.size();
        const std::vector<char> before = needed;
        for (std::size_t i = 0; i < count; ++i) {
            if (before[i] == 0 || before[(i + 1) % count] != 0) continue;
            double gap_mm = 0;
            std::size_t length = 0;
            for (; before[(i + 1 + length) % count] == 0; ++length) {
                const Edge& edge = edges[(i + 1 + length) % count];
                gap_mm += stepmill::length(edge);
            }
            if (gap_mm > kBridgeRadii * radius_mm_) continue;
            for (std::size_t k = 0; k < length; ++k)
                needed[(i + 1 + k) % count] = 1;
        }
    }

    // Where the cutter may be ----------------------------------------------------------------------------

    bool isFree(const Edge& way) const {
        if (obstruction_edges_.anyNearer(way, radius_mm_ + tol_.guard_mm / 2) ||
            contains(clearing_.obstruction, way.segment.to))
            return false;
        for (std::size_t i = 0; i < kept_edges_.size(); ++i) {
            const KeptOff& kept = task_.clearing.kept_off[i];
            if (kept_edges_[i].anyNearer(way, kept.distance_mm - tol_.guard_mm) ||
                contains(kept.section, way.segment.to))
                return false;
        }
        return true;
    }

    bool isFree(const Path& way) const {
        const std::vector<Edge> edges = edgesOf(way);
        return std::all_of(edges.begin(), edges.end(), [&](const Edge& edge) { return isFree(edge); });
    }

    /// May the cutter go down there at any depth?
    bool isAir(const Vec2& p) const {
        return cutsNothing(clearing_.target, radius_mm_, p, tol_) ||
               (!clearing_.cleared_centres.empty() && contains(clearing_.cleared_centres, p));
    }

    // Leads ----------------------------------------------------------------------------------------------

    std::vector<double> leadRadii() const {
        std::vector<double> radii;
        const double least_mm = kLeastLeadShare * task_.allowance_mm;
        double radius_mm = kLeadShare * radius_mm_;
        for (; radius_mm > least_mm; radius_mm /= 2)
            radii.push_back(snapToGrid(radius_mm));
        radii.push_back(snapToGrid(least_mm));
        return radii;
    }

    /// The quarter circle that ends at p in that direction.
    std::optional<Path> arcInto(const Vec2& p, const Vec2& along, double lead_mm) const {
        const Vec2 centre = snapToGrid(Vec2(p + lead_mm * leftOf(along)));
        const Path arc{snapToGrid(Vec2(centre - lead_mm * along)), {{p, Arc{centre, lead_mm, true}}}};
        if (!isAir(arc.start) || !isFree(arc)) return std::nullopt;
        return arc;
    }

    /// The quarter circle that leaves p in that direction.
    std::optional<Path> arcFrom(const Vec2& p, const Vec2& along, double lead_mm) const {
        const Vec2 centre = snapToGrid(Vec2(p + lead_mm * leftOf(along)));
        const Path arc{p, {{snapToGrid(Vec2(centre + lead_mm * along)), Arc{centre, lead_mm, true}}}};
        if (!isAir(arc.end()) || !isFree(arc)) return std::nullopt;
        return arc;
    }

    /// Straight between p and ground beside it that is cleared.
    std::optional<Vec2> airBeside(const Vec2& p, const Vec2& along) const {
        for (const double share : {kLeastLeadShare, 2.0, 4.0}) {
            const Vec2 beside = snapToGrid(Vec2(p + share * task_.allowance_mm * leftOf(along)));
            if (isAir(beside) && isFree(makeLine(p, beside))) return beside;
        }
        return std::nullopt;
    }

    Lead leadInto(const Vec2& p, const Vec2& along) const {
        if (cutsNothing(clearing_.target, radius_mm_, p, tol_)) {
            const Vec2 before = snapToGrid(Vec2(p - kRunOutMm * along));
            const Path run{before, {{p, {}}}};
            if (isAir(before) && isFree(run)) return {run};
            return {Path{p, {}}};
        }
        for (const double lead_mm : leadRadii())
            if (const auto arc = arcInto(p, along, lead_mm)) return {*arc};
        if (const auto beside = airBeside(p, along)) return {Path{*beside, {{p, {}}}}};
        return {Path{p, {}}, true};
    }

    Path leadFrom(const Vec2& p, const Vec2& along) const {
        if (cutsNothing(clearing_.target, radius_mm_, p, tol_)) {
            const Vec2 after = snapToGrid(Vec2(p + kRunOutMm * along));
            const Path run{p, {{after, {}}}};
            return isAir(after) && isFree(run) ? run : Path{p, {}};
        }
        for (const double lead_mm : leadRadii())
            if (const auto arc = arcFrom(p, along, lead_mm)) return *arc;
        if (const auto beside = airBeside(p, along)) return {p, {{*beside, {}}}};
        return {p, {}};
    }

    // Passes ---------------------------------------------------------------------------------------------

    static Vec2 directionAtStart(const Path& path) { return tangentAt(path.start, path.segments.front(), 0); }

    static Vec2 directionAtEnd(const Path& path) {
        const Edge last = edgesOf(path).back();
        return tangentAt(last, 1);
    }

    static void append(Path& path, const Path& more) {
        path.segments.insert(path.segments.end(), more.segments.begin(), more.segments.end());
    }

    WallPass joined(const Lead& in, const Path& along, const Path& out) const {
        WallPass pass{in.path, in.through_material};
        append(pass.path, along);
        append(pass.path, out);
        return pass;
    }

    WallPass alongWall(const Path& wall) const {
        return joined(leadInto(wall.start, directionAtStart(wall)), wall,
                      leadFrom(wall.end(), directionAtEnd(wall)));
    }

    /// The loop begun there, with the overlap.
    static Path loopFrom(const Loop& loop, std::size_t edge, double share) {
        Path path = startingAt(loop, edge, share);
        append(path, firstPart(path, std::min(kOverlapMm, length(loop) / 2)));
        return path;
    }

    WallPass allRound(const Loop& loop) const {
        const std::vector<Edge> edges = edgesOf(loop);
        std::vector<std::size_t> order(edges.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        const auto lengthOf = [&](std::size_t i) { return length(edges[i]); };
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return lengthOf(a) > lengthOf(b); });
        if (order.size() > kStartEdges) order.resize(kStartEdges);
        for (const double lead_mm : leadRadii()) {
            for (const std::size_t edge : order) {
                for (const double share : kStartShares) {
                    const Path path = loopFrom(loop, edge, share);
                    const auto in = arcInto(path.start, directionAtStart(path), lead_mm);
                    if (!in) continue;
                    const auto out = arcFrom(path.end(), directionAtEnd(path), lead_mm);
                    if (out) return joined({*in}, path, *out);
                }
            }
        }
        return alongWall(loopFrom(loop, order.front(), kStartShares[0]));
    }

    const WallTask& task_;
    const ClearingTask& clearing_;
    double radius_mm_;
    const Tolerances& tol_;
    EdgeIndex left_edges_;
    EdgeIndex obstruction_edges_;
    std::vector<EdgeIndex> kept_edges_;
};

std::vector<ScriptStep> scriptOf(const WallPass& pass) {
    if (pass.plunges) return {PlungeDown{pass.path.start}, Cut{pass.path}};
    return {ComeDown{pass.path.start}, Cut{pass.path}};
}

/// Each pass at all its depths before the next one.
void writePasses(const ClearingTask& clearing, const std::vector<WallPass>& passes, double radius_mm,
                 double ramp_angle_rad, const Tolerances& tol, Toolpath& path) {
    const Toolpath frame = path;
    const Standing standing(clearing, radius_mm, tol);
    const SweptGround cleared(clearing, radius_mm);
    std::vector<Stop> stops;
    for (const WallPass& pass : passes)
        stops.push_back({pass.path.start, pass.path.end()});
    const auto over = [&](const Vec2& from, const Vec2& to, bool within_pass) {
        if (!standing.isClearForAll(from, to)) return Over::Retract;
        return within_pass && cleared.isClear(from, to) ? Over::Layer : Over::Top;
    };
    MoveWriter writer(path);
    for (const std::size_t i : visitOrder(stops)) {
        const WallPass& pass = passes[i];
        const Over back = over(pass.path.end(), pass.path.start, true);
        const Over first = path.moves.empty() ? Over::Retract : over(writer.at(), pass.path.start, false);
        for (int layer = 1; layer <= frame.layers; ++layer)
            writer.writeLayer(
                scriptOf(pass), layer == 1 ? first : back,
                {levelOf(clearing, frame, layer - 1), levelOf(clearing, frame, layer), clearing.floor_z_mm,
                 clearing.top_z_mm, clearing.retract_z_mm, ramp_angle_rad});
    }
    writer.retract();
}

}  // namespace

int finishingLayers(double depth_mm, double allowance_mm, const ToolAssembly& tool,
                    const CuttingData& cutting) {
    double deepest_mm = kDeepestFinishDiameters * tool.diameter_mm;
    if (tool.flute_length_mm > 0) deepest_mm = std::min(deepest_mm, tool.flute_length_mm);
    const double section_mm2 = usedStepOver(cutting, tool.radius_mm()) * cutting.step_down_mm;
    if (section_mm2 > 0) deepest_mm = std::min(deepest_mm, section_mm2 / allowance_mm);
    return layersFor(depth_mm, deepest_mm);
}

Toolpath finishWalls(const WallTask& task, const ToolAssembly& tool, const CuttingData& cutting,
                     const Machine& machine, const Tolerances& tol) {
    STEPMILL_CHECK(task.allowance_mm > 0, "a finishing pass takes something off");
    const ClearingTask& clearing = task.clearing;
    const double depth_mm = clearing.top_z_mm - clearing.floor_z_mm;
    Toolpath path = pathFrame(clearing, finishingLayers(depth_mm, task.allowance_mm, tool, cutting),
                              tool.radius_mm(), cutting, machine);
    path.pattern = "walls";
    path.step_over_mm = task.allowance_mm;
    // A thin cut is no slot, and nothing ramps.
    path.slot_feed_mm_per_min = path.ramp_feed_mm_per_min = 0;
    const std::vector<WallPass> passes = WallPasses(task, tool.radius_mm(), tol).make();
    if (passes.empty()) return path;
    writePasses(clearing, passes, tool.radius_mm(), rampAngle(cutting), tol, path);
    path.totals = measure(path, machine);
    return path;
}

Region leftBy(const Toolpath& path, const Region& region, double floor_z_mm, double radius_mm,
              const Tolerances& tol) {
    std::vector<Path> ways;
    Vec3 from = path.start;
    bool goes_on = false;
    for (const Move& move : path.moves) {
        const bool level =
            move.kind != MoveKind::Rapid && from.z() == floor_z_mm && move.to.z() == floor_z_mm;
        if (level && !goes_on) ways.push_back({Vec2(from.head<2>()), {}});
        if (level) ways.back().segments.push_back({Vec2(move.to.head<2>()), move.arc});
        goes_on = level;
        from = move.to;
    }
    if (ways.empty()) return region;
    return subtract(region, sweptRegion(ways, radius_mm + tol.sliver_mm, tol), tol);
}

}  // namespace stepmill::toolpath
