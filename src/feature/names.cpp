#include <algorithm>

#include "stepmill/core/enum_words.h"
#include "stepmill/feature/feature.h"

namespace stepmill {
namespace {

constexpr EnumWord<FeatureClass> kFeatureClasses[] = {{FeatureClass::Face, "face"},
                                                      {FeatureClass::ClosedPocket, "closed pocket"},
                                                      {FeatureClass::OpenPocket, "open pocket"},
                                                      {FeatureClass::SlotBlind, "blind slot"},
                                                      {FeatureClass::SlotThrough, "through slot"},
                                                      {FeatureClass::Step, "step"},
                                                      {FeatureClass::ThroughPocket, "through pocket"},
                                                      {FeatureClass::OpenProfile, "open profile"},
                                                      {FeatureClass::HoleBlind, "blind hole"},
                                                      {FeatureClass::HoleThrough, "through hole"},
                                                      {FeatureClass::Engraving, "engraving"}};

}  // namespace

std::string toString(FeatureClass feature_class) {
    return wordOf(kFeatureClasses, feature_class);
}

bool isHole(FeatureClass feature_class) {
    return feature_class == FeatureClass::HoleBlind || feature_class == FeatureClass::HoleThrough;
}

double highestMm(const Feature& feature) {
    double highest_mm = feature.top_z_mm;
    for (const Obstacle& obstacle : feature.obstacles)
        if (!obstacle.section.empty()) highest_mm = std::max(highest_mm, obstacle.top_z_mm);
    return highest_mm;
}

bool hasFloor(FeatureClass feature_class) {
    return feature_class != FeatureClass::HoleThrough && feature_class != FeatureClass::ThroughPocket &&
           feature_class != FeatureClass::OpenProfile;
}

std::optional<FeatureClass> featureClassFrom(std::string_view word) {
    return valueOf(kFeatureClasses, word);
}

}  // namespace stepmill
