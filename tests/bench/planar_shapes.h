#pragma once

#include <string>
#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill::bench {

/// A region to measure planar kernels on.
struct Shape {
    std::string name;
    Region region;
};

/// a: 70 x 50 mm pocket, corner radius 6, round island; b: butterfly with two necks; c: 120 lines, 40 arcs,
/// 6 islands; d: free form of 2000 vertices. Seeded: the same on every machine.
std::vector<Shape> planarShapes();

/// Free form of that many straight edges, each about as long whatever their number.
Region freeForm(int edges);

}  // namespace stepmill::bench
