#include "unit/planar/clearance_shapes.h"

#include <gtest/gtest.h>

#include "stepmill/core/units.h"

namespace stepmill::test {

double roundedArea(double width, double height, double radius) {
    return width * height - (4 - kPi) * radius * radius;
}

Region pocketWithIsland() {
    Region region = makeRoundedRectangle({-35, -25}, {35, 25}, 6);
    addHole(region, makeCircle({0, 0}, 8));
    return region;
}

Region dogBone() {
    return makePolygon({{0, -10},
                        {20, -10},
                        {20, -3},
                        {30, -3},
                        {30, -10},
                        {50, -10},
                        {50, 10},
                        {30, 10},
                        {30, 3},
                        {20, 3},
                        {20, 10},
                        {0, 10}});
}

Region eccentricRing() {
    Region ring = makeCircle({0, 0}, 17);
    addHole(ring, makeCircle({4, 0}, 11));
    return ring;
}

Region cross() {
    return makePolygon({{-4, -16},
                        {4, -16},
                        {4, -4},
                        {16, -4},
                        {16, 4},
                        {4, 4},
                        {4, 16},
                        {-4, 16},
                        {-4, 4},
                        {-16, 4},
                        {-16, -4},
                        {-4, -4}});
}

Region chamfered(double along_side_mm) {
    return makePolygon({{0, 0}, {20, 0}, {20, 10 - along_side_mm}, {20 - along_side_mm, 10}, {0, 10}});
}

int arcCount(const Region& region) {
    int count = 0;
    for (const Loop& loop : region.loops)
        for (const Segment& s : loop.segments)
            count += s.arc.has_value();
    return count;
}

void expectArea(const Region& region, double expected) {
    EXPECT_NEAR(area(region), expected, 1e-9 * expected);
}

void expectRoundedArea(const Region& region, double expected, double arcs_mm) {
    EXPECT_NEAR(area(region), expected, 1e-9 * expected + arcs_mm * kGridMm);
}

}  // namespace stepmill::test
