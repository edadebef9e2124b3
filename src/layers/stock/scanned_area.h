#pragma once

#include <limits>
#include <vector>

#include "layers/indexed_region.h"

namespace stepmill::layers {

/// A polygon as its edges, less what lies outside a band. Loops in any order; inside is where a line has
/// crossed an odd number of edges.
struct BandedPolygon {
    struct Side {
        Vec2 from;
        Vec2 to;
    };
    std::vector<Side> sides;
    Vec2 across = Vec2::Zero();  ///< the band: low <= across . p <= high
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
};

/// Sides of the polygon through the region's corners.
/// \pre no arcs
BandedPolygon banded(const Region& polygon);
BandedPolygon banded(const Box2& box);

/// Area that polygons cover together within a region [mm2], along lines of constant y: two between
/// neighbouring corners, where lengths along them are linear but for the region's arcs and where two polygons
/// cross. No boolean is computed, and the sum is good to about a thousandth.
///
/// O(lines x polygons + edges x the lines they cross).
double scannedArea(const IndexedRegion& within, const std::vector<BandedPolygon>& polygons);

}  // namespace stepmill::layers
