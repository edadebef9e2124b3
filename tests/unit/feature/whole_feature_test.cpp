#include "stepmill/feature/whole_feature.h"

#include <gtest/gtest.h>

namespace stepmill {
namespace {

struct Item {
    Feature feature;
};

Item band(const std::string& whole, int number, int count, FeatureClass feature_class) {
    Item item;
    item.feature.id = bandId(whole, number, count);
    item.feature.feature_class = feature_class;
    item.feature.top_z_mm = 1.0 - number;
    item.feature.floor_z_mm = -number;
    item.feature.volume_mm3 = 10 * number;
    if (count > 1) item.feature.band = Band{whole, number, count};
    return item;
}

TEST(WholeFeatures, HaveTheirBandsFromAboveInTheOrderOfTheFirst) {
    const std::vector<Item> bands{band("S1.F1", 1, 2, FeatureClass::ClosedPocket),
                                  band("S1.F2", 1, 1, FeatureClass::Step),
                                  band("S1.F1", 2, 2, FeatureClass::ClosedPocket)};
    const auto features = wholeFeatures(bands);
    ASSERT_EQ(features.size(), 2u);
    EXPECT_EQ(features[0].id(), "S1.F1");
    EXPECT_EQ(features[0].bands, (std::vector<const Item*>{&bands[0], &bands[2]}));
    EXPECT_DOUBLE_EQ(features[0].depth_mm(), 2);
    EXPECT_DOUBLE_EQ(features[0].volume_mm3(), 30);
    EXPECT_EQ(features[1].id(), "S1.F2");
    EXPECT_EQ(features[1].bands.size(), 1u);
}

TEST(WholeFeatures, AreCalledByTheirMouthUnlessTheyGoThrough) {
    const std::vector<Item> bands{
        band("S1.F1", 1, 2, FeatureClass::OpenPocket), band("S1.F1", 2, 2, FeatureClass::ClosedPocket),
        band("S1.F2", 1, 2, FeatureClass::ClosedPocket), band("S1.F2", 2, 2, FeatureClass::HoleThrough)};
    const auto features = wholeFeatures(bands);
    EXPECT_EQ(features[0].featureClass(), FeatureClass::OpenPocket);
    EXPECT_EQ(features[1].featureClass(), FeatureClass::HoleThrough);
}

TEST(WholeFeatures, ThatNarrowAreNoHoles) {
    std::vector<Item> bands{band("S1.F1", 1, 2, FeatureClass::HoleBlind),
                            band("S1.F1", 2, 2, FeatureClass::HoleBlind)};
    bands[0].feature.target = makeCircle({0, 0}, 5);
    bands[1].feature.target = makeCircle({0, 0}, 4.9);
    EXPECT_EQ(wholeFeatures(bands).front().featureClass(), FeatureClass::HoleBlind);
    bands[1].feature.target = makeCircle({0, 0}, 1);
    EXPECT_EQ(wholeFeatures(bands).front().featureClass(), FeatureClass::ClosedPocket);
}

TEST(WholeFeatures, NameTheirBandsByNumberUnlessThereIsButOne) {
    EXPECT_EQ(bandId("S1.F3", 1, 1), "S1.F3");
    EXPECT_EQ(bandId("S1.F3", 1, 4), "S1.F3.1");
    EXPECT_EQ(wholeOf(band("S1.F3", 2, 4, FeatureClass::Face).feature), "S1.F3");
    EXPECT_EQ(bandNumber(band("S1.F3", 2, 4, FeatureClass::Face).feature), 2);
    EXPECT_EQ(bandNumber(band("S1.F3", 1, 1, FeatureClass::Face).feature), 1);
}

}  // namespace
}  // namespace stepmill
