#pragma once

#include <string>
#include <vector>

#include "drawing/sketch.h"
#include "stepmill/planar/region.h"

namespace stepmill::drawing {

/// A closed profile, counter-clockwise, each stroke from where the one before ends to where the next begins.
struct Profile {
    std::vector<Stroke> strokes;
    Loop shape;  ///< the same for the plane: splines as chords, points on the grid
};

/// What joining strokes had to mend.
struct Healing {
    int gaps = 0;
    double widest_mm = 0;
};

/// Strokes in mm joined to closed profiles: ends within kHealedGapMm of each other are one corner. Lines
/// reach for the end of an arc or curve, two arcs keep their bulge.
/// \throws Error(InvalidCatalog) naming where a profile is open, or where more than two ends meet
std::vector<Profile> closedProfiles(std::vector<Stroke> strokes, const std::string& file, Healing& healing);

/// The arc that a bulge describes.
/// \pre stroke.bulge != 0
Arc arcOf(const Stroke& stroke);

}  // namespace stepmill::drawing
