#include <gtest/gtest.h>

#include "stepmill/toolpath/cut_feeds.h"
#include "toolpath/engagement/feed_pieces.h"

namespace stepmill {
namespace {

/// A 10 mm cutter rated for 4 x 4 mm at 1000 mm/min, on a spindle that is strong enough.
CuttingModel endMill10() {
    CuttingFacts facts;
    facts.diameter_mm = 10;
    facts.flutes = 3;
    facts.stick_out_mm = 30;
    facts.step_over_mm = 4;
    facts.step_down_mm = 4;
    facts.slot_step_down_mm = 4;
    facts.rated_removal_mm3_per_min = 4 * 4 * 1000;
    facts.feed_mm_per_min = 1000;
    facts.speed_rpm = 9000;
    facts.kc11_n_per_mm2 = 700;
    facts.mc = 0.25;
    facts.spindle_kw = 10;
    return CuttingModel(facts);
}

Toolpath pathOf(const Vec3& start, std::vector<Move> moves) {
    Toolpath path;
    path.start = start;
    path.moves = std::move(moves);
    path.step_down_mm = 4;
    path.feed_mm_per_min = 1000;
    path.plunge_feed_mm_per_min = 300;
    path.ramp_feed_mm_per_min = 1000;
    return path;
}

Move feedTo(double x, double y) {
    return {MoveKind::Feed, Vec3(x, y, -4), std::nullopt, false};
}

TEST(CutFeeds, SlowASlotAndKeepTheStepOver) {
    const CutGround ground(makeRectangle({0, 0}, {100, 60}), 0);
    const FedPath fed = withCutFeeds(
        pathOf({-10, 30, -4}, {feedTo(110, 30), feedTo(110, 34), feedTo(-10, 34)}), ground, endMill10());
    // The slot is parted from the air before and after it.
    Vec3 from = fed.path.start;
    for (const Move& move : fed.path.moves) {
        const double middle = (from.x() + move.to.x()) / 2;
        if (from.y() == 30 && middle > 0 && middle < 100) {
            EXPECT_DOUBLE_EQ(move.feed_mm_per_min, 400);
        }
        if (from.y() == 34 && middle > 5 && middle < 95) {
            EXPECT_DOUBLE_EQ(move.feed_mm_per_min, 1000);
        }
        from = move.to;
    }
    EXPECT_DOUBLE_EQ(fed.path.moves.front().feed_mm_per_min, 1500);
    EXPECT_NEAR(fed.path.moves.front().to.x(), -5, 2.01);
    EXPECT_EQ(from, Vec3(-10, 34, -4));
}

TEST(CutFeeds, TellWhatTheCutsAskFor) {
    const CutGround ground(makeRectangle({0, 0}, {100, 60}), 0);
    const CuttingModel model = endMill10();
    const FedPath fed = withCutFeeds(pathOf({20, 30, -4}, {feedTo(80, 30)}), ground, model);
    EXPECT_NEAR(fed.cuts.peak_kw, model.powerKw(10, 4, 400), 1e-9);
    EXPECT_NEAR(fed.cuts.mean_kw, fed.cuts.peak_kw, 1e-9);
    EXPECT_EQ(fed.cuts.limit, FeedLimit::Rated);
    EXPECT_NEAR(fed.cuts.length_shares[4], 1, 1e-12);
    EXPECT_NEAR(fed.cuts.deflection_mm, model.deflectionMm(10, 4, 400), 1e-12);
}

TEST(CutFeeds, KeepThePlungeFeedAndNoneOfARapid) {
    const CutGround ground(makeRectangle({0, 0}, {100, 60}), 0);
    const FedPath fed = withCutFeeds(pathOf({50, 30, 5}, {{MoveKind::Rapid, Vec3(50, 30, 1), {}, false},
                                                          {MoveKind::Plunge, Vec3(50, 30, -4), {}, false}}),
                                     ground, endMill10());
    EXPECT_EQ(fed.path.feedOf(fed.path.moves[0]), 0);
    EXPECT_EQ(fed.path.feedOf(fed.path.moves[1]), 300);
}

TEST(FeedPieces, PartWhereThatSavesTime) {
    // Ten steps of 10 mm: the slow one at 400 would cost the others 9 s in all.
    std::vector<double> feeds(10, 1000);
    feeds[4] = 400;
    const std::vector<double> ends = toolpath::feedPieces(feeds, 10, 100);
    ASSERT_EQ(ends.size(), 3U);
    EXPECT_DOUBLE_EQ(ends[0], 0.4);
    EXPECT_DOUBLE_EQ(ends[1], 0.5);
    EXPECT_DOUBLE_EQ(ends[2], 1);
}

TEST(FeedPieces, StayOneWhereItSavesNothing) {
    EXPECT_EQ(toolpath::feedPieces({1000, 1000, 1000}, 10, 30), std::vector<double>{1});
    // 1 mm at 400 instead of 1000 mm/min takes 0.09 s longer.
    EXPECT_EQ(toolpath::feedPieces({1000, 400}, 1, 2), std::vector<double>{1});
}

}  // namespace
}  // namespace stepmill
