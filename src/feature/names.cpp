#include "stepmill/core/error.h"
#include "stepmill/feature/feature.h"

namespace stepmill {

std::string toString(FeatureClass feature_class) {
    switch (feature_class) {
        case FeatureClass::Face:
            return "face";
        case FeatureClass::ClosedPocket:
            return "closed pocket";
        case FeatureClass::OpenPocket:
            return "open pocket";
        case FeatureClass::SlotBlind:
            return "blind slot";
        case FeatureClass::SlotThrough:
            return "through slot";
        case FeatureClass::Step:
            return "step";
        case FeatureClass::ThroughPocket:
            return "through pocket";
        case FeatureClass::OpenProfile:
            return "open profile";
        case FeatureClass::HoleBlind:
            return "blind hole";
        case FeatureClass::HoleThrough:
            return "through hole";
        case FeatureClass::Engraving:
            return "engraving";
    }
    throw Error(ErrorCode::Internal, "feature class", "unknown value");
}

bool isHole(FeatureClass feature_class) {
    return feature_class == FeatureClass::HoleBlind || feature_class == FeatureClass::HoleThrough;
}

bool hasFloor(FeatureClass feature_class) {
    return feature_class != FeatureClass::HoleThrough && feature_class != FeatureClass::ThroughPocket &&
           feature_class != FeatureClass::OpenProfile;
}

std::optional<FeatureClass> featureClassFrom(std::string_view word) {
    for (int i = 0; i <= static_cast<int>(FeatureClass::Engraving); ++i)
        if (toString(static_cast<FeatureClass>(i)) == word) return static_cast<FeatureClass>(i);
    return std::nullopt;
}

}  // namespace stepmill
