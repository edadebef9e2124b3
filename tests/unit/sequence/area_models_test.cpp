#include "stepmill/sequence/advice/area_models.h"

#include <gtest/gtest.h>

#include "support/sample_feature.h"

namespace stepmill::test {
namespace {

TEST(AreaModels, YaosEdgeIsChangePlusNewAreaOverRadius) {
    AreaModelTool tool;
    tool.radius_mm = 5;
    tool.area_mm2 = 300;
    EXPECT_DOUBLE_EQ(yaoEdgeS(0, tool, {7, 0.1}), 7 + 0.1 * 300 / 5);
    EXPECT_DOUBLE_EQ(yaoEdgeS(100, tool, {7, 0.1}), 7 + 0.1 * 200 / 5);
}

TEST(AreaModels, LimsEdgeIsChangePlusNewVolumeOverRate) {
    AreaModelTool tool;
    tool.volume_mm3 = 900;
    tool.rate_mm3_per_s = 30;
    EXPECT_DOUBLE_EQ(limEdgeS(300, tool, 4), 4 + 20.0);
}

TEST(AreaModels, CountWholeDepthsOfCut) {
    const ToolAssembly mill = makeMill(10, 1200, 4);  // step-over 5
    const AreaModelTool tool = areaModelTool(5, 200, 10, mill.cutting.front());
    // 10 mm in steps of 4: three layers; 5 x 1200 / 60 = 100 mm2/s a layer.
    EXPECT_DOUBLE_EQ(tool.area_rate_mm2_per_s, 100.0 / 3);
    EXPECT_DOUBLE_EQ(limEdgeS(0, tool, 0), 3 * 200 / 100.0);
    EXPECT_DOUBLE_EQ(removalRateMm3PerS(mill.cutting.front()), 5 * 4 * 20.0);
}

TEST(AreaModels, YaosFactorMakesBothModelsAgreeForOneTool) {
    const AreaModelTool tool = areaModelTool(5, 200, 10, makeMill(10).cutting.front());
    const YaoConstants constants{3, yaoFactorSPerMm({tool})};
    EXPECT_NEAR(yaoEdgeS(0, tool, constants), limEdgeS(0, tool, 3), 1e-12);
    EXPECT_EQ(yaoFactorSPerMm({}), 0);
}

TEST(AreaModels, CheapestSequencesEndWithFullAccess) {
    AreaModelTool large{10, 80, 800, 100, 10};
    AreaModelTool small{3, 100, 1000, 10, 1};
    EXPECT_EQ(cheapestByLim({large, small}, 1).tools, (std::vector<int>{0, 1}));
    EXPECT_EQ(cheapestByLim({large, small}, 1000).tools, (std::vector<int>{1}));
    EXPECT_EQ(cheapestByYao({large, small}, {1, 1}).tools, (std::vector<int>{0, 1}));
    EXPECT_DOUBLE_EQ(cheapestByLim({large, small}, 1).cost, 8 + 20 + 2);
    EXPECT_DOUBLE_EQ(cheapestByLim({large, small}, 1, FirstChange::Free).cost, 8 + 20 + 1);
    EXPECT_TRUE(cheapestByLim({}, 1).tools.empty());
}

}  // namespace
}  // namespace stepmill::test
