#include <gtest/gtest.h>

#include "stepmill/plan/deep_bands.h"
#include "support/tool_makers.h"

namespace stepmill {
namespace {

using test::kMaterial;

ToolAssembly mill(const std::string& id, double diameter_mm, double holder_from_mm) {
    ToolAssembly tool = test::bareTool(id, ToolType::Flat, diameter_mm);
    tool.cutting.push_back(test::cuttingData(diameter_mm / 2, 2));
    return test::inHolder(tool, holder_from_mm, diameter_mm + 20);
}

Feature feature(const std::string& id, FeatureClass feature_class, double depth_mm,
                std::vector<std::string> parents = {}) {
    Feature made;
    made.id = id;
    made.feature_class = feature_class;
    made.floor_z_mm = -depth_mm;
    made.volume_mm3 = 10 * depth_mm;
    made.through = true;
    made.parents = std::move(parents);
    return made;
}

/// The widest mill stays above 40 mm; a narrower one reaches farther.
ToolLibrary library() {
    ToolLibrary tools;
    tools.tools = {mill("EM20", 20, 40), mill("EM6L", 6, 90)};
    return tools;
}

TEST(DeepBands, AFeatureDeeperThanTheWidestMillReachesIsParted) {
    const std::vector<Feature> bands = inBands({feature("S1.F1", FeatureClass::ThroughPocket, 100),
                                                feature("S1.F2", FeatureClass::ClosedPocket, 30, {"S1.F1"})},
                                               library(), kMaterial);
    ASSERT_EQ(bands.size(), 4U);
    EXPECT_EQ(bands[0].id, "S1.F1.1");
    EXPECT_DOUBLE_EQ(bands[0].top_z_mm, 0);
    EXPECT_FALSE(bands[0].through);
    EXPECT_TRUE(bands[0].parents.empty());
    EXPECT_EQ(bands[0].band->of, "S1.F1");
    EXPECT_TRUE(bands[0].band->isUpper());
    EXPECT_FALSE(bands[2].band->isUpper());
    EXPECT_FALSE(bands[3].band.has_value());
    for (int i = 1; i < 3; ++i) {
        EXPECT_DOUBLE_EQ(bands[i].top_z_mm, bands[i - 1].floor_z_mm);
        EXPECT_EQ(bands[i].parents, std::vector<std::string>{bands[i - 1].id});
        EXPECT_NEAR(bands[i].volume_mm3, 1000.0 / 3, 1e-9);
    }
    EXPECT_DOUBLE_EQ(bands[2].floor_z_mm, -100);
    EXPECT_TRUE(bands[2].through);
    EXPECT_EQ(bands[3].id, "S1.F2") << "not deep";
    EXPECT_EQ(bands[3].parents, std::vector<std::string>{"S1.F1.3"}) << "waits for the lowest band";
}

TEST(DeepBands, HolesStayWholeAndSoDoesAllWithoutMills) {
    const std::vector<Feature> features = {feature("S1.F1", FeatureClass::HoleThrough, 100)};
    EXPECT_EQ(inBands(features, library(), kMaterial).size(), 1U);
    EXPECT_EQ(inBands({feature("S1.F1", FeatureClass::ClosedPocket, 100)}, {}, kMaterial).size(), 1U);
}

TEST(DeepBands, ABandThatIsTooDeepIsPartedAndAllAreNumberedAnew) {
    Feature upper = feature("S1.F1.1", FeatureClass::ClosedPocket, 60);
    upper.band = Band{"S1.F1", 1, 2};
    Feature lower = feature("S1.F1.2", FeatureClass::ClosedPocket, 70, {"S1.F1.1"});
    lower.top_z_mm = -60;
    lower.band = Band{"S1.F1", 2, 2};
    const std::vector<Feature> bands = inBands(
        {upper, lower, feature("S1.F2", FeatureClass::ClosedPocket, 30, {"S1.F1.2"})}, library(), kMaterial);
    ASSERT_EQ(bands.size(), 4U);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(bands[i].id, "S1.F1." + std::to_string(i + 1));
        EXPECT_EQ(bands[i].band->number, i + 1);
        EXPECT_EQ(bands[i].band->count, 3);
    }
    EXPECT_EQ(bands[2].parents, std::vector<std::string>{"S1.F1.2"});
    EXPECT_EQ(bands[3].parents, std::vector<std::string>{"S1.F1.3"});
}

}  // namespace
}  // namespace stepmill
