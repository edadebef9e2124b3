// What the viewer of a report is given, and its page.

#include <gtest/gtest.h>

#include <cmath>

#include <nlohmann/json.hpp>

#include "report/page/base64.h"
#include "report/page/line_chart.h"
#include "report/viewer/packed_path.h"
#include "report/viewer/part_mesh.h"
#include "report/viewer/stock_field.h"
#include "report/viewer/viewer_data.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/report/report.h"
#include "support/page_check.h"

namespace stepmill::report {
namespace {

using test::expectSoundPage;
using test::readPage;

ProvenPlan provenPart(const std::string& name) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.sequence.retract_mm = defaultMachine().safe_height_mm;
    const std::string file = std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + name + ".step";
    Plan plan =
        planPart(readStep(file).front(), request, defaultToolLibrary(), defaultMachine(), Tolerances());
    PlanFiles files = postedFiles(plan);
    return {std::move(plan), std::move(files), {}};
}

const ProvenPlan& fourSetups() {
    static const ProvenPlan proven = provenPart("four_setups");
    return proven;
}

std::string base64Of(const std::string& text) {
    return base64(std::vector<std::uint8_t>(text.begin(), text.end()));
}

TEST(Base64, IsThatOfTheStandardsExamples) {
    EXPECT_EQ(base64Of(""), "");
    EXPECT_EQ(base64Of("f"), "Zg==");
    EXPECT_EQ(base64Of("fo"), "Zm8=");
    EXPECT_EQ(base64Of("foo"), "Zm9v");
    EXPECT_EQ(base64Of("foobar"), "Zm9vYmFy");
}

/// Reads packed bytes as the page's script does.
class Reader {
  public:
    explicit Reader(const PackedBytes& packed) : bytes_(packed.bytes()) {}

    std::uint8_t byte() { return bytes_.at(at_++); }
    std::int64_t number() {
        std::uint64_t value = 0;
        for (unsigned shift = 0;; shift += 7) {
            const std::uint8_t next = byte();
            value |= static_cast<std::uint64_t>(next & 0x7FU) << shift;
            if (next < 0x80U) break;
        }
        const auto half = static_cast<std::int64_t>(value >> 1U);
        return (value & 1U) != 0 ? -half - 1 : half;
    }
    bool atEnd() const { return at_ == bytes_.size(); }

