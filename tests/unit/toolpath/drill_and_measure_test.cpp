// Drilling, totals, proofs of paths made by hand.

#include <gtest/gtest.h>

#include "stepmill/core/units.h"
#include "support/clearing_tasks.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using namespace test;

using test::kMachine;
using test::kTol;

ToolAssembly drill(double diameter_mm) {
    ToolAssembly tool = flatEndMill(diameter_mm);
    tool.type = ToolType::Drill;
    return tool;
}

TEST(DrillHole, PecksDownAndOut) {
    CuttingData cutting = cuttingData(0, 5);
    const Toolpath path = drillHole({3, 4}, 0, -12, 10, drill(2), cutting, kMachine);
    EXPECT_EQ(path.depths, 3);
    double lowest_rapid = 10;
    double deepest = 0;
    double drilled = 0;
    double z = path.start.z();
    for (const Move& move : path.moves) {
        EXPECT_EQ(move.to.x(), 3);
        EXPECT_EQ(move.to.y(), 4);
        if (move.kind == MoveKind::Rapid) {
            EXPECT_GE(move.to.z(), drilled + 0.5 - 1e-12);
            lowest_rapid = std::min(lowest_rapid, move.to.z());
        } else {
            EXPECT_LE(z - move.to.z(), 5);
            drilled = move.to.z();
        }
        deepest = std::min(deepest, move.to.z());
        z = move.to.z();
    }
    EXPECT_EQ(deepest, -12);
    EXPECT_EQ(z, 10);
    EXPECT_NEAR(lowest_rapid, -7.5, 1e-12);
    EXPECT_NEAR(path.totals.cut_length_mm, 5 + 4.5 + 4.5, 1e-12);
}

TEST(DrillHole, BreaksTheChipsOfAHoleOfFourDiameters) {
    const Toolpath path = drillHole({3, 4}, 0, -12, 10, drill(3), cuttingData(0, 5), kMachine);
    EXPECT_EQ(path.depths, 3);
    EXPECT_EQ(path.pattern, kChipBreakPattern);
    double z = path.start.z();
    int lifts = 0;
    for (const Move& move : path.moves) {
        if (z < 0 && move.to.z() > z && move.to.z() < 0) {
            EXPECT_NEAR(move.to.z() - z, kChipBreakLiftMm, 1e-12);
            EXPECT_EQ(move.kind, MoveKind::Rapid);
            ++lifts;
        }
        z = move.to.z();
    }
    EXPECT_EQ(lifts, 2);
    EXPECT_NEAR(path.totals.cut_length_mm, 13 + 2 * kChipBreakLiftMm, 1e-12);
}

TEST(SizeHoles, FeedDownAndUp) {
    ToolAssembly reamer = flatEndMill(8);
    reamer.type = ToolType::Reamer;
    const Toolpath path = sizeHoles({{0, 0}, {10, 0}}, 0, -12, 10, reamer, cuttingData(0, 0), kMachine);
    EXPECT_EQ(path.pattern, "ream");
    double z = path.start.z();
    double fed_mm = 0;
    for (const Move& move : path.moves) {
        if (move.kind == MoveKind::Rapid) {
            EXPECT_GE(std::min(z, move.to.z()), 0) << "no rapid in the bore";
        } else {
            fed_mm += std::abs(move.to.z() - z);
        }
        z = move.to.z();
    }
    EXPECT_NEAR(fed_mm, 4 * 13, 1e-12);
    EXPECT_EQ(z, 10);
}

TEST(DrillHole, PecksTwoDiametersWithoutAStepDown) {
    const Toolpath path = drillHole({0, 0}, 0, -30, 10, drill(5), cuttingData(0, 0), kMachine);
    EXPECT_EQ(path.depths, 3);
}

TEST(DrillHole, TakesAHoleOfThreeDiametersInOneGo) {
    EXPECT_EQ(drillHole({0, 0}, 0, -18, 10, drill(6), cuttingData(0, 5), kMachine).depths, 1);
    EXPECT_EQ(drillHole({0, 0}, 0, -18.1, 10, drill(6), cuttingData(0, 5), kMachine).depths, 4);
}

TEST(DrillHoles, MakesEveryHoleFromTheRetractHeight) {
    const std::vector<Vec2> centres{{0, 0}, {10, 0}, {10, 5}};
    const Toolpath path = drillHoles(centres, 0, -12, 10, drill(6), cuttingData(0, 6), kMachine);
    std::vector<Vec2> drilled;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const bool across = Vec2(move.to.head<2>()) != Vec2(from.head<2>());
        if (across) {
            EXPECT_EQ(std::min(from.z(), move.to.z()), 10);
        }
        if (move.kind == MoveKind::Plunge && move.to.z() == -12) drilled.push_back(move.to.head<2>());
        from = move.to;
    }
    EXPECT_EQ(drilled, centres);
    EXPECT_EQ(from.z(), 10);
}

