// Pieces of stock that nothing holds when a setup is cut.

#include "plan/holding/loose_pieces.h"

#include <gtest/gtest.h>

#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

const Region kBlank = makeRectangle({0, 0}, {80, 50});
const Region kRing = subtract(makeRectangle({20, 15}, {60, 35}), makeRectangle({25, 20}, {55, 30}), kTol);

/// A block of 80 x 50 x 20 mm between jaws at y = 0 and y = 50.
Stage inVise() {
    Stage stage;
    stage.setup.id = "S1";
    stage.layers.layers.resize(1);
    stage.layers.layers[0].bottom_z_mm = -20;
    stage.layers.layers[0].stock = kBlank;
    stage.layers.stock_bottom_z_mm = -20;
    stage.clamping.kind = HoldKind::Vise;
    stage.clamping.fixtures = {{"vise jaw", makeRectangle({-30, -40}, {110, 0}), -50, -10, FixtureKind::Jaw},
                               {"vise jaw", makeRectangle({-30, 50}, {110, 90}), -50, -10, FixtureKind::Jaw}};
    return stage;
}

TEST(LoosePieces, AreNoneWhereAllHangsTogether) {
    EXPECT_TRUE(loosePieces(inVise(), {{kRing, 0, -19.9}}, kTol).empty());
    EXPECT_TRUE(loosePieces(inVise(), {}, kTol).empty());
}

TEST(LoosePieces, AreWhatARingCutsOut) {
    const std::vector<LoosePiece> loose = loosePieces(inVise(), {{kRing, 0, -12}, {kRing, -12, -20}}, kTol);
    ASSERT_EQ(loose.size(), 1U);
    EXPECT_NEAR(loose.front().volume_mm3, 30 * 10 * 20, 1e-6);
    EXPECT_NEAR(loose.front().at.x(), 40, 1e-6);
    const std::vector<Warning> warnings = looseWarnings(loose, "S1");
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings.front().code, "loose");
    EXPECT_EQ(warnings.front().subject, "S1");
}

TEST(LoosePieces, LieOnAPlateUnlessTheyHangOverIt) {
    Stage stage = inVise();
    stage.clamping = {};
    stage.clamping.kind = HoldKind::Plate;
    EXPECT_TRUE(loosePieces(stage, {{kRing, 0, -20}}, kTol).empty());
    const std::vector<LoosePiece> loose =
        loosePieces(stage, {{kRing, 0, -20}, {makeRectangle({25, 20}, {55, 30}), -10, -20}}, kTol);
    ASSERT_EQ(loose.size(), 1U);
    EXPECT_NEAR(loose.front().volume_mm3, 30 * 10 * 10, 1e-6);
}

TEST(LoosePieces, AreUnderNoScrew) {
    Stage stage = inVise();
    stage.clamping.kind = HoldKind::Screws;
    stage.clamping.fixtures = {{"screw M6", makeCircle({40, 25}, 4), 0, 6, FixtureKind::Screw}};
    const std::vector<LoosePiece> loose = loosePieces(stage, {{kRing, 0, -20}}, kTol);
    ASSERT_EQ(loose.size(), 1U);
    EXPECT_NEAR(loose.front().volume_mm3, (80 * 50 - 40 * 20) * 20, 1e-6);
    // Its box' middle lies on the island that the screw holds.
    const Region outside = subtract(kBlank, makeRectangle({20, 15}, {60, 35}), kTol);
    EXPECT_TRUE(contains(outside, loose.front().at.head<2>()));
}

TEST(LoosePieces, AreNotWhatHungLooseBefore) {
    // Seen aslant the stock is slices, and one too wide may stand apart from it.
    Stage stage = inVise();
    stage.layers.layers[0].stock = unite(kBlank, makeRectangle({100, 20}, {110, 30}), kTol);
    EXPECT_TRUE(loosePieces(stage, {{makeRectangle({100, 20}, {110, 30}), 0, -5}}, kTol).empty());
    EXPECT_EQ(loosePieces(stage, {{kRing, 0, -20}}, kTol).size(), 1U);
}

TEST(LoosePieces, AreToldOneByOneWhereTheyAreFew) {
    const std::vector<LoosePiece> few(3, {100, Vec3::Zero()});
    EXPECT_EQ(looseWarnings(few, "S1").size(), 3U);
    const std::vector<Warning> warnings =
        looseWarnings(std::vector<LoosePiece>(9, {100, Vec3::Zero()}), "S1");
    ASSERT_EQ(warnings.size(), 4U);
    EXPECT_EQ(warnings.back().text, "6 more pieces fall loose, 600 mm3 in all");
}

}  // namespace
}  // namespace stepmill
