#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "stepmill/access/collision.h"
#include "stepmill/core/units.h"
#include "support/grounds.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::closedPocket;
using test::endMill;
using test::inHolder;
using test::kMaterial;
using test::makeFeature;

using test::kTol;

/// Areas are exact but for joints on the 1 nm grid and walls shared to 0.1 um.
constexpr double kAreaMm2 = 2e-2;

Region rect(double x0, double y0, double x1, double y1) {
    return makeRectangle({x0, y0}, {x1, y1});
}

Region islandPocket() {
    return subtract(makeRoundedRectangle({0, 0}, {70, 50}, 6), makeCircle({35, 25}, 8), kTol);
}

ToolReach access(const FeatureGround& ground, const ToolAssembly& tool) {
    return toolReach(ground, tool, kMaterial);
}

/// A cutter wider than a corner leaves what a square corner of both leaves: (1 - pi/4)(r^2 - corner^2).
double leftInCorner(double radius_mm, double corner_mm) {
    return (1 - kPi / 4) * (radius_mm * radius_mm - corner_mm * corner_mm);
}

TEST(ToolReach, OfThePocketWithAnIslandLeavesTheCorners) {
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    const double whole = area(ground.feature().target);
    for (const double radius : {2.0, 4.0, 5.9, 6.0, 6.5, 7.0, 8.0}) {
        const ToolReach found = access(ground, endMill(2 * radius));
        const double left = radius > 6 ? 4 * leftInCorner(radius, 6) : 0;
        EXPECT_FALSE(found.exclusion()) << radius;
        EXPECT_NEAR(found.cutter.coverable_area_mm2, whole - left, kAreaMm2) << radius;
        EXPECT_NEAR(area(found.cutter.coverable), found.cutter.coverable_area_mm2, 1e-9);
        EXPECT_DOUBLE_EQ(found.collision_free_area_mm2, found.cutter.coverable_area_mm2);
        EXPECT_NEAR(found.cutter.access_volume_mm3, 10 * found.cutter.coverable_area_mm2, 1e-6);
    }
}

TEST(ToolReach, OfACutterAsWideAsTheCornersIsTheWholePocket) {
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    const ToolReach found = access(ground, endMill(12));
    EXPECT_NEAR(found.cutter.coverable_area_mm2, area(ground.feature().target), 1e-3);
}

TEST(ToolReach, SplitsWhereTheIslandLeavesTooNarrowAPassage) {
    // The passages above and below the island are 17 mm wide, those beside it 27 mm.
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    EXPECT_EQ(access(ground, endMill(16.9)).cutter.entries.size(), 1U);
    const ToolReach wider = access(ground, endMill(17.1));
    EXPECT_EQ(wider.cutter.entries.size(), 2U);
    EXPECT_EQ(components(wider.cutter.free_centres).size(), 2U);
}

TEST(ToolReach, IsEmptyWhenToolIsWiderThanSlot) {
    const FeatureGround ground(closedPocket(makeRoundedRectangle({0, 0}, {60, 10}, 2)), kTol);
    const ToolReach found = access(ground, endMill(10.5));
    ASSERT_TRUE(found.exclusion());
    EXPECT_EQ(found.exclusion()->reason, ExclusionReason::TooWide);
    EXPECT_NE(found.exclusion()->text.find("10 mm"), std::string::npos) << found.exclusion()->text;
    EXPECT_TRUE(found.cutter.accessible.empty());
    EXPECT_DOUBLE_EQ(found.cutter.coverable_area_mm2, 0);
    EXPECT_NEAR(ground.widestCutterMm(), 10, 1e-3);
}

TEST(ToolReach, IsTheMiddleOfASlotExactlyAsWideAsTheTool) {
    const Feature slot = closedPocket(makeRoundedRectangle({0, 0}, {60, 10}, 2));
    const ToolReach found = access(FeatureGround(slot, kTol), endMill(10));
    ASSERT_FALSE(found.exclusion());
    EXPECT_EQ(found.cutter.slot_middles.size(), 1U);
    Tolerances no_fit = kTol;
    no_fit.fit_mm = 0;
    const ToolReach none = access(FeatureGround(slot, no_fit), endMill(10));
    ASSERT_TRUE(none.exclusion());
    EXPECT_EQ(none.exclusion()->reason, ExclusionReason::TooWide);
}

