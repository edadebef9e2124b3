#include "stepmill/feature/feature.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill {
namespace {

/// Classes with walls on both sides of the cutter, where the widest disc in the target is the widest cutter.
bool hasFloorBetweenWalls(FeatureClass feature_class) {
    return feature_class == FeatureClass::ClosedPocket || feature_class == FeatureClass::SlotBlind ||
           feature_class == FeatureClass::SlotThrough;
}

/// Wide enough as its area over half its boundary shows at once; a disc need not be looked for.
bool plainlyWider(const Feature& feature, double width_mm) {
    // A disc of diameter w that fits nowhere leaves less area than w times half the boundary.
    return 2 * feature.area_mm2 > width_mm * perimeter(feature.target);
}

}  // namespace

void nameEngravings(FeatureSet& found, double smallest_cutter_mm, const Tolerances& tol) {
    for (Feature& feature : found.features) {
        if (!hasFloorBetweenWalls(feature.feature_class) || plainlyWider(feature, smallest_cutter_mm))
            continue;
        const auto disc = ClearanceDiagram(feature.target, tol).largestInscribedDisc();
        if (disc && 2 * disc->radius_mm < smallest_cutter_mm - tol.linear_mm)
            feature.feature_class = FeatureClass::Engraving;
    }
}

}  // namespace stepmill
