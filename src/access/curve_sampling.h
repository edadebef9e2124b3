#pragma once

#include <vector>

#include "stepmill/access/access.h"

namespace stepmill::access {

/// The curve at one diameter: the area, and the number of pieces and boundaries of the centre region. A neck
/// that closes and a room that vanishes change these numbers even where the area hardly changes.
struct Probe {
    double diameter_mm = 0;
    double area_mm2 = 0;
    std::size_t pieces = 0;
    std::size_t loops = 0;
};

/// Two probes next to each other between which something happens.
struct Bracket {
    Probe low;
    Probe high;

    double drop_mm2() const { return low.area_mm2 - high.area_mm2; }
};

/// The curve of coverable area at single diameters.
struct CurveSamples {
    std::vector<Probe> probes;  ///< by rising diameter
    /// Neighbouring probes, at most two `linear_mm` apart, between which the area or the centre region jumps.
    std::vector<Bracket> jumps;
};

/// Probes at the diameters given, and between them by bisection until straight interpolation errs by no more
/// than `max_error_mm2` and jumps are enclosed.
/// \pre diameters_mm rises and is not empty
CurveSamples sampleCurve(const FeatureGround& ground, const std::vector<double>& diameters_mm,
                         double max_error_mm2);

/// Where the axis of a cutter of that radius may stand, regardless of the rest of the tool.
Region centresFor(const FeatureGround& ground, double radius_mm);

}  // namespace stepmill::access