/// A channel as wide as a cutter of 6 mm, round at both ends.
Region channel(double x0, double y0, double x1, double y1) {
    return makeRoundedRectangle({x0 - 3, y0 - 3}, {x1 + 3, y1 + 3}, 3);
}

TEST(ToolReach, OfChannelsThatCrossGoesStraightAlongEach) {
    const Region cross = unite(
        std::vector<Region>{channel(0, 20, 60, 20), channel(20, 0, 20, 40), channel(40, 0, 40, 40)}, kTol);
    const ToolReach found = access(FeatureGround(closedPocket(cross), kTol), endMill(6));
    EXPECT_EQ(components(found.cutter.free_centres).size(), 1U);
    ASSERT_EQ(found.cutter.slot_middles.size(), 3U);
    double length_mm = 0;
    for (const Path& middle : found.cutter.slot_middles)
        length_mm += length(middle);
    EXPECT_NEAR(length_mm, 60 + 2 * 40, 0.05);
    EXPECT_NEAR(found.cutter.coverable_area_mm2, area(cross), kAreaMm2);
}

TEST(ToolReach, OfAChannelThatEndsInAnotherMeetsItsMiddle) {
    const Region tee = unite(channel(0, 0, 60, 0), channel(30, 0, 30, 40), kTol);
    const ToolReach found = access(FeatureGround(closedPocket(tee), kTol), endMill(6));
    EXPECT_EQ(components(found.cutter.free_centres).size(), 1U);
    ASSERT_EQ(found.cutter.slot_middles.size(), 2U);
    EXPECT_NEAR(length(found.cutter.slot_middles[0]) + length(found.cutter.slot_middles[1]), 60 + 40, 0.05);
}

TEST(ToolReach, OfARoundChannelThatOthersCrossGoesAllRound) {
    const Region ring = subtract(makeCircle({0, 0}, 43), makeCircle({0, 0}, 37), kTol);
    const Region crossed = unite(
        std::vector<Region>{ring, channel(20, 0, 60, 0), channel(-60, 0, -20, 0), channel(0, 20, 0, 60)},
        kTol);
    const ToolReach found = access(FeatureGround(closedPocket(crossed), kTol), endMill(6));
    const std::vector<Path>& middles = found.cutter.slot_middles;
    ASSERT_EQ(middles.size(), 4U);
    const auto round = std::find_if(middles.begin(), middles.end(), [](const Path& m) { return m.closed(); });
    ASSERT_NE(round, middles.end());
    EXPECT_NEAR(length(*round), 2 * kPi * 40, 0.05);
    EXPECT_NEAR(found.cutter.coverable_area_mm2, area(crossed), kAreaMm2);
}

TEST(ToolReach, CoversAShoulderNarrowerThanTheCutterFromOutside) {
    const Feature shoulder = makeFeature(rect(0, 0, 50, 4), rect(0, 4, 50, 30), 58);
    const FeatureGround ground(shoulder, kTol);
    for (const double diameter : {6.0, 10.0, 25.0}) {
        const ToolReach found = access(ground, endMill(diameter));
        EXPECT_FALSE(found.exclusion()) << diameter;
        EXPECT_NEAR(found.cutter.coverable_area_mm2, 200, kAreaMm2) << diameter;
        ASSERT_EQ(found.cutter.entries.size(), 1U);
        EXPECT_EQ(found.cutter.entries[0].kind, EntryKind::OpenEdge);
    }
}

TEST(ToolReach, OfASlotNarrowerThanTheCutterIsOnlyTheMouthItDipsInto) {
    // A disc of radius R over a mouth 2a wide, at rest on its two edges, cuts a segment of the circle.
    const Region slot = rect(-5, 0, 5, 40);
    const Region block = subtract(rect(-40, 0, 40, 60), slot, kTol);
    const FeatureGround ground(makeFeature(slot, block, 10), kTol);
    const ToolReach found = access(ground, endMill(16));
    const double half_angle = std::asin(5.0 / 8.0);
    const double segment = 64 * (half_angle - std::sin(half_angle) * std::cos(half_angle));
    EXPECT_NEAR(found.cutter.coverable_area_mm2, segment, kAreaMm2);
    EXPECT_NEAR(ground.widestCutterMm(), 10, 0.05);
}

