// Pictures of a stock before and after a setup.

#include <algorithm>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "report/sheets/scene_raster.h"
#include "report/sheets/traced_lines.h"

namespace stepmill::report {
namespace {

const Eigen::Isometry3d kHere = Eigen::Isometry3d::Identity();
constexpr double kChordMm = 0.01;

Prism block(const Vec2& min, const Vec2& max, double bottom_mm, double top_mm) {
    return {makeRectangle(min, max), top_mm, bottom_mm};
}

/// From straight above: a cell a millimetre, 40 of them along x, 20 along y.
Sight fromAbove() {
    return {Vec3::UnitZ(), Vec3::UnitX(), Box3(Vec3(0, 0, -10), Vec3(40, 20, 0)), 40};
}

std::vector<Body> blockWith(BodyKind kind, const Prism& prism) {
    return {prismBody(BodyKind::Raw, block({0, 0}, {40, 20}, -10, 0), kHere, kChordMm),
            prismBody(kind, prism, kHere, kChordMm)};
}

TEST(StockImages, ShowThePocketBeforeItIsCutAndItsFloorAfter) {
    const StockImages images =
        stockImages(blockWith(BodyKind::CutHere, block({10, 5}, {20, 15}, -4, 0)), fromAbove());
    const SeenCell& before = images.arriving.at(15, 10);
    EXPECT_EQ(before.what, Shown::CutHere);
    EXPECT_NEAR(before.depth_mm, 0, 1e-9);
    const SeenCell& after = images.leaving.at(15, 10);
    EXPECT_EQ(after.what, Shown::CutHere);
    EXPECT_NEAR(after.depth_mm, -4, 1e-9);
    EXPECT_EQ(images.arriving.at(30, 10).what, Shown::Stock);
    EXPECT_EQ(images.leaving.at(30, 10).what, Shown::Stock);
}

TEST(StockImages, ShowNothingThroughAHole) {
    const StockImages images =
        stockImages(blockWith(BodyKind::Cut, block({10, 5}, {20, 15}, -10, 0)), fromAbove());
    EXPECT_EQ(images.arriving.at(15, 10).what, Shown::Nothing);
    EXPECT_EQ(images.leaving.at(15, 10).what, Shown::Nothing);
}

TEST(StockImages, LeaveOutSkinsThinnerThanChordsAreOff) {
    const StockImages skin =
        stockImages(blockWith(BodyKind::Cut, block({10, 5}, {20, 15}, -10, -0.02)), fromAbove());
    EXPECT_EQ(skin.arriving.at(15, 10).what, Shown::Nothing);
    const StockImages sheet =
        stockImages(blockWith(BodyKind::Cut, block({10, 5}, {20, 15}, -10, -0.5)), fromAbove());
    EXPECT_EQ(sheet.arriving.at(15, 10).what, Shown::Stock);
}

TEST(StockImages, ShowAFixtureInFrontOfTheStock) {
    const StockImages images =
        stockImages(blockWith(BodyKind::Fixture, block({10, 5}, {20, 15}, 0, 6)), fromAbove());
    EXPECT_EQ(images.arriving.at(15, 10).what, Shown::Fixture);
    EXPECT_NEAR(images.leaving.at(15, 10).depth_mm, 6, 1e-9);
}

TEST(StockImages, ShowACylinderAsOneSmoothWall) {
    const Sight sight(Vec3(-1, -1, 1), Vec3(1, -1, 0), Box3(Vec3(0, 0, -20), Vec3(20, 20, 0)), 200);
    const Prism cylinder{makeCircle({10, 10}, 10), 0, -20};
    const StockImages images = stockImages({prismBody(BodyKind::Raw, cylinder, kHere, kChordMm)}, sight);
    const std::string edges = strokesOf(images.arriving, sight.cell_mm()).edges;
    // Outline and rim have points; chords of the wall, well inside of it, have none.
    std::istringstream points(std::regex_replace(edges, std::regex("[ML]"), " "));
    int count = 0;
    for (double x = 0, y = 0; points >> x >> y; ++count)
        EXPECT_FALSE(x > 40 && x < 130 && y > 95 && y < 150) << x << " " << y;
    EXPECT_GT(count, 10);
}

TEST(TracedLines, StraightenTheOutlineOfASquare) {
    const StockImages images = stockImages(
        {prismBody(BodyKind::Raw, block({5, 5}, {15, 15}, -10, 0), kHere, kChordMm)}, fromAbove());
    const std::string area =
        areaOf(images.arriving,
               cellsWhere(images.arriving, [](const SeenCell& cell) { return cell.what == Shown::Stock; }));
    EXPECT_EQ(std::count(area.begin(), area.end(), 'M'), 1) << area;
    EXPECT_LE(std::count(area.begin(), area.end(), 'L'), 10) << area;
}

TEST(TracedLines, DashTheBorderOfWhatIsCutInAPlainFace) {
    const Sight sight = fromAbove();
    const StockImages images =
        stockImages(blockWith(BodyKind::CutHere, block({10, 5}, {20, 15}, -4, 0)), sight);
    EXPECT_FALSE(strokesOf(images.arriving, sight.cell_mm()).cuts.empty());
    EXPECT_TRUE(strokesOf(images.arriving, sight.cell_mm()).fixtures.empty());
}

}  // namespace
}  // namespace stepmill::report
