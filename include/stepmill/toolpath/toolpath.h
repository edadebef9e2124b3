#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/access/access.h"
#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/region.h"

namespace stepmill {

enum class MoveKind {
    Rapid,  ///< G0, straight
    Feed,   ///< at the cutting feed
    Slot,   ///< level, cutting wider than the step-over: at the slot feed
    Ramp,   ///< descending through material along a ramp, helix or pass, at the ramp feed
    Plunge  ///< straight down, at the plunge feed
};

/// One motion of the tool tip from where the previous one ended. With `arc` the move follows it in x and y
/// while z changes evenly (a helix when it does).
struct Move {
    MoveKind kind = MoveKind::Rapid;
    Vec3 to = Vec3::Zero();
    std::optional<Arc> arc;
    bool in_air = false;  ///< a feed move known to meet no material
    /// By what it cuts (CuttingModel); 0: that of its kind.
    double feed_mm_per_min = 0;
    bool for_chips = false;  ///< a rapid out of a narrow hole that stays, however near the next place is
};
/// A move as seen from above, for who places it: not for straight up and down.
Edge edgeOf(const Vec3& from, const Move& move);

/// How a region is gone over. See docs/algorithms/contour-parallel.md and docs/algorithms/parallel-lines.md.
enum class Pattern {
    Best,              ///< whichever of those below takes the least time in the region
    ContourInsideOut,  ///< rings of the boundary; closed pockets from inside out
    ContourOutsideIn,  ///< the same rings, walls first
    StockOffset,       ///< rings of the outer boundary alone, islands when a ring meets them [Li2001, 4.2]
    Zigzag,            ///< parallel lines to and fro, then along the walls [Li2001, 4.1]
    OneWay,            ///< the same lines, all in climb direction
    Adaptive           ///< bites of constant engagement, deep and narrow: a whole path or none of it
};
std::string toString(Pattern pattern);
/// The reverse; nothing for another word.
std::optional<Pattern> patternFrom(std::string_view word);
/// Is it among those to choose from? None named: all are.
bool isAmong(const std::vector<Pattern>& patterns, Pattern pattern);

/// What one pattern takes in one region of the free centres, over all depths of cut.
struct PatternTime {
    Pattern pattern = Pattern::ContourInsideOut;
    double angle_deg = 0;   ///< of parallel lines to the x axis, in [0, 180)
    double time_s = 0;      ///< without the way to the region
    bool at_least = false;  ///< no path was made: its passes alone take longer than the best path
};

/// The patterns weighed for one region, the one it is cut with first, the others by time.
struct RegionPatterns {
    std::vector<PatternTime> weighed;
};

/// A whole path that was weighed at feeds by what it cuts.
struct FedPattern {
    std::string pattern;  ///< as Toolpath::pattern
    double time_s = 0;    ///< with the machine's acceleration where that is given
};

/// Lengths and times of a path [mm, s].
struct PathTotals {
    double cut_length_mm = 0;       ///< all feed moves: G1, G2, G3
    double feed_air_length_mm = 0;  ///< of these, what does not cut
    double air_length_mm = 0;       ///< rapids
    double feed_time_s = 0;
    double rapid_time_s = 0;
    /// motionTimeS() where the machine's acceleration is given, else the same as time_s(); never less.
    double motion_time_s = 0;

    double time_s() const { return feed_time_s + rapid_time_s; }
    PathTotals& operator+=(const PathTotals& other);
};

/// What checking the emitted moves against the obstruction gave.
struct PathProof {
    /// Least distance between the cutter's edge and the obstruction over all moves below the feature's
    /// top and all rapids across below the retract height; negative would be a gouge. Not searched beyond
    /// three radii, infinite without such moves [mm].
    double least_clearance_mm = 0;
    /// Rapids stay above the material or over ground already cleared.
    bool rapids_clear = true;
};

/// The path of one tool in one feature over all depths of cut, in setup coordinates. Starts and ends at
/// the retract height.
struct Toolpath {
    Vec3 start = Vec3::Zero();
    std::vector<Move> moves;
    std::string pattern;  ///< "contour-parallel", "zigzag at 30 deg", "drill"; several: joined by " + "
    /// Regions in the order they are cut; empty for drills.
    std::vector<RegionPatterns> regions;
    /// Where the pattern was chosen by what the paths cut: those compared, this one first, then by time.
    std::vector<FedPattern> as_fed;
    int depths = 0;           ///< number of depths of cut, evenly divided
    double step_over_mm = 0;  ///< as used
    double step_down_mm = 0;  ///< whole depth / depths
    double feed_mm_per_min = 0;
    double plunge_feed_mm_per_min = 0;
    /// rampFeed() of the two feeds above and the ramp angle; 0 where the path has no ramps.
    double ramp_feed_mm_per_min = 0;
    double slot_feed_mm_per_min = 0;  ///< where a cut is wider than the step-over; 0 without such moves
    /// Of an adaptive path: no cut at depth engages more of the cutter's rim; 0: there is no limit [rad].
    double engagement_rad = 0;
    PathTotals totals;