TEST(ToolReach, OfAFaceIsAllOfItForEveryCutter) {
    const Feature face = makeFeature(rect(0, 0, 100, 80), {}, 360, 2);
    const FeatureGround ground(face, kTol);
    const ToolReach found = access(ground, endMill(50));
    EXPECT_NEAR(found.cutter.coverable_area_mm2, 8000, kAreaMm2);
    EXPECT_EQ(found.cutter.entries.at(0).kind, EntryKind::OpenEdge);
    EXPECT_TRUE(std::isinf(ground.widestCutterMm()));
}

TEST(ToolReach, OverOpenEdgesNeverTouchesTheObstruction) {
    const Region slot = rect(-10, 0, 10, 40);
    const Region block = subtract(rect(-40, 0, 40, 60), slot, kTol);
    const FeatureGround ground(makeFeature(slot, block, 20), kTol);
    const ToolReach found = access(ground, endMill(8));
    EXPECT_LT(area(intersect(found.cutter.accessible, block, kTol)), 1e-2);
    EXPECT_NEAR(found.cutter.coverable_area_mm2, 800 - 2 * leftInCorner(4, 0), kAreaMm2);
}

TEST(Entry, OverAnOpenEdgeStandsClearOfTargetAndObstruction) {
    const Region slot = rect(-10, 0, 10, 40);
    const Region block = subtract(rect(-40, 0, 40, 60), slot, kTol);
    const FeatureGround ground(makeFeature(slot, block, 20), kTol);
    const ToolReach found = access(ground, endMill(8));
    ASSERT_EQ(found.cutter.entries.size(), 1U);
    ASSERT_EQ(found.cutter.entries[0].kind, EntryKind::OpenEdge);
    const Vec2 at = found.cutter.entries[0].at;
    EXPECT_LT(at.y(), 0);
    EXPECT_GE(distanceToBoundary(slot, at), 4);
    EXPECT_GE(distanceToBoundary(block, at), 4);
    EXPECT_LE(distanceToBoundary(found.cutter.free_centres, at), 1 + 1e-6);
}

TEST(Entry, IsAHelixWhereThereIsRoomForOne) {
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    ToolAssembly tool = endMill(10);
    tool.centre_cutting = false;
    const ToolReach found = access(ground, tool);
    ASSERT_EQ(found.cutter.entries.size(), 1U);
    EXPECT_EQ(found.cutter.entries[0].kind, EntryKind::Helix);
    EXPECT_NEAR(found.cutter.entries[0].helix_radius_mm, 4.5, 1e-9);
    const double clear_mm = distanceToBoundary(ground.feature().target, found.cutter.entries[0].at);
    EXPECT_GE(clear_mm + 1e-6, 5 + found.cutter.entries[0].helix_radius_mm);
}

TEST(Entry, InAHoleIsAHelixAboutItsAxis) {
    const FeatureGround ground(closedPocket(makeCircle({3, 4}, 8)), kTol);
    const ToolReach found = access(ground, endMill(10));
    ASSERT_EQ(found.cutter.entries.size(), 1U);
    EXPECT_EQ(found.cutter.entries[0].kind, EntryKind::Helix);
    EXPECT_NEAR((found.cutter.entries[0].at - Vec2(3, 4)).norm(), 0, 5e-3);
    EXPECT_NEAR(found.cutter.entries[0].helix_radius_mm, 3, 5e-3);
}

