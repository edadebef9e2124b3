#pragma once

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
};
/// Down through material by a helix around `entry.at`, starting and ending at `start`.
struct HelixDown {
    Vec2 centre;
    double radius_mm;
    Vec2 start;
    Over over = Over::Retract;
};
/// Down through material along a line, to and fro; ends at `from`.
struct RampDown {
    Vec2 from;
    Vec2 to;
    Over over = Over::Retract;
};
/// Straight down through material.
struct PlungeDown {
    Vec2 at;
    Over over = Over::Retract;
};
/// Down through material along the pass that follows, from over the retract height; the pass is `closed` or
/// gone to and fro.
struct RampAlong {
    Path pass;
    bool closed;
};
/// At depth along a straight line.
struct Link {
    Vec2 to;
    bool in_air;
};
/// A pass, from where the cutter stands.
struct Cut {
    Path path;
};
using ScriptStep = std::variant<ComeDown, HelixDown, RampDown, PlungeDown, RampAlong, Link, Cut>;

/// What decides between a link at depth and going up and down again.
struct LinkRates {
    double feed_mm_per_min;
    double plunge_feed_mm_per_min;
    double rapid_mm_per_min;
    double lift_mm;      ///< from the floor of a layer to where rapids cross within a feature
    double approach_mm;  ///< the last of the way down is fed
};

/// Puts the passes in order (each after those it waits for, else nearest first) and finds the way to each.
/// The first step's `over` is meant for the layers after the first, which begin where the last one ended.
std::vector<ScriptStep> scriptLayer(const ClearingTask& task, const PassSet& set, double radius_mm,
                                    double step_over_mm, const LinkRates& rates, const Tolerances& tol);

}  // namespace stepmill::toolpath
