#pragma once

#include <map>
#include <string>
#include <vector>

#include "stepmill/feature/feature.h"

namespace stepmill {

/// "S1.F2.3" for the third band of S1.F2; "S1.F2" where it is the only one.
std::string bandId(const std::string& whole_id, int number, int count);

/// Id of the feature, as a programmer would name it, that a band belongs to: "S1.F2" of S1.F2.3.
const std::string& wholeOf(const Feature& band);
/// From above, from 1 on.
int bandNumber(const Feature& band);
/// How many bands its feature was parted into; 1 where it is the only one.
int bandCount(const Feature& band);

/// What a feature is as a whole: what goes through is called by where it comes out, all else by its mouth; a
/// round recess that narrows to its bottom is a closed pocket.
FeatureClass classOfWhole(const Feature& uppermost, const Feature& lowest);

/// A feature as a programmer names it: all its bands, from above; one where it is prismatic.
/// \tparam Item  a band with what is known of it beside, in a member `feature`
template <typename Item>
struct WholeFeature {
    std::vector<const Item*> bands;  ///< never empty

    const Feature& uppermost() const { return bands.front()->feature; }
    const Feature& lowest() const { return bands.back()->feature; }
    const std::string& id() const { return wholeOf(uppermost()); }
    FeatureClass featureClass() const { return classOfWhole(uppermost(), lowest()); }
    double depth_mm() const { return uppermost().top_z_mm - lowest().floor_z_mm; }

    /// The sum over the bands of what `value` tells of one.
    template <typename Value>
    double sum(Value value) const {
        double all = 0;
        for (const Item* band : bands)
            all += value(*band);
        return all;
    }
    double volume_mm3() const {
        return sum([](const Item& band) { return band.feature.volume_mm3; });
    }
};

/// The features that the bands make up, in the order of their uppermost bands: parents before children where
/// the bands stand so.
/// \param bands  outlive what is returned
template <typename Item>
std::vector<WholeFeature<Item>> wholeFeatures(const std::vector<Item>& bands) {
    std::vector<WholeFeature<Item>> features;
    std::map<std::string, std::size_t> place;
    for (const Item& band : bands) {
        const auto [found, is_new] = place.emplace(wholeOf(band.feature), features.size());
        if (is_new) features.emplace_back();
        features[found->second].bands.push_back(&band);
    }
    return features;
}

}  // namespace stepmill