TEST(Entry, IsARampInASlotTooNarrowForAHelix) {
    const FeatureGround ground(closedPocket(makeRoundedRectangle({0, 0}, {60, 11}, 5.5)), kTol);
    ToolAssembly tool = endMill(10);
    tool.centre_cutting = false;
    const ToolReach found = access(ground, tool);
    ASSERT_EQ(found.cutter.entries.size(), 1U);
    ASSERT_EQ(found.cutter.entries[0].kind, EntryKind::Ramp);
    const Entry& ramp = found.cutter.entries[0];
    EXPECT_NEAR((ramp.ramp_to - ramp.at).norm(), 50, 1);
    for (const Vec2& end : {ramp.at, ramp.ramp_to})
        EXPECT_TRUE(contains(found.cutter.free_centres, end));
}

TEST(Entry, InATightHoleIsAPlungeWhereTheToolMayPlunge) {
    const FeatureGround ground(closedPocket(makeCircle({0, 0}, 5.2)), kTol);
    ToolAssembly plunger = endMill(10);
    plunger.max_plunge_mm = 1;
    EXPECT_EQ(access(ground, plunger).cutter.entries.at(0).kind, EntryKind::Plunge);
    const ToolReach found = access(ground, endMill(10));
    ASSERT_TRUE(found.exclusion());
    EXPECT_EQ(found.exclusion()->reason, ExclusionReason::NoEntry);
}

TEST(Entry, OfAToolWithEdgesAtItsCentreMayBeANarrowHelix) {
    const FeatureGround ground(closedPocket(makeCircle({0, 0}, 5.6)), kTol);
    const ToolReach centre_cutting = access(ground, endMill(10));
    ASSERT_EQ(centre_cutting.cutter.entries.at(0).kind, EntryKind::Helix);
    EXPECT_NEAR(centre_cutting.cutter.entries.at(0).helix_radius_mm, 0.6, 5e-3);
    ToolAssembly dead_centre = endMill(10);
    dead_centre.centre_cutting = false;
    const ToolReach found = access(ground, dead_centre);
    ASSERT_TRUE(found.exclusion());
    EXPECT_EQ(found.exclusion()->reason, ExclusionReason::NoEntry);
    EXPECT_TRUE(found.cutter.free_centres.empty());
}

TEST(Entry, DropsOnlyTheComponentThatCannotBeEntered) {
    // Two chambers with a neck between: a dead-centre cutter gets into the wide one alone.
    const Region chambers =
        unite(unite(makeCircle({0, 0}, 20), makeCircle({40, 0}, 5.5), kTol), rect(0, -3, 40, 3), kTol);
    const FeatureGround ground(closedPocket(chambers), kTol);
    ToolAssembly dead_centre = endMill(10);
    dead_centre.centre_cutting = false;
    const ToolReach found = access(ground, dead_centre);
    EXPECT_FALSE(found.exclusion());
    ASSERT_EQ(found.cutter.entries.size(), 1U);
    EXPECT_EQ(access(ground, endMill(10)).cutter.entries.size(), 2U);
    EXPECT_NEAR(access(ground, endMill(10)).cutter.coverable_area_mm2 - found.cutter.coverable_area_mm2,
                kPi * 5.5 * 5.5, 1.0);
}

TEST(Exclusion, RulesOutBallsOnFlatFloorsAndToolsWithoutData) {
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    ToolAssembly ball = endMill(6);
    ball.type = ToolType::Ball;
    ball.corner_radius_mm = 3;
    EXPECT_EQ(access(ground, ball).exclusion()->reason, ExclusionReason::WrongType);
    const ToolReach no_data = toolReach(ground, endMill(6), "unobtainium");
    EXPECT_EQ(no_data.exclusion()->reason, ExclusionReason::NoCuttingData);
    EXPECT_GT(no_data.cutter.coverable_area_mm2, 0);
}

TEST(Exclusion, RulesOutDrillsButInThroughHolesOfTheirSize) {
    Feature hole = closedPocket(makeCircle({0, 0}, 4));
    hole.obstacles.clear();
    ToolAssembly drill = endMill(8);
    drill.type = ToolType::Drill;
    hole.feature_class = FeatureClass::HoleThrough;
    const ToolReach fits = access(FeatureGround(hole, kTol), drill);
    EXPECT_FALSE(fits.exclusion());
    EXPECT_DOUBLE_EQ(fits.cutter.coverable_area_mm2, 0);
    drill.diameter_mm = 8.1;
    EXPECT_EQ(access(FeatureGround(hole, kTol), drill).exclusion()->reason, ExclusionReason::WrongType);
    drill.diameter_mm = 8;
    hole.feature_class = FeatureClass::HoleBlind;
    EXPECT_EQ(access(FeatureGround(hole, kTol), drill).exclusion()->reason, ExclusionReason::WrongType);
    hole.feature_class = FeatureClass::HoleThrough;
    drill.flute_length_mm = 9;
    EXPECT_EQ(access(FeatureGround(hole, kTol), drill).exclusion()->reason, ExclusionReason::TooShort);
}

