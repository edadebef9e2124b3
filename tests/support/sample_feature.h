#pragma once

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/sequence.h"
#include "support/tool_makers.h"

namespace stepmill::test {

inline Machine makeMachine() {
    Machine machine;
    machine.name = "mill";
    machine.rapid_mm_per_min = 10000;
    machine.max_feed_mm_per_min = 8000;
    machine.max_speed_rpm = 20000;
    machine.tool_change_s = 5;
    machine.hourly_rate = 60;
    machine.safe_height_mm = 5;
    machine.dialect = "linuxcnc";
    return machine;
}

/// A pocket in a block: the target with walls all round, from z = 0 down.
inline Feature makePocket(const Region& target, double depth_mm,
                          FeatureClass feature_class = FeatureClass::ClosedPocket) {
    const Tolerances tol;
    Feature feature;
    feature.id = "S1.F1";
    feature.setup_id = "S1";
    feature.feature_class = feature_class;
    feature.top_z_mm = 0;
    feature.floor_z_mm = -depth_mm;
    feature.target = target;
    const Box2 block = grown(boundingBox(target), 15);
    feature.obstruction = subtract(makeRectangle(block.min(), block.max()), target, tol);
    feature.obstacles.push_back({feature.floor_z_mm, feature.top_z_mm, feature.obstruction});
    for (const Loop& loop : target.loops)
        feature.boundary.push_back({loop, false});
    feature.closed_length_mm = perimeter(target);
    feature.area_mm2 = area(target);
    feature.volume_mm3 = feature.area_mm2 * depth_mm;
    return feature;
}

/// A round hole in a block, as makePocket.
inline Feature holeOf(double diameter_mm, double depth_mm, bool through) {
    Feature hole = makePocket(makeCircle(Vec2(20, 20), diameter_mm / 2), depth_mm,
                              through ? FeatureClass::HoleThrough : FeatureClass::HoleBlind);
    hole.through = through;
    return hole;
}

/// 70 x 50 mm, corner radius 6, a round island of 16 mm; 12 mm deep.
inline Feature makeIslandPocket() {
    const Tolerances tol;
    const Region pocket = makeRoundedRectangle(Vec2(0, 0), Vec2(70, 50), 6);
    Feature feature = makePocket(subtract(pocket, makeCircle(Vec2(35, 25), 8), tol), 12);
    feature.min_corner_radius_mm = 6;
    return feature;
}

/// The tools of the steps, in their order.
inline std::vector<std::string> toolsOf(const ToolSequence& sequence) {
    std::vector<std::string> ids;
    for (const SequenceStep& step : sequence.steps)
        ids.push_back(step.tool_id);
    return ids;
}

inline SequenceOptions inAluminium(Objective objective = Objective::Time) {
    SequenceOptions options;
    options.material = kMaterial;
    options.objective = objective;
    return options;
}

}  // namespace stepmill::test
