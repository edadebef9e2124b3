#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "toolpath/passes.h"

namespace stepmill::toolpath {

/// How a layer is cut, in plan view: the same for every depth of cut, heights are added on emission.

/// How high the cutter goes on its way to a place where it comes down.
enum class Over {
    Retract,  ///< to the retract height
    Top,      ///< just over the feature's top: the straight way is clear of the obstruction at every height
    Layer     ///< just over the floor of the layer before, which has cleared that way too
};

/// Down where the disc meets no material at this depth: beside the target, over ground cleared before, or
/// on a pass of this layer.
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
};
/// Down through material along a curve, evenly; ends at its start.
struct RampAlong {
    /// Gone along first: the last part of a closed curve, or the first part of an open one.
    Path lead;
    Path curve;
    bool closed = true;
    /// How often then the whole closed curve, or the open lead to and fro.
    int turns = 0;
    bool level = true;  ///< the curve is gone along once more at depth: a pass, or a helix no pass covers
    Over over = Over::Retract;
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
using ScriptStep = std::variant<ComeDown, RampDown, PlungeDown, RampAlong, Link, Cut>;

/// What decides between a link at depth and going up and down again.
struct LinkRates {
    double descent_mm;  ///< length of a ramp at the ramp angle through one depth of cut
    double feed_mm_per_min;
    double plunge_feed_mm_per_min;
    double rapid_mm_per_min;
    double lift_mm;           ///< from the floor of a layer to where rapids cross within a feature
    double approach_mm;       ///< the last of the way down is fed
    double deep_approach_mm;  ///< the same over ground clear down to the feature's floor, layers' mean
};

/// Steps of a layer that are cut over all depths before the next ones.
struct LayerBlock {
    std::vector<ScriptStep> steps;
    Vec2 begin = Vec2::Zero();  ///< where it comes down first
    Vec2 end = Vec2::Zero();
    /// How to go over to the first step from where the layer before ended.
    Over next_over = Over::Retract;
};

/// A layer of one component of the free centres.
struct LayerScript {
    LayerBlock whole;
    /// The same passes in blocks of which none needs what another clears: rest material in several places.
    /// Empty where there are not several.
    std::vector<LayerBlock> apart;

    bool empty() const { return whole.steps.empty(); }
};

/// What must stay, asked for ways over it.
class Standing {
  public:
    Standing(const ClearingTask& task, double radius_mm, const Tolerances& tol);

    /// Is the straight way clear for the cutter at every height over the floor?
    bool isClear(const Vec2& from, const Vec2& to) const;
    /// And for shank and holder?
    bool isClearForAll(const Vec2& from, const Vec2& to) const;

  private:
    struct Kept {
        const Region& section;
        EdgeIndex edges;
        double distance_mm;
    };
    static bool keeps(const Kept& kept, const Vec2& from, const Vec2& to);

    Kept obstruction_;
    std::vector<Kept> holder_;
};

/// What the layers of one task have in common.
struct LayerTask {
    const ClearingTask& clearing;
    const Standing& standing;
    double radius_mm;
    double step_over_mm;
    LinkRates rates;
    const Tolerances& tol;
};

/// Puts the component's passes in order (each after those it waits for, else nearest first) and finds the way
/// to each.
LayerScript scriptLayer(const LayerTask& task, const RingFamily::Component& component, const Entry& entry,
                        const std::vector<Pass>& passes);

/// Down along a curve of that many mm of ramp, so that it ends at the curve's start.
RampAlong rampAlong(const Path& curve, bool closed, double descent_mm);

void setOver(ScriptStep& step, Over over);

}  // namespace stepmill::toolpath