ToolAssembly withHolder(ToolAssembly tool, double diameter_mm, double bottom_mm) {
    tool.flute_length_mm = bottom_mm;
    return inHolder(tool, bottom_mm, diameter_mm, 50);
}

TEST(HolderCollision, DoesNotMatterWhereTheHolderStaysOverTheMaterial) {
    const FeatureGround ground(closedPocket(islandPocket(), 30), kTol);
    EXPECT_FALSE(access(ground, withHolder(endMill(8), 40, 30)).exclusion());
}

TEST(HolderCollision, LeavesWhatTheHolderCanReach) {
    // An open room 100 x 100: the holder of radius 15 keeps off the walls, the cutter of radius 5 reaches on.
    const FeatureGround ground(closedPocket(makeRoundedRectangle({0, 0}, {100, 100}, 5), 30), kTol);
    const ToolReach found = access(ground, withHolder(endMill(10), 30, 25));
    ASSERT_TRUE(found.exclusion());
    EXPECT_EQ(found.exclusion()->reason, ExclusionReason::HolderCollision);
    EXPECT_NEAR(found.collision_free_area_mm2, 80 * 80 - 4 * leftInCorner(5, 0), kAreaMm2);
    EXPECT_NEAR(found.cutter.coverable_area_mm2, 100 * 100 - 4 * leftInCorner(5, 0), kAreaMm2);
}

TEST(HolderCollision, LeavesAnAreaThatTheToolMayBeLimitedTo) {
    const FeatureGround ground(closedPocket(makeRoundedRectangle({0, 0}, {100, 100}, 5), 30), kTol);
    const ToolAssembly tool = withHolder(endMill(10), 30, 25);
    const ToolReach held_off = access(ground, tool);
    const auto clear = collisionFreeArea(ground, tool, held_off);
    ASSERT_TRUE(clear);
    const ToolReach limited = limitedTo(held_off, *clear);
    ASSERT_TRUE(limited.limited());
    EXPECT_EQ(limited.limited()->why, held_off.exclusion()->text);
    EXPECT_EQ(&limited.own(), &limited.cleared()) << "nobody does the rest";
    EXPECT_NEAR(limited.own().coverable_area_mm2, 80 * 80 - 4 * leftInCorner(5, 0), kAreaMm2);
    EXPECT_EQ(limited.cutter.coverable_area_mm2, held_off.cutter.coverable_area_mm2);
}

TEST(SureSweep, LeavesOutWhatOnlyAStripThinnerThanASliverWouldSweep) {
    const Region strip = rect(0, 0, 30, kTol.sliver_mm / 2);
    EXPECT_TRUE(SureSweep(strip, 5, {}, kTol).region().empty());
    const SureSweep wide(rect(0, 0, 30, 1), 5, {}, kTol);
    EXPECT_NEAR(area(wide.region()), area(offset(rect(0, 0, 30, 1), 5, kTol)), 1e-2);
    EXPECT_NEAR(area(wide.shrunk(5)), 30, 1e-2);
    EXPECT_TRUE(SureSweep().region().empty());
    EXPECT_TRUE(SureSweep().shrunk(1).empty());
}

TEST(HolderCollision, IsCalledTooShortWhereTheHolderFitsNowhere) {
    const FeatureGround ground(closedPocket(makeRoundedRectangle({0, 0}, {40, 30}, 5), 45), kTol);
    const ToolReach found = access(ground, withHolder(endMill(10), 40, 30));
    ASSERT_TRUE(found.exclusion());
    EXPECT_EQ(found.exclusion()->reason, ExclusionReason::TooShort);
    EXPECT_EQ(found.exclusion()->text, "reaches 30 mm, the floor is 45 mm deep");
    EXPECT_DOUBLE_EQ(found.collision_free_area_mm2, 0);
}

