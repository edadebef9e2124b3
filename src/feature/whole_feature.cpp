#include "stepmill/feature/whole_feature.h"

#include <fmt/format.h>

namespace stepmill {

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
    return hasFloor(lowest.feature_class) ? uppermost.feature_class : lowest.feature_class;
}

}  // namespace stepmill
