#include <sstream>

#include <gtest/gtest.h>

#include "stepmill/report/curves.h"
#include "support/page_check.h"
#include "support/told.h"

namespace stepmill {
namespace {

/// A feature whose curve falls from 100 to 60 mm2 in a jump at 10 mm and to nothing at 20 mm.
FeatureCurve stepCurve(const std::string& id, double depth_mm) {
    FeatureCurve result;
    result.feature.id = id;
    result.feature.floor_z_mm = -depth_mm;
    result.feature.target = makeRectangle({0, 0}, {10, 10});
    result.feature.area_mm2 = 100;
    for (const auto& [diameter, area] : std::vector<std::pair<double, double>>{
             {0, 100}, {9.9999, 100}, {10, 60}, {19.9999, 60}, {20, 0}, {30, 0}})
        result.curve.samples.push_back({diameter, area, area * depth_mm});
    result.curve.events.push_back({10, AccessEventKind::Neck, {Vec2(1, 2)}, 100, 60});
    result.curve.events.push_back({20, AccessEventKind::Vanishes, {Vec2(5, 5)}, 60, 0});
    result.curve.max_error_mm2 = 0.1;
    return result;
}

PartCurves twoFeatures() {
    return {"plate <1>", "plate.step", 30, {stepCurve("S1.F1", 2), stepCurve("S1.F2", 3)}};
}

TEST(Curves, OfThePartAreTheSumOfItsFeatures) {
    const AccessCurve sum = sumOf(twoFeatures());
    EXPECT_DOUBLE_EQ(sum.volumeAt(5), 500);
    EXPECT_DOUBLE_EQ(sum.volumeAt(15), 300);
    EXPECT_DOUBLE_EQ(sum.areaAt(15), 120);
    EXPECT_DOUBLE_EQ(sum.volumeAt(25), 0);
    EXPECT_DOUBLE_EQ(sum.max_error_mm2, 0.2);
}

TEST(Curves, TellTheWidestCutterThatReachesAShare) {
    const AccessCurve curve = stepCurve("S1.F1", 2).curve;
    EXPECT_DOUBLE_EQ(widestReaching(curve, 0.99), 9.9999);
    EXPECT_DOUBLE_EQ(widestReaching(curve, 0.5), 19.9999);
}

TEST(Curves, AsCsvHaveFiveColumnsInEveryRowAndFallWithinEachFeature) {
    std::istringstream csv(curvesCsv(twoFeatures()));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line, "diameter_mm,feature,coverable_area_mm2,access_volume_mm3,event");
    std::map<std::string, double> last_area;
    int events = 0;
    while (std::getline(csv, line)) {
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), 4) << line;
        std::istringstream cells(line);
        std::string diameter, feature, area, volume, event;
        std::getline(cells, diameter, ',');
        std::getline(cells, feature, ',');
        std::getline(cells, area, ',');
        std::getline(cells, volume, ',');
        std::getline(cells, event, ',');
        if (last_area.count(feature) > 0) {
            EXPECT_LE(std::stod(area), last_area[feature]) << line;
        }
        last_area[feature] = std::stod(area);
        if (!event.empty()) ++events;
        if (feature == "S1.F1" && event.rfind("neck", 0) == 0) {
            EXPECT_EQ(event, "neck at (1.0000 2.0000)");
        }
    }
    EXPECT_EQ(events, 4);
    EXPECT_EQ(last_area.size(), 3u);  // two features and the part
}

TEST(Curves, AsPageNameTheirEventsAndEscapeNames) {
    const std::string html = curvesHtml(twoFeatures());
    test::expectSoundPage(html, "curves.html");
    EXPECT_NE(html.find("plate &lt;1&gt;"), std::string::npos);
    EXPECT_NE(html.find("neck of this width"), std::string::npos);
    EXPECT_NE(html.find("widest disc of a room"), std::string::npos);
    EXPECT_TRUE(test::tells(html, {"cutters", "10.00 mm"}));
}

TEST(Curves, OfAPartWithoutFeaturesSaySo) {
    EXPECT_NE(curvesHtml({"block", "block.step", 10, {}}).find("No feature to machine"), std::string::npos);
    EXPECT_EQ(curvesCsv({"block", "block.step", 10, {}}),
              "diameter_mm,feature,coverable_area_mm2,access_volume_mm3,event\n");
}

}  // namespace
}  // namespace stepmill