  private:
    const std::vector<std::uint8_t>& bytes_;
    std::size_t at_ = 0;
};

TEST(PackedBytes, GiveNumbersBack) {
    const std::vector<std::int64_t> numbers{0, 1, -1, 63, -64, 64, 8191, -8192, 123456789012, -123456789012};
    PackedBytes packed;
    for (const std::int64_t number : numbers)
        packed.number(number);
    EXPECT_EQ(packed.bytes().front(), 0);
    Reader reader(packed);
    for (const std::int64_t number : numbers)
        EXPECT_EQ(reader.number(), number);
    EXPECT_TRUE(reader.atEnd());
}

Move feedTo(const Vec3& to) {
    Move move;
    move.kind = MoveKind::Feed;
    move.to = to;
    return move;
}

TEST(PackedPath, MakesOneOfStraightMovesInLineAndKeepsCorners) {
    Toolpath path;
    for (const double x : {1.0, 2.0, 3.0})
        path.moves.push_back(feedTo({x, 0, 0}));
    path.moves.push_back(feedTo({3, 5, 0}));
    path.moves.push_back(feedTo({3, 2, 0}));  // back over itself: no line from the corner to here
    const PackedPath packed_path = packed(path, 0.01, {});
    ASSERT_EQ(packed_path.moves, 3u);
    Reader reader(packed_path.bytes);
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_EQ(reader.number(), 0);
    EXPECT_EQ(reader.byte(), static_cast<std::uint8_t>(MoveKind::Feed));
    EXPECT_EQ(reader.number(), 300);
    EXPECT_EQ(reader.number(), 0);
}

TEST(PackedPath, KeepsAWholeCircleAndMakesNoneOfAShortArc) {
    Toolpath path;
    Move circle = feedTo({0, 0, 0});
    circle.arc = Arc{{1, 0}, 1, true};
    Move speck = feedTo({0.001, 0, 0});
    speck.arc = Arc{{0.0005, 0}, 0.0005, true};
    path.moves = {circle, speck};
    const PackedPath packed_path = packed(path, 0.01, {});
    ASSERT_EQ(packed_path.moves, 1u);
    Reader reader(packed_path.bytes);
    for (int axis = 0; axis < 3; ++axis)
        reader.number();
    EXPECT_EQ(reader.byte(), 0x19);  // a feed along an arc, counter-clockwise
    EXPECT_EQ(reader.number(), 0);
    EXPECT_EQ(reader.number(), 0);
    EXPECT_EQ(reader.number(), 100);
    EXPECT_EQ(reader.number(), 0);
    EXPECT_TRUE(reader.atEnd());
}

TEST(PackedPath, TellsAFeedWhereItChanges) {
    Toolpath path;
    path.feed_mm_per_min = 1000;
    for (const double x : {1.0, 2.0, 3.0, 4.0}) {
        path.moves.push_back(feedTo({x, 0, 0}));
        path.moves.back().feed_mm_per_min = x < 2.5 ? 400.4 : 1500;
    }
    Move rapid = feedTo({5, 0, 0});
    rapid.kind = MoveKind::Rapid;
    path.moves.push_back(rapid);
    path.moves.push_back(feedTo({6, 0, 0}));
    EXPECT_DOUBLE_EQ(fastestFeed(path), 1500);
    const PackedPath packed_path = packed(path, 0.01, {});
    ASSERT_EQ(packed_path.moves, 4u) << "moves of other feeds stay apart";
    Reader reader(packed_path.bytes);
    for (int axis = 0; axis < 3; ++axis)
        reader.number();
    std::vector<std::int64_t> feeds;
    for (std::size_t i = 0; i < packed_path.moves; ++i) {
        const bool changes = (reader.byte() & 0x80) != 0;
        feeds.push_back(changes ? reader.number() : -1);
        reader.number();
        reader.number();
    }
    EXPECT_TRUE(reader.atEnd());
    EXPECT_EQ(feeds, (std::vector<std::int64_t>{400, 1500, -1, 0}))
        << "a rapid keeps it; then that of the kind";
}

TEST(PackedPath, TellsLoadsAsRunsAndKeepsMovesOfOthersApart) {
    Toolpath path;
    for (const double x : {1.0, 2.0, 3.0, 4.0})
        path.moves.push_back(feedTo({x, 0, 0}));
    path.moves.push_back(feedTo({4, 5, 0}));
    const PackedPath packed_path = packed(path, 0.01, {7, 7, 0, 12, 12});
    ASSERT_EQ(packed_path.moves, 4u) << "the first two are one";
    Reader reader(packed_path.loads);
    std::vector<std::int64_t> runs;
    while (!reader.atEnd())
        runs.push_back(reader.number());
    EXPECT_EQ(runs, (std::vector<std::int64_t>{1, 7, 1, 0, 2, 12}));
}

TEST(PackedPath, RoundsPlacesNotSteps) {
    Toolpath path;
    for (int i = 1; i <= 1000; ++i)
        path.moves.push_back(feedTo({0.004 * i, i % 2 == 0 ? 0.0 : 1.0, 0}));
    const PackedPath packed_path = packed(path, 0.0, {});
    Reader reader(packed_path.bytes);
    std::int64_t x = reader.number();
    reader.number();
    reader.number();
    for (std::size_t i = 0; i < packed_path.moves; ++i) {
        reader.byte();
        x += reader.number();
        reader.number();
    }
    EXPECT_EQ(x, packedSteps(4.0));
}

double volumeOf(const StockField& field) {
    double volume_mm3 = 0;
    for (std::size_t i = 0; i < field.top_mm.size(); ++i)
        volume_mm3 += std::max(0.0, field.top_mm[i] - field.bottom_mm[i]);
    return volume_mm3 * field.cell_mm * field.cell_mm;
}

TEST(StockField, OfARawBoxIsTheBox) {
    const stepmill::Setup& setup = fourSetups().plan.setups.front().setup;
    const StockField field = arrivingField(setup, 100);
    EXPECT_EQ(std::max(field.columns, field.rows), 100);
    EXPECT_EQ(field.top_mm.size(), static_cast<std::size_t>(field.columns) * field.rows);
    for (const double top_mm : field.top_mm)
        ASSERT_NEAR(top_mm, 0, 1e-6);
    EXPECT_NEAR(volumeOf(field), setup.stock.volume_mm3, 0.02 * setup.stock.volume_mm3);
}

TEST(StockField, HasWhatEarlierSetupsCutSeenFromBothSides) {
    // The second setup turns the block over: the first one's pocket is seen from below.
    const stepmill::Setup& turned = fourSetups().plan.setups[1].setup;
    EXPECT_LT(volumeOf(arrivingField(turned, 300)), 1.02 * turned.stock.volume_mm3);
    for (const PlannedSetup& planned : fourSetups().plan.setups) {
        const StockField field = arrivingField(planned.setup, 300);
        // Hollows from the side are not told, so it may have more than the stock, never less.
        EXPECT_GT(volumeOf(field), 0.99 * planned.setup.stock.volume_mm3) << planned.setup.id;
        EXPECT_LT(volumeOf(field), 1.02 * planned.setup.stock_bbox_mm.volume()) << planned.setup.id;
    }
}

TEST(PartMesh, HoldsThePartsVolume) {
    const Part& part = fourSetups().plan.part;
    const PartMesh mesh = partMesh(FacetedPart(part));
    std::vector<Vec3> corners;
    for (std::size_t i = 0; i < mesh.corners; ++i) {
        Vec3 corner;
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t at = 6 * i + 2 * static_cast<std::size_t>(axis);
            const double share = (mesh.places.bytes()[at] + 256.0 * mesh.places.bytes()[at + 1]) / 65535;
            corner[axis] = mesh.box_mm.min()[axis] + share * mesh.box_mm.sizes()[axis];
        }
        corners.push_back(corner);
    }
    Reader sides(mesh.sides);
    double volume_mm3 = 0;
    std::int64_t number = 0;
    for (std::size_t i = 0; i < mesh.triangles; ++i) {
        Vec3 triangle[3];
        for (Vec3& corner : triangle)
            corner = corners.at(static_cast<std::size_t>(number += sides.number()));
        volume_mm3 += triangle[0].dot(triangle[1].cross(triangle[2])) / 6;
    }
    EXPECT_TRUE(sides.atEnd());
    EXPECT_NEAR(volume_mm3, part.volume_mm3, 0.002 * part.volume_mm3);
}

