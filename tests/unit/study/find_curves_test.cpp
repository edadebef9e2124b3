#include <gtest/gtest.h>

#include "stepmill/study/curves.h"
#include "stepmill/study/inspection.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

/// Ground that two setups could reach is the first one's, as inspect says.
TEST(FindCurves, AreOfTheFeaturesThatInspectNames) {
    const Part part = readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/four_setups.step").front();
    CurvesRequest request;
    request.to_mm = 10;
    const PartCurves curves = findCurves(part, request, kTol);
    std::vector<std::pair<std::string, double>> inspected;
    for (const InspectedSetup& setup : inspectPart(part, {}, kTol).setups)
        for (const InspectedFeature& feature : setup.features)
            inspected.emplace_back(feature.feature.id, feature.feature.volume_mm3);
    std::vector<std::pair<std::string, double>> drawn;
    for (const FeatureCurve& feature : curves.features)
        drawn.emplace_back(feature.feature.id, feature.feature.volume_mm3);
    EXPECT_EQ(drawn, inspected);
}

TEST(FindCurves, HoldTheVolumeOfStockMinusPartOnce) {
    const Part part = readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/four_setups.step").front();
    CurvesRequest request;
    request.to_mm = 10;
    double volume_mm3 = 0;
    for (const FeatureCurve& feature : findCurves(part, request, kTol).features)
        volume_mm3 += feature.feature.volume_mm3;
    const double stock_mm3 = chooseSetups(part, {}).front().stock.volume_mm3;
    EXPECT_NEAR(volume_mm3, stock_mm3 - part.volume_mm3, 1e-3 * stock_mm3);
}

}  // namespace
}  // namespace stepmill
