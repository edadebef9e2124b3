#pragma once

#include <string>
#include <vector>

#include "stepmill/access/access_curve.h"
#include "stepmill/feature/feature.h"

namespace stepmill {

/// A feature and what cutters of every diameter reach of it.
struct FeatureCurve {
    Feature feature;
    AccessCurve curve;
};

/// The curves of a part's features over one range of diameters [Lim2000].
struct PartCurves {
    std::string part_name;
    std::string file;
    double to_mm = 0;                    ///< largest diameter
    std::vector<FeatureCurve> features;  ///< by setup, parents before children
};

/// The sum of all features: its volume, and the area of all floors together. Events stay with the features.
/// Errors add up.
AccessCurve sumOf(const PartCurves& curves);

/// The largest diameter that still reaches this share of what any cutter reaches; to within the curve's
/// error. 0 when the smallest sample already falls short.
double widestReaching(const AccessCurve& curve, double share);

}  // namespace stepmill
