#include "stepmill/feature/whole_feature.h"

#include <fmt/format.h>

#include "stepmill/feature/hole_group.h"

namespace stepmill {
namespace {

/// A round recess that is so much narrower at its bottom is a dimple, no hole: nobody drills it.
constexpr double kAsWideShare = 0.9;

}  // namespace

std::string bandId(const std::string& whole_id, int number, int count) {
    return count == 1 ? whole_id : fmt::format("{}.{}", whole_id, number);
}

const std::string& wholeOf(const Feature& band) {
    return band.band ? band.band->of : band.id;
}

int bandNumber(const Feature& band) {
    return band.band ? band.band->number : 1;
}

int bandCount(const Feature& band) {
    return band.band ? band.band->count : 1;
}

FeatureClass classOfWhole(const Feature& uppermost, const Feature& lowest) {
    if (!hasFloor(lowest.feature_class)) return lowest.feature_class;
    if (!isHole(uppermost.feature_class)) return uppermost.feature_class;
    const bool as_wide =
        isHole(lowest.feature_class) && holeRadiusMm(lowest) >= kAsWideShare * holeRadiusMm(uppermost);
    return as_wide ? uppermost.feature_class : FeatureClass::ClosedPocket;
}

}  // namespace stepmill
