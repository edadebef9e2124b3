#pragma once

#include <variant>
#include <vector>

#include "toolpath/patterns/passes.h"
#include "toolpath/script/standing.h"
#include "toolpath/swept_ground.h"

namespace stepmill::toolpath {

// A script says in plan view how one depth of cut is cut. It is the same for every depth: heights are added
// when it is turned into moves.

/// How high the cutter goes on its way to a place where it comes down.
enum class Over {
    Retract,   ///< to the retract height
    Top,       ///< just over the feature's top: the straight way is clear of the obstruction at every height
    LastFloor  ///< just over the floor of the depth before, which has cleared that way too
};

/// Down where the disc meets no material at this depth: beside the target, over ground cleared before, or
/// on a pass of this depth.
struct ComeDown {
    Vec2 at;
    Over over = Over::Retract;
    bool deep = false;  ///< no material there down to the feature's floor, before any pass of this tool
};
/// Down through material along a line, to and fro; ends at `from`.
struct RampDown {
    Vec2 from;
    Vec2 to;
    bool level = true;  ///< gone along once more at depth, so that no slope stays
    Over over = Over::Retract;
};
/// Straight down through material.
struct PlungeDown {
    Vec2 at;
    Over over = Over::Retract;
    /// Each time that it has come so much deeper under the stock's top it is lifted out first, so that chips
    /// get out [mm]; 0: never.
    double lifts_each_mm = 0;
};
/// Down through material along a curve, evenly; ends at its start.
struct RampAlong {
    /// Gone along first: the last part of a closed curve, or the first part of an open one.
    Path lead;
    Path curve;
    bool closed = true;
    /// How often the cutter then goes along the whole closed curve, or to and fro along the open lead.
    int turns = 0;
    bool level = true;  ///< the curve is gone along once more at depth: a pass, or a helix no pass covers
    Over over = Over::Retract;
    double feed_mm_per_min = 0;  ///< on the way down; 0: that of ramps
};
/// At depth along a straight line.
struct Link {
    Vec2 to;
    bool in_air;
    bool wide = false;  ///< cuts wider than the step-over somewhere
};
/// A pass, from where the cutter stands.
struct Cut {
    Path path;
    std::vector<bool> wide{};  ///< of each segment: it cuts wider than the step-over; empty: none does
};
/// From point to point over ground that is cleared at this depth, a little over it and faster than the tool
/// may cut.
struct Glide {
    std::vector<Vec2> way;
    double lift_mm = 0;
    double feed_mm_per_min = 0;
};
using ScriptStep = std::variant<ComeDown, RampDown, PlungeDown, RampAlong, Link, Cut, Glide>;

/// Steps of a script that are cut over all depths before the next ones.
struct DepthBlock {
    std::vector<ScriptStep> steps;
    Vec2 begin = Vec2::Zero();  ///< where it comes down first
    Vec2 end = Vec2::Zero();
    /// How to go over to the first step from where the depth before ended.
    Over next_over = Over::Retract;
};

/// One depth of cut of one component of the free centres.
struct DepthScript {
    DepthBlock whole;
    /// The same passes in several blocks such that none needs ground that another one clears: rest material
    /// in several places. Empty where there is one block alone.
    std::vector<DepthBlock> apart;
    /// The same with the closed curve that the cutter goes down along as a block of its own, cut down to the
    /// floor before the others. Empty where the depth begins in another way, or is no more than that curve.
    std::vector<DepthBlock> ring_first;

    bool empty() const { return whole.steps.empty(); }
};

/// Lengths and feeds that decide between a link at depth and a lift.
struct LinkRates {
    double descent_mm;  ///< length of a ramp at the ramp angle through one depth of cut
    double feed_mm_per_min;
    double plunge_feed_mm_per_min;
    double rapid_mm_per_min;
    double lift_mm;           ///< from the floor of a depth to where rapids cross within a feature
    double approach_mm;       ///< the last of the way down is fed
    double deep_approach_mm;  ///< the same over ground clear down to the feature's floor, the depths' mean
    double ramp_feed_mm_per_min;
    double plunge_mm;          ///< from where a descent begins through one depth of cut
    bool may_plunge;           ///< the tool may go straight down through one depth of cut
    double rated_mm3_per_min;  ///< no helix that is steeper than ramps removes more
    int rings_at_once;         ///< depths of cut that a first ring may be cut down through in one go
};

/// The data that all depths of one task share.
struct DepthTask {
    const ClearingTask& clearing;
    const Standing& standing;
    double radius_mm;
    double step_over_mm;
    LinkRates rates;
    const SweptGround& untouched;  ///< before any pass
    const Tolerances& tol;
};

/// Puts the component's passes in order (each after those it waits for, else nearest first) and finds the way
/// to each.
DepthScript scriptDepth(const DepthTask& task, const RingFamily::Component& component, const Entry& entry,
                        const std::vector<Pass>& passes);

/// The lowest height at which the way to a place is known to be clear. `ground` is cleared at this depth; the
/// next depth is cut after it and may cross over its floor.
Over overWay(const Standing& standing, const SweptGround& ground, const Vec2& from, const Vec2& to);

/// Straight down at a place of the component: in a hole hardly wider than the cutter with lifts.
PlungeDown plungeAt(const DepthTask& task, const RingFamily::Component& component, const Vec2& at);

/// Down along a curve of that many mm of ramp, so that it ends at the curve's start.
RampAlong rampAlong(const Path& curve, bool closed, double descent_mm);

/// Feed of a helix that goes so deep a turn of that length: within the rated removal, no more than ramps',
/// and sinking no faster than the plunge feed.
double helixFeed(const DepthTask& task, double turn_mm, double pitch_mm);

void setOver(ScriptStep& step, Over over);

}  // namespace stepmill::toolpath
