#pragma once

#include "stepmill/planar/region.h"
#include "support/shape_makers.h"

namespace stepmill::test {

/// Area of a rectangle with rounded corners.
double roundedArea(double width, double height, double radius);

/// 70 x 50 pocket about the origin, corner radius 6, round island of 16 mm in the middle.
Region pocketWithIsland();

/// Two rooms of 20 x 20, joined by a neck 10 long and 6 wide about the x axis.
Region dogBone();

/// Circle of radius 17 about the origin with a hole of radius 11 at (4, 0): the gap is 2 wide on the right,
/// 10 on the left.
Region eccentricRing();

/// Arms 8 wide and 32 from end to end about the origin.
Region cross();

/// Rectangle 20 x 10 from the origin whose upper right corner is cut off at 45 degrees over that length of
/// both sides.
Region chamfered(double along_side_mm);

int arcCount(const Region& region);

/// Equal to a billionth.
void expectArea(const Region& region, double expected);

/// Equal to a billionth, but for the rounding of corners to the grid, which moves that length of arcs.
void expectRoundedArea(const Region& region, double expected, double arcs_mm);

}  // namespace stepmill::test