double wayMm(const std::vector<Vec2>& places) {
    double sum_mm = 0;
    for (std::size_t i = 1; i < places.size(); ++i)
        sum_mm += (places[i] - places[i - 1]).norm();
    return sum_mm;
}

TEST(ShortestTour, GoesRoundABoltCircle) {
    std::vector<Vec2> places;
    for (int i = 0; i < 12; ++i) {
        const double angle_rad = 2 * kPi * (i * 5 % 12) / 12;
        places.emplace_back(20 * std::cos(angle_rad), 20 * std::sin(angle_rad));
    }
    EXPECT_NEAR(wayMm(shortestTour(places)), 11 * 2 * 20 * std::sin(kPi / 12), 1e-9);
}

TEST(ShortestTour, KeepsEveryPlaceAndLosesNothingToTheOrderGiven) {
    std::vector<Vec2> places;
    for (int i = 0; i < 30; ++i)
        places.emplace_back(i * 37 % 101, i * 53 % 97);
    const std::vector<Vec2> tour = shortestTour(places);
    EXPECT_LT(wayMm(tour), wayMm(places) / 2);
    EXPECT_TRUE(std::is_permutation(tour.begin(), tour.end(), places.begin()));
}

TEST(Measure, AddsHelicesAndFeedsByKind) {
    Toolpath path;
    path.start = {10, 0, 5};
    path.feed_mm_per_min = 600;
    path.plunge_feed_mm_per_min = 120;
    const Arc arc{{0, 0}, 10, true};
    path.moves = {{MoveKind::Rapid, {10, 0, 0}, std::nullopt, false},
                  {MoveKind::Plunge, {-10, 0, -3}, arc, false},
                  {MoveKind::Feed, {10, 0, -3}, std::nullopt, true}};
    const PathTotals totals = measure(path, kMachine);
    const double helix = std::hypot(10 * kPi, 3);
    EXPECT_NEAR(totals.cut_length_mm, helix + 20, 1e-12);
    EXPECT_NEAR(totals.feed_air_length_mm, 20, 1e-12);
    EXPECT_NEAR(totals.air_length_mm, 5, 1e-12);
    EXPECT_NEAR(totals.feed_time_s, helix / 2 + 2, 1e-12);
    EXPECT_NEAR(totals.rapid_time_s, 0.06, 1e-12);
    EXPECT_NEAR(totals.time_s(), totals.feed_time_s + totals.rapid_time_s, 1e-12);
}

TEST(Measure, FeedsRampsAtTheirOwnFeed) {
    Toolpath path;
    path.start = {0, 0, 0};
    path.feed_mm_per_min = 600;
    path.plunge_feed_mm_per_min = 120;
    path.ramp_feed_mm_per_min = 400;
    path.moves = {{MoveKind::Ramp, {30, 0, -4}, std::nullopt, false},
                  {MoveKind::Plunge, {30, 0, -6}, std::nullopt, false}};
    EXPECT_NEAR(measure(path, kMachine).feed_time_s, std::hypot(30, 4) * 60 / 400 + 1, 1e-12);
}

TEST(RampFeed, IsTheCuttingFeedOnShallowRamps) {
    EXPECT_EQ(rampFeed(1000, 300, degToRad(3)), 1000);
}

TEST(RampFeed, SinksNoFasterThanThePlungeFeed) {
    const double feed = rampFeed(1000, 100, degToRad(30));
    EXPECT_NEAR(feed * std::sin(degToRad(30)), 100, 1e-9);
    EXPECT_NEAR(rampFeed(1000, 300, kPi / 2), 300, 1e-9);
}

TEST(Measure, MatchesTheTotalsOfAMadePath) {
    const Region pocket = makeRoundedRectangle({0, 0}, {50, 40}, 6);
    const ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 5, kTol);
    const Toolpath path = clearArea(task, flatEndMill(10), cuttingData(4, 2), kMachine, kTol);
    const PathTotals totals = measure(path, kMachine);
    EXPECT_EQ(totals.cut_length_mm, path.totals.cut_length_mm);
    EXPECT_EQ(totals.rapid_time_s, path.totals.rapid_time_s);
}

class ProofByHand : public testing::Test {
  protected:
    ProofByHand() {
        const Region pocket = makeRectangle({0, 0}, {40, 40});
        task_ = fullTask(pocket, blockAround(pocket, {}, kTol), 5, kTol);
        path_.start = {20, 20, 5};
        add(MoveKind::Plunge, {20, 20, -6});
    }
    void add(MoveKind kind, const Vec3& to, std::optional<Arc> arc = std::nullopt) {
        path_.moves.push_back({kind, to, arc, false});
    }
    PathProof proof() const { return prove(path_, task_, 5, kTol); }

    ClearingTask task_;
    Toolpath path_;
};

TEST_F(ProofByHand, MeasuresTheClearanceOfLines) {
    add(MoveKind::Feed, {34.75, 20, -6});
    EXPECT_NEAR(proof().least_clearance_mm, 0.25, 1e-9);
}