TEST(ViewerData, TellsLoadsWhereFeedsFollowWhatIsCut) {
    const auto loads = [](const PlanRequest& request) {
        const std::string file = std::string(STEPMILL_SOURCE_DIR) + "/step_parts/rounded_pocket.step";
        Plan plan =
            planPart(readStep(file).front(), request, defaultToolLibrary(), defaultMachine(), Tolerances());
        PlanFiles files = postedFiles(plan);
        const ProvenPlan proven{std::move(plan), std::move(files), {}};
        const nlohmann::json data =
            nlohmann::json::parse(viewerData(proven, FacetedPart(proven.plan.part), false));
        return data["setups"][0]["operations"][0]["loads"].get<std::string>();
    };
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.sequence.retract_mm = defaultMachine().safe_height_mm;
    EXPECT_EQ(loads(request), "");
    request.sequence.cut_material = *defaultMaterials().find("aluminium");
    EXPECT_GT(loads(request).size(), 20u);
}

TEST(ViewerData, HasAllOperationsWithTheirFirstLines) {
    const ProvenPlan& proven = fourSetups();
    const nlohmann::json data =
        nlohmann::json::parse(viewerData(proven, FacetedPart(proven.plan.part), false));
    ASSERT_EQ(data["setups"].size(), proven.plan.setups.size());
    for (std::size_t i = 0; i < proven.plan.setups.size(); ++i) {
        const PlannedSetup& setup = proven.plan.setups[i];
        const nlohmann::json& told = data["setups"][i];
        ASSERT_EQ(told["operations"].size(), setup.operations.size());
        for (std::size_t k = 0; k < setup.operations.size(); ++k) {
            EXPECT_EQ(told["operations"][k]["id"], setup.operations[k].id);
            EXPECT_GT(told["operations"][k]["line"], 0) << setup.operations[k].id;
        }
    }
}

constexpr int kScripts = 4;

TEST(ReportWithViewer, IsSoundButForItsOwnScripts) {
    const std::string page = reportHtml(fourSetups(), ReportOptions(), Tolerances());
    EXPECT_EQ(readPage(page).errors, std::vector<std::string>());
    expectSoundPage(test::withoutOwnScripts(page, kScripts), "report.html");
    EXPECT_NE(page.find("default-src 'none'; script-src 'sha256-"), std::string::npos);
    EXPECT_EQ(page, reportHtml(fourSetups(), ReportOptions(), Tolerances()));
}

TEST(ReportWithViewer, IsPlainWithoutOnRequest) {
    ReportOptions plain;
    plain.viewer = false;
    const std::string page = reportHtml(fourSetups(), plain, Tolerances());
    expectSoundPage(page, "report.html");
    EXPECT_EQ(page.find("<script"), std::string::npos);
}

TEST(ReportWithViewer, TellsInchesThroughout) {
    ReportOptions inches;
    inches.viewer = false;
    inches.inch = true;
    const std::string text = readPage(reportHtml(fourSetups(), inches, Tolerances())).text;
    for (const char* there : {"depth in", "area in²", "volume in³", "feed in/min", "cut ft", "step-over in"})
        EXPECT_NE(text.find(there), std::string::npos) << there;
    for (const char* gone : {"mm²", "cm³", "mm³", "mm/min", "depth mm"})
        EXPECT_EQ(text.find(gone), std::string::npos) << gone;
}

TEST(ReportCharts, DrawWhatThePlanHasWeighed) {
    const std::string text = readPage(reportHtml(fourSetups().plan, Tolerances())).text;
    for (const char* there :
         {"by the cutter alone (TAD)", "DVCD: in front of rank 0", "the runner-up", "What each tool reaches",
          "From which tool change time on", "may be the last", "pairs were never weighed"})
        EXPECT_NE(text.find(there), std::string::npos) << there;
}

TEST(LineChart, IsADrawingOfItsOwn) {
    const LineChart chart{"<a> & b",
                          "x [mm]",
                          "y [s]",
                          {{"one", {{0, 1}, {2, 3}}, true}, {"two", {{1, 1}, {4, 2}}, false}},
                          {{1.5, "now"}}};
    expectSoundPage(lineChart(chart).markup(), "chart");
}

}  // namespace
}  // namespace stepmill::report
