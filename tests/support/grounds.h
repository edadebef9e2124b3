#pragma once

#include "stepmill/access/access.h"
#include "stepmill/planar/boolean.h"
#include "support/tool_makers.h"

namespace stepmill::test {

/// A feature from z = 0 down, its target closed except for `open_length_mm`, the obstruction standing up to
/// z = 0.
inline Feature makeFeature(Region target, Region obstruction, double open_length_mm, double depth_mm = 10) {
    Feature feature;
    feature.id = "S1.F1";
    feature.setup_id = "S1";
    feature.feature_class = open_length_mm > 0 ? FeatureClass::OpenPocket : FeatureClass::ClosedPocket;
    feature.floor_z_mm = -depth_mm;
    feature.target = std::move(target);
    feature.obstruction = std::move(obstruction);
    feature.open_length_mm = open_length_mm;
    feature.closed_length_mm = perimeter(feature.target) - open_length_mm;
    feature.obstacles = {{-depth_mm, 0, feature.obstruction}};
    feature.area_mm2 = area(feature.target);
    feature.volume_mm3 = feature.area_mm2 * depth_mm;
    return feature;
}

/// A pocket closed all round in a block that reaches 20 mm further.
inline Feature closedPocket(const Region& target, double depth_mm = 10) {
    const Box2 box = grown(boundingBox(target), 20);
    return makeFeature(target, subtract(makeRectangle(box.min(), box.max()), target, {}), 0, depth_mm);
}

}  // namespace stepmill::test
