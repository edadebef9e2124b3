#include <gtest/gtest.h>

#include "support/clearing_tasks.h"

namespace stepmill {
namespace {

using namespace test;

constexpr double kRetractMm = 10;
using test::kMachine;

/// Over a pass, over ground in the feature, and down into it by rapids.
Toolpath hastyPath() {
    Toolpath path;
    path.start = {0, 0, kRetractMm};
    path.feed_mm_per_min = 1000;
    path.plunge_feed_mm_per_min = 200;
    path.moves = {{MoveKind::Rapid, {0, 0, -4}, std::nullopt, false},
                  {MoveKind::Feed, {20, 0, -4}, std::nullopt, false},
                  {MoveKind::Rapid, {20, 0, -2}, std::nullopt, false},
                  {MoveKind::Rapid, {0, 5, -2}, std::nullopt, false},
                  {MoveKind::Rapid, {0, 5, -4}, std::nullopt, false},
                  {MoveKind::Feed, {20, 5, -4}, std::nullopt, false},
                  {MoveKind::Rapid, {20, 5, kRetractMm}, std::nullopt, false}};
    return path;
}

TEST(WithPlainRapids, CrossesAtTheRetractHeightAndFeedsDownFromTheStock) {
    const Toolpath path = withPlainRapids(hastyPath(), 0, kMachine);
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        if (move.kind == MoveKind::Rapid) {
            const bool across = move.to.head<2>() != from.head<2>();
            const bool down = move.to.z() < from.z();
            EXPECT_TRUE(!across || std::min(from.z(), move.to.z()) == kRetractMm);
            EXPECT_TRUE(!down || move.to.z() >= 0.5) << "not fed from just over the stock";
        }
        from = move.to;
    }
    EXPECT_EQ(from, Vec3(20, 5, kRetractMm));
}

TEST(WithPlainRapids, KeepsWhatIsCut) {
    const Toolpath hasty = hastyPath();
    const Toolpath plain = withPlainRapids(hasty, 0, kMachine);
    const auto cutsOf = [](const Toolpath& path) {
        std::vector<Vec3> ends;
        for (const Move& move : path.moves)
            if (move.kind == MoveKind::Feed) ends.push_back(move.to);
        return ends;
    };
    EXPECT_EQ(cutsOf(plain), cutsOf(hasty));
    EXPECT_GT(plain.totals.time_s(), measure(hasty, kMachine).time_s());
}

TEST(WithPlainRapids, LeavesAPlainPathAlone) {
    Toolpath path = hastyPath();
    path.moves = {{MoveKind::Rapid, {0, 0, 2}, std::nullopt, false},
                  {MoveKind::Ramp, {9, 0, -4}, std::nullopt, false},
                  {MoveKind::Rapid, {9, 0, kRetractMm}, std::nullopt, false}};
    EXPECT_EQ(withPlainRapids(path, 0, kMachine).moves.size(), path.moves.size());
}

}  // namespace
}  // namespace stepmill
