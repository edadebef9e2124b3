// Ways of form cutters between their passes.

#include <gtest/gtest.h>

#include "stepmill/planar/boolean.h"
#include "stepmill/toolpath/form_passes.h"
#include "support/clearing_tasks.h"
#include "support/tolerances.h"
#include "support/tool_makers.h"
#include "toolpath/emit.h"

namespace stepmill {
namespace {

using test::kMachine;
using test::kTol;

constexpr double kRetractMm = 5;
constexpr double kTipMm = -18;

/// A trough of 100 x 20 mm between walls up to z = 0, with a rib across its middle.
FormGround trough(double rib_top_mm) {
    const Region room = makeRectangle({0, 0}, {100, 20});
    const Region walls = subtract(makeRectangle({-20, -20}, {120, 40}), room, kTol);
    const Region with_rib = unite(walls, makeRectangle({48, 0}, {52, 20}), kTol);
    FormGround ground;
    ground.window = room;
    ground.stairs = {{-20, -10, room}};
    ground.must_stand = {{-20, rib_top_mm, with_rib}, {rib_top_mm, 0, walls}};
    ground.obstacles = ground.must_stand;
    return ground;
}

/// One pass on either side of the rib.
Toolpath passesIn(const FormGround& ground, const ToolAssembly& tool, bool plain_ways = false) {
    toolpath::FormLevel level{kTipMm, {}, {}};
    level.free_centres.loops = {makeRectangle({6, 6}, {42, 14}).loops.front(),
                                makeRectangle({58, 6}, {94, 14}).loops.front()};
    for (const Loop& loop : level.free_centres.loops)
        level.passes.push_back(loop);
    return toolpath::formPath({ground, kRetractMm, plain_ways}, {level}, {}, tool, test::cuttingData(1, 1),
                              kMachine, kTol)
        .path;
}

double crossingZ(const Toolpath& path) {
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        if (move.kind == MoveKind::Rapid && std::abs(move.to.x() - from.x()) > 5) return move.to.z();
        from = move.to;
    }
    ADD_FAILURE() << "no rapid across";
    return 0;
}

ToolAssembly ball(double stick_out_mm, double holder_mm) {
    return test::inHolder(test::ballMill(10), stick_out_mm, holder_mm);
}

TEST(FormPath, CrossesWhatStandsAndNoHigher) {
    EXPECT_DOUBLE_EQ(crossingZ(passesIn(trough(-12), ball(30, 12))), -12 + toolpath::kApproachMm);
    EXPECT_DOUBLE_EQ(crossingZ(passesIn(trough(-12), ball(30, 12), true)), kRetractMm);
}

TEST(FormPath, KeepsTheHolderOffWhatStandsBeside) {
    // Wider than the trough, it stays over the walls' top.
    EXPECT_DOUBLE_EQ(crossingZ(passesIn(trough(-12), ball(30, 40))), -12 + toolpath::kApproachMm);
    EXPECT_DOUBLE_EQ(crossingZ(passesIn(trough(-12), ball(10, 40))), -10 + toolpath::kApproachMm);
}

/// The first pass of a level along the lower wall of the trough, the tool touching it.
Toolpath alongTheWall(const Region& free_centres) {
    toolpath::FormLevel level{kTipMm, free_centres, {}};
    level.passes = {Path{{20, 5.0001}, {{{40, 5.0001}, std::nullopt}}}};
    return toolpath::formPath({trough(-12), kRetractMm, false}, {level}, {}, ball(30, 12),
                              test::cuttingData(1, 1), kMachine, kTol)
        .path;
}

double plungedMm(const Toolpath& path) {
    double sum_mm = 0;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        if (move.kind == MoveKind::Plunge) sum_mm += from.z() - move.to.z();
        from = move.to;
    }
    return sum_mm;
}

TEST(FormPath, ComesDownOffTheWallWhereARapidMay) {
    const Toolpath path = alongTheWall(makeRectangle({5.0001, 5.0001}, {42.9, 14.9}));
    EXPECT_GT(path.start.y(), 6);
    EXPECT_LE(plungedMm(path), toolpath::kApproachMm + 1e-9);
    // Then over to where the pass begins.
    ASSERT_GE(path.moves.size(), 4U);
    EXPECT_EQ(path.moves[2].kind, MoveKind::Feed);
    EXPECT_EQ(path.moves[2].to, Vec3(20, 5.0001, kTipMm));
}

TEST(FormPath, ComesDownAtTheWallWhereThereIsNoRoomBesideIt) {
    const Toolpath path = alongTheWall(makeRectangle({5.0001, 5.0001}, {42.9, 5.4}));
    EXPECT_DOUBLE_EQ(path.start.y(), 5.0001);
    EXPECT_GT(plungedMm(path), -kTipMm - 1e-9);
}

TEST(FormPath, TellsOfWaysAtDepthBetweenPasses) {
    toolpath::FormLevel level{kTipMm, makeRectangle({6, 6}, {42, 14}), {}};
    const Path left{{8, 10}, {{{12, 10}, std::nullopt}}};
    const Path right{{30, 10}, {{{34, 10}, std::nullopt}}};
    level.passes = {left, right};
    const FormGround ground = trough(-12);
    const auto [path, between] = toolpath::formPath({ground, kRetractMm, false}, {level}, {}, ball(30, 12),
                                                    test::cuttingData(1, 1), kMachine, kTol);
    ASSERT_EQ(between.size(), 1U);
    EXPECT_EQ(between[0].tip_z_mm, kTipMm);
    ASSERT_EQ(between[0].ways.size(), 1U);
    EXPECT_EQ(between[0].ways[0].start, Vec2(12, 10));
    EXPECT_EQ(between[0].ways[0].segments.back().to, Vec2(30, 10));
}

}  // namespace
}  // namespace stepmill