TEST_F(ProofByHand, FindsAGouge) {
    add(MoveKind::Feed, {35.01, 20, -6});
    EXPECT_NEAR(proof().least_clearance_mm, -0.01, 1e-9);
}

TEST_F(ProofByHand, FindsTheBulgeOfAnArc) {
    // Ends are clear, the middle of the arc comes to x = 36.
    add(MoveKind::Feed, {26, 10, -6});
    add(MoveKind::Feed, {26, 30, -6}, Arc{{26, 20}, 10, true});
    EXPECT_NEAR(proof().least_clearance_mm, -1, 1e-9);
}

TEST_F(ProofByHand, FindsACutterInsideTheObstruction) {
    path_.moves.clear();
    path_.start = {-8, -8, 5};
    add(MoveKind::Plunge, {-8, -8, -1});
    // The block is 15 mm wide round the pocket: the nearest way out is 7 mm, and the radius on top.
    EXPECT_NEAR(proof().least_clearance_mm, -12, 1e-9);
}

TEST_F(ProofByHand, RefusesARapidThroughMaterial) {
    EXPECT_TRUE(proof().rapids_clear);
    add(MoveKind::Rapid, {20, 20, 5});
    add(MoveKind::Rapid, {10, 20, 5});
    EXPECT_TRUE(proof().rapids_clear);
    add(MoveKind::Rapid, {10, 20, -5});
    EXPECT_FALSE(proof().rapids_clear);
}

TEST_F(ProofByHand, RefusesARapidAcrossAtDepth) {
    add(MoveKind::Rapid, {30, 20, -6});
    EXPECT_FALSE(proof().rapids_clear);
}

TEST_F(ProofByHand, AllowsARapidAcrossWhatFeedsHaveCleared) {
    add(MoveKind::Feed, {30, 20, -6});
    add(MoveKind::Rapid, {30, 20, -5});
    add(MoveKind::Rapid, {22, 20, -5});
    EXPECT_TRUE(proof().rapids_clear);
}

TEST_F(ProofByHand, RefusesARapidAcrossBesideWhatFeedsHaveCleared) {
    add(MoveKind::Feed, {30, 20, -6});
    add(MoveKind::Rapid, {30, 20, -5});
    add(MoveKind::Rapid, {22, 20.5, -5});
    EXPECT_FALSE(proof().rapids_clear);
}

TEST_F(ProofByHand, RefusesARapidAcrossBelowTheFeeds) {
    add(MoveKind::Feed, {30, 20, -5.5});
    add(MoveKind::Rapid, {22, 20, -5.5});
    EXPECT_TRUE(proof().rapids_clear);
    add(MoveKind::Rapid, {22, 20, -5.6});
    EXPECT_FALSE(proof().rapids_clear);
}

TEST_F(ProofByHand, AllowsARapidAcrossOverTheTop) {
    add(MoveKind::Rapid, {20, 20, 1});
    add(MoveKind::Rapid, {10, 30, 1});
    EXPECT_TRUE(proof().rapids_clear);
    EXPECT_GE(proof().least_clearance_mm, 0);
}

TEST_F(ProofByHand, CountsARapidIntoTheObstructionAsAGouge) {
    add(MoveKind::Rapid, {20, 20, 1});
    add(MoveKind::Rapid, {36, 20, 1});
    EXPECT_NEAR(proof().least_clearance_mm, -1, 1e-9);
}

TEST_F(ProofByHand, AllowsARapidDownWhereAFeedHasBeen) {
    add(MoveKind::Feed, {30, 20, -6});
    add(MoveKind::Rapid, {30, 20, 5});
    add(MoveKind::Rapid, {25, 20, 5});
    add(MoveKind::Rapid, {25, 20, -5});
    EXPECT_TRUE(proof().rapids_clear);
}

TEST(TopView, ShowsTheFeedsOfTheDeepestLayerOnly) {
    Toolpath path;
    path.start = {0, 0, 5};
    path.moves = {{MoveKind::Plunge, {0, 0, -1}, std::nullopt, false},
                  {MoveKind::Feed, {10, 0, -1}, std::nullopt, false},
                  {MoveKind::Plunge, {10, 0, -2}, std::nullopt, false},
                  {MoveKind::Feed, {20, 0, -2}, std::nullopt, false},
                  {MoveKind::Feed, {20, 7, -2}, std::nullopt, false},
                  {MoveKind::Rapid, {20, 7, 5}, std::nullopt, false}};
    const std::vector<Path> view = topView(path);
    ASSERT_EQ(view.size(), 1U);
    EXPECT_EQ(view.front().start, Vec2(10, 0));
    EXPECT_EQ(view.front().segments.size(), 2U);
    EXPECT_NEAR(length(view.front()), 17, 1e-12);
}

}  // namespace
}  // namespace stepmill
