#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stepmill/access/access_curve.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/feature/feature.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/part/part.h"
#include "stepmill/setup/setup.h"

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

/// What to draw of a part.
struct CurvesRequest {
    SetupRequest setup;
    SliceOptions slicing;
    double to_mm = 0;  ///< largest diameter; 0: a little beyond the widest cutter that any feature holds
};

/// The curves of the features that inspect names: every setup on the stock that those before it leave when
/// all their features are cut whole.
/// \param progress  told of each stage
/// \throws what chooseSetups and SetupWalk::next do
PartCurves findCurves(const Part& part, const CurvesRequest& request, const Tolerances& tol,
                      const std::function<void(const std::string& stage, double share)>& progress = {});

/// The sum of all features: its volume, and the area of all floors together. Events stay with the features.
/// Errors add up.
AccessCurve sumOf(const PartCurves& curves);

/// The largest diameter that still reaches this share of what any cutter reaches; to within the curve's
/// error. 0 when the smallest sample already falls short.
double widestReaching(const AccessCurve& curve, double share);

}  // namespace stepmill