TEST(HolderCollision, CountsAShankWiderThanTheCutter) {
    const FeatureGround ground(closedPocket(makeRoundedRectangle({0, 0}, {40, 30}, 5), 30), kTol);
    ToolAssembly tool = endMill(4);
    tool.flute_length_mm = 12;
    tool.shank = {6, 12, 60};
    EXPECT_EQ(access(ground, tool).exclusion()->reason, ExclusionReason::HolderCollision);
    tool.shank.diameter_mm = 4;
    EXPECT_FALSE(access(ground, tool).exclusion());
}

TEST(HolderCollision, CountsInASlotOfTheCuttersOwnWidth) {
    // The centres are a strip of 1 um: too little to be worth a pass by itself, but all there is.
    ToolAssembly tool = endMill(4);
    tool.max_plunge_mm = 2;
    tool.shank = {6, 12, 60};
    for (const Region& target : {rect(0, 0, 30, 4.001), makeCircle({0, 0}, 2.0005)}) {
        const ToolReach found = access(FeatureGround(closedPocket(target, 20), kTol), tool);
        ASSERT_FALSE(found.cutter.free_centres.empty());
        ASSERT_TRUE(found.exclusion());
        EXPECT_EQ(found.exclusion()->reason, ExclusionReason::HolderCollision);
    }
}

TEST(HolderCollision, CountsWhereHeightsMissEachOtherByRounding) {
    Feature pocket = closedPocket(makeRoundedRectangle({0, 0}, {40, 30}, 5), 30);
    pocket.obstacles = {{-30, -10, pocket.obstruction}, {-10 + 1e-9, 0, pocket.obstruction}};
    const FeatureGround ground(pocket, kTol);
    EXPECT_TRUE(access(ground, withHolder(endMill(10), 30, 20)).exclusion());
}

TEST(OwnMaterial, MeetsTheHolderOnlyBelowTheTopAndWhereSomethingIsLeft) {
    const auto trouble = [](const Region& target, double depth_mm, double holder_from_mm) {
        Feature pocket = closedPocket(target, depth_mm);
        pocket.obstacles.clear();  // walls that the holder would meet are another matter
        const FeatureGround ground(pocket, kTol);
        const ToolAssembly tool = withHolder(endMill(10), 30, holder_from_mm);
        return access::ownMaterialTrouble(ground, tool, access(ground, tool));
    };
    const Region sharp = rect(0, 0, 60, 40);
    const Region round = makeRoundedRectangle({0, 0}, {60, 40}, 5);
    ASSERT_TRUE(trouble(sharp, 30, 25)) << "corners stand in the holder's way";
    EXPECT_EQ(trouble(sharp, 30, 25)->reason, ExclusionReason::TooShort);
    EXPECT_FALSE(trouble(sharp, 30, 30)) << "the holder stays above";
    EXPECT_FALSE(trouble(round, 30, 25)) << "nothing is left";
}

TEST(HolderCollision, SeesMaterialThatWidensUpwards) {
    // Over the pocket's floor a bridge stands 20 mm up, well clear of the cutter's own flutes.
    Feature pocket = closedPocket(makeRoundedRectangle({0, 0}, {60, 60}, 6), 40);
    const Region bridge = unite(pocket.obstruction, rect(-20, 25, 80, 35), kTol);
    pocket.obstacles = {{-40, -20, pocket.obstruction}, {-20, 0, bridge}};
    const FeatureGround ground(pocket, kTol);
    EXPECT_EQ(access(ground, withHolder(endMill(12), 13, 30)).exclusion()->reason,
              ExclusionReason::HolderCollision);
}

TEST(Names, OfReasonsAndEntriesAreForPeople) {
    EXPECT_EQ(toString(ExclusionReason::HolderCollision), "holder collision");
    EXPECT_EQ(toString(EntryKind::OpenEdge), "open edge");
}

}  // namespace
}  // namespace stepmill
