// The pass along the walls that takes off what roughing has left there.

#include "stepmill/toolpath/finish_walls.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/path_parts.h"
#include "stepmill/toolpath/path_frame.h"
#include "stepmill/toolpath/swept_region.h"
#include "toolpath/emit.h"
#include "toolpath/finishing/wall_chains.h"
#include "toolpath/finishing/wall_leads.h"
#include "toolpath/patterns/ring_family.h"
#include "toolpath/script/visit_order.h"
#include "toolpath/swept_ground.h"

namespace stepmill::toolpath {
namespace {

/// Edges of a closed pass on which a place to begin is sought, the longest first, and where on each.
constexpr std::size_t kStartEdges = 16;
constexpr double kStartShares[] = {0.5, 0.25, 0.75};

/// A pass with its leads.
struct WallPass {
    Path path;
    bool plunges = false;  ///< begins in material
};

class WallPasses {
  public:
    WallPasses(const WallTask& task, double radius_mm, const Tolerances& tol)
        : clearing_(task.clearing), tol_(tol), chains_(task, radius_mm, tol), leads_(task, radius_mm, tol) {}

    std::vector<WallPass> make() const {
        std::vector<WallPass> passes;
        for (const Region& component : components(clearing_.free_centres)) {
            const Region guarded = ClearanceDiagram(component, tol_).offset(-tol_.guard_mm);
            for (const Loop& loop : guarded.loops)
                for (const Path& chain : chains_.along(loop))
                    passes.push_back(chain.closed() ? allRound(chain) : alongWall(chain));
        }
        return passes;
    }

  private:
    static Vec2 directionAtStart(const Path& path) { return tangentAt(path.start, path.segments.front(), 0); }

    static Vec2 directionAtEnd(const Path& path) {
        const Edge last = edgesOf(path).back();
        return tangentAt(last, 1);
    }

    WallPass joined(const Lead& in, const Path& along, const Path& out) const {
        WallPass pass{in.path, in.through_material};
        append(pass.path, along);
        append(pass.path, out);
        return pass;
    }

    WallPass alongWall(const Path& wall) const {
        return joined(leads_.into(wall.start, directionAtStart(wall)), wall,
                      leads_.from(wall.end(), directionAtEnd(wall)));
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
        for (const double lead_mm : leads_.radii()) {
            for (const std::size_t edge : order) {
                for (const double share : kStartShares) {
                    const Path path = loopFrom(loop, edge, share);
                    const auto in = leads_.arcInto(path.start, directionAtStart(path), lead_mm);
                    if (!in) continue;
                    const auto out = leads_.arcFrom(path.end(), directionAtEnd(path), lead_mm);
                    if (out) return joined({*in}, path, *out);
                }
            }
        }
        return alongWall(loopFrom(loop, order.front(), kStartShares[0]));
    }

    const ClearingTask& clearing_;
    const Tolerances& tol_;
    WallChains chains_;
    WallLeads leads_;
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
    const auto betweenPasses = [&](const Vec2& from, const Vec2& to) {
        return standing.isClearForAll(from, to) ? Over::Top : Over::Retract;
    };
    MoveWriter writer(path);
    for (const std::size_t i : visitOrder(stops)) {
        const WallPass& pass = passes[i];
        const Over back = overWay(standing, cleared, pass.path.end(), pass.path.start);
        const Over first = path.moves.empty() ? Over::Retract : betweenPasses(writer.at(), pass.path.start);
        for (int depth = 1; depth <= frame.depths; ++depth)
            writer.writeDepth(
                scriptOf(pass), depth == 1 ? first : back,
                {floorOf(clearing, frame, depth - 1), floorOf(clearing, frame, depth), clearing.floor_z_mm,
                 clearing.top_z_mm, clearing.retract_z_mm, ramp_angle_rad});
    }
    writer.retract();
}

}  // namespace

int finishingDepths(double depth_mm, double allowance_mm, const ToolAssembly& tool,
                    const CuttingData& cutting) {
    double deepest_mm = kDeepestFinishDiameters * tool.diameter_mm;
    if (tool.flute_length_mm > 0) deepest_mm = std::min(deepest_mm, tool.flute_length_mm);
    const double section_mm2 = usedStepOver(cutting, tool.radius_mm()) * cutting.step_down_mm;
    if (section_mm2 > 0) deepest_mm = std::min(deepest_mm, section_mm2 / allowance_mm);
    return depthsFor(depth_mm, deepest_mm);
}

Toolpath finishWalls(const WallTask& task, const ToolAssembly& tool, const CuttingData& cutting,
                     const Machine& machine, const Tolerances& tol) {
    STEPMILL_CHECK(task.allowance_mm > 0, "a finishing pass takes something off");
    const ClearingTask& clearing = task.clearing;
    const double depth_mm = clearing.top_z_mm - clearing.floor_z_mm;
    Toolpath path = pathFrame(clearing, finishingDepths(depth_mm, task.allowance_mm, tool, cutting),
                              tool.radius_mm(), cutting, machine);
    path.pattern = "walls";
    path.step_over_mm = task.allowance_mm;
    // A thin cut is no slot, and nothing ramps.
    path.slot_feed_mm_per_min = path.ramp_feed_mm_per_min = 0;
    const std::vector<WallPass> passes = WallPasses(task, tool.radius_mm(), tol).make();
    if (passes.empty()) return path;
    writePasses(clearing, passes, tool.radius_mm(), rampAngle(cutting), tol, path);
    path.totals = measure(path, machine);
    return withClearRapids(path, clearing, tool.radius_mm(), machine);
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
    return notSwept(region, ways, radius_mm + tol.sliver_mm, tol);
}

}  // namespace stepmill::toolpath