    /// Of a move of that kind; 0 for rapids, whose rate is the machine's.
    double feedOf(MoveKind kind) const;
    /// Of a move: its own or, where it has none, that of its kind.
    double feedOf(const Move& move) const {
        return move.feed_mm_per_min > 0 ? move.feed_mm_per_min : feedOf(move.kind);
    }
};

/// Is it a way over cleared ground, faster than the tool may cut? It has a feed of its own from the start.
inline bool isGlide(const Move& move) {
    return move.kind == MoveKind::Feed && move.in_air && move.feed_mm_per_min > 0;
}

/// The rings of one tool's free centres before clipping: the costly part of clearArea(), the same for all
/// tasks of that tool in that feature. Immutable; share it between threads.
class RingFamily;

/// Standing material that shank or holder reach while the tip is at depth: the axis stays off it.
struct KeptOff {
    Region section;
    double distance_mm = 0;
};

/// What one tool has to clear in one feature.
struct ClearingTask {
    Region free_centres;         ///< where the axis may go at every depth of the feature
    std::vector<Entry> entries;  ///< one per component of free_centres, in components() order
    /// Of components of the free centres that stand for the middles of slots as wide as the cutter: these.
    std::vector<Path> slot_middles;
    /// In what a cutter as wide as its slot has left no rapid down has room: ways that are clear of material
    /// are fed across where the cutter is.
    bool in_slot = false;
    Region centres;          ///< centres to be swept (all of free_centres, or a decomposed area's)
    Region cleared_centres;  ///< centres where the disc meets no material; empty for a first tool
    Region target;           ///< T, to see open edges and trim passes that would only cut air
    Region obstruction;      ///< O, for the proof
    /// On the free centres all of this is kept; ways over ground that is clear for the cutter may leave them.
    std::vector<KeptOff> kept_off;
    /// Deeper than this shank or holder are below the top of what the tool cuts [mm].
    double free_reach_mm = std::numeric_limits<double>::infinity();
    double top_z_mm = 0;
    double floor_z_mm = 0;
    double retract_z_mm = 0;  ///< rapids across what must stay go here
    Region skirt;             ///< rapids stay off this too; cutters may cut it [Feature::skirt]
    /// Nothing stands over this height where the cutter goes [mm].
    double stands_to_mm = std::numeric_limits<double>::infinity();
    /// What stands beside the target over its top; nothing: the obstruction.
    std::optional<Region> stands_above;
    Pattern pattern = Pattern::Best;  ///< a region that cannot have it gets contour-parallel
    std::vector<Pattern> patterns;    ///< the best is chosen from these; empty: from all
    /// makeRings() of a task with the same free centres, target, obstruction, pattern, tool and cutting data;
    /// null: clearArea() makes its own.
    std::shared_ptr<const RingFamily> rings;
};

/// Builds what clearArea() can share between the tasks of one tool in one feature. Looks at the task's
/// free centres, target, obstruction and pattern only.
std::shared_ptr<const RingFamily> makeRings(const ClearingTask& task, const ToolAssembly& tool,
                                            const CuttingData& cutting, const Tolerances& tol);

/// Clearing at every depth of cut, each region of the free centres with the pattern that takes least time
/// there: rings of the centre region at the step-over or parallel lines, entered from an open edge, cleared
/// ground, helix, ramp or plunge, linked at depth where the straight way is free, else just over the floor of
/// the depth before, over the feature's top or over the retract height: the lowest of these that the straight
/// way is proven to be clear at. Climb milling; arcs stay arcs. The step-over is limited to the cutter
/// radius, so that rings leave nothing between them. Empty (no moves) when there is nothing to clear.
Toolpath clearArea(const ClearingTask& task, const ToolAssembly& tool, const CuttingData& cutting,
                   const Machine& machine, const Tolerances& tol);

/// Patterns that take in some region no more than so much longer than the one that it is cut with.
std::set<Pattern> rivalPatterns(const Toolpath& path, double longer_share);

/// Drills equal holes, one after another in this order: rapid over the hole, down to the clearance height,
/// feed, rapid out to the retract height. Down to kOneGoDiameters in one go, deeper in pecks of the cutting
/// data's step-down (or twice the diameter when it has none), coming out after each; `depths` are pecks a
/// hole.
/// \pre tool.isDrill() or tool.isSpot(), at least one hole
Toolpath drillHoles(const std::vector<Vec2>& centres, double top_z_mm, double tip_z_mm, double retract_z_mm,
                    const ToolAssembly& tool, const CuttingData& cutting, const Machine& machine);
/// One hole.
Toolpath drillHole(const Vec2& at, double top_z_mm, double tip_z_mm, double retract_z_mm,
                   const ToolAssembly& tool, const CuttingData& cutting, const Machine& machine);

/// Taps drilled holes, one after another in this order: rapid over the hole, down to a height from which the
/// spindle may come up to speed, down to `tip_z_mm` and up again with the spindle's turns, rapid out to the
/// retract height. The feed is pitch x speed both ways.
/// \pre tool.isTap(), at least one hole
Toolpath tapHoles(const std::vector<Vec2>& centres, double top_z_mm, double tip_z_mm, double retract_z_mm,
                  const ToolAssembly& tool, double speed_rpm, const Machine& machine);

/// Brings holes to their width, one after another in this order: rapid over the hole, down to the clearance
/// height, feed down and up again there, so that no mark of a rapid stays on the wall, rapid out to the
/// retract height.
/// \pre tool.isSizer(), at least one hole
Toolpath sizeHoles(const std::vector<Vec2>& centres, double top_z_mm, double tip_z_mm, double retract_z_mm,
                   const ToolAssembly& tool, const CuttingData& cutting, const Machine& machine);

/// Holes no deeper than so many diameters clear their chips by themselves.
inline constexpr double kOneGoDiameters = 3;
/// Deeper ones up to so many have their chips broken by a short lift after each peck; out of still deeper
/// ones they are brought.
inline constexpr double kChipBreakDiameters = 5;
/// The pattern of holes whose chips are broken.
inline constexpr const char* kChipBreakPattern = "drill, chips broken";
/// The pattern of a countersink that goes straight down into cones.
inline constexpr const char* kCountersinkPattern = "countersink";
/// How far the drill is lifted to break a chip: a hundredth of an inch, as G73 of controllers does [mm].
inline constexpr double kChipBreakLiftMm = 0.254;

/// The places in an order that is short to visit: from the one farthest left and down the nearest next, then
/// with stretches turned round as long as that makes the way shorter. O(n2) a round, a few rounds.
std::vector<Vec2> shortestTour(std::vector<Vec2> places);

/// Feed along a descent at `angle_rad` to the horizontal: the cutting feed, but no more than lets the cutter
/// sink at the plunge feed, min(F, F_p / sin(angle)). The edges at the cutter's rim then cut as they do on
/// the level, those near its centre as in a plunge.
/// \pre 0 < angle_rad <= pi / 2
double rampFeed(double feed_mm_per_min, double plunge_feed_mm_per_min, double angle_rad);

/// Sums lengths and times: at the path's feeds and the machine's rapid rate, and beside it with the machine's
/// acceleration where that is given.
PathTotals measure(const Toolpath& path, const Machine& machine);

/// Time of the path when the axes speed up and slow down at no more than the machine's acceleration a: each
/// move trapezoidal, from rest at the path's start to rest at its end. A corner between two directions is
/// passed at the speed at which a circle that cuts it by the junction deviation d keeps to a,
/// v^2 = a d sin(t/2) / (1 - sin(t/2)) for an angle t between the two moves (180 degrees: straight on), and
/// an arc of radius R at no more than v^2 = a R. The controller is taken to look ahead over the whole path.
/// \pre machine.acceleration_mm_per_s2 > 0. O(moves).
/// \see docs/algorithms/costs.md
double motionTimeS(const Toolpath& path, const Machine& machine);

/// The same path with rapids that rest on nothing the planner believes of what stands: they cross at the
/// path's retract height alone, and what was a rapid down is fed at the plunge feed from just over the stock.
/// \pre the path starts at its retract height; not for drills, whose cycles bring their own rapids. O(moves).
Toolpath withPlainRapids(const Toolpath& path, double stock_top_z_mm, const Machine& machine);

/// The same path with rapids that keep clear: where one would come down nearer to what stands, be it what
/// must stay, the skirt or what the path has not cut yet, the tool comes down at a place near by that has
/// the room and is fed across from there, or is fed down from the lowest height that has it. Rapids across
/// that pass nearer go higher.
/// \pre the path starts at the retract height; not for drills.
Toolpath withClearRapids(const Toolpath& path, const ClearingTask& task, double tool_radius_mm,
                         const Machine& machine);

/// The same path with rapids at depth over negative islands: where the cutter is fed level over holes and
/// windows, with the clearances that rapids keep to all that stands around it, it goes straight across in a
/// rapid, if that saves time with the machine's acceleration too [Tripathi2005]. O(n log n) in edges.
Toolpath withRapidsOverVoids(const Toolpath& path, const ClearingTask& task, double tool_radius_mm,
                             const Machine& machine, const Tolerances& tol);

/// Checks the moves themselves, independently of how they were made.
PathProof prove(const Toolpath& path, const ClearingTask& task, double tool_radius_mm, const Tolerances& tol);

/// The feed moves at the deepest depth of cut, seen from above; for drawings.
std::vector<Path> topView(const Toolpath& path);

}  // namespace stepmill
