// Laws of clearing on random regions and tools, checked by raster.

#include <gtest/gtest.h>

#include <random>

#include "support/clearing_tasks.h"
#include "support/raster_simulator.h"

namespace stepmill {
namespace {

using namespace test;

const Tolerances kTol;
const Machine kMachine = machineWithRapid(5000);

/// Up to five rounded rectangles and discs joined, with up to two islands taken out.
Region randomTarget(std::mt19937& random) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto shape = [&](double smallest, double largest) {
        const Vec2 at(between(0, 50), between(0, 40));
        if (between(0, 1) < 0.4) return makeCircle(at, between(smallest, largest) / 2);
        const Vec2 size(between(smallest, largest), between(smallest, largest));
        return makeRoundedRectangle(at - size / 2, at + size / 2,
                                    between(0, 1) < 0.5 ? 0 : between(0, 0.5) * size.minCoeff());
    };
    Region target = shape(20, 40);
    const int joined = static_cast<int>(between(0, 5));
    for (int i = 0; i < joined; ++i)
        target = unite(target, shape(10, 35), kTol);
    const int islands = static_cast<int>(between(0, 3));
    for (int i = 0; i < islands; ++i)
        target = subtract(target, shape(3, 10), kTol);
    return target;
}

/// A block around the target, cut away on a random half of its sides.
Region randomObstruction(std::mt19937& random, const Region& target) {
    const Box2 box = boundingBox(target);
    const Vec2 size = box.size();
    Region obstruction =
        subtract(makeRectangle(box.min - Vec2(15, 15), box.max + Vec2(15, 15)), target, kTol);
    const double cut = 12;
    const Vec2 lows[4] = {{box.min.x() - 20, box.min.y() - 20},
                          {box.max.x() - cut, box.min.y() - 20},
                          {box.min.x() - 20, box.min.y() - 20},
                          {box.min.x() - 20, box.max.y() - cut}};
    const Vec2 sizes[4] = {{20 + cut, size.y() + 40},
                           {20 + cut, size.y() + 40},
                           {size.x() + 40, 20 + cut},
                           {size.x() + 40, 20 + cut}};
    for (int side = 0; side < 4; ++side)
        if (random() % 4 == 0)
            obstruction = subtract(obstruction, makeRectangle(lows[side], lows[side] + sizes[side]), kTol);
    return obstruction;
}

void expectSound(const ClearingTask& task, double radius_mm, double step_over_mm) {
    const Toolpath path =
        clearArea(task, flatEndMill(2 * radius_mm), cuttingData(step_over_mm, 4), kMachine, kTol);
    const SimulatedCut cut = simulate(path, task, radius_mm, 0.2, 0.3);
    EXPECT_EQ(cut.gouged_mm2, 0);
    EXPECT_EQ(cut.left_mm2, 0);
    EXPECT_EQ(cut.bad_rapids, 0);
    const PathProof proof = prove(path, task, radius_mm, kTol);
    EXPECT_GE(proof.least_clearance_mm, 0);
    EXPECT_TRUE(proof.rapids_clear);
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        EXPECT_TRUE(move.arc.has_value() || move.to != from) << "a move without length";
        from = move.to;
    }
}

class RandomPockets : public testing::TestWithParam<unsigned> {};

TEST_P(RandomPockets, AreClearedWithoutAGouge) {
    SCOPED_TRACE("seed " + std::to_string(GetParam()));
    std::mt19937 random(GetParam());
    const Region target = randomTarget(random);
    const Region obstruction = randomObstruction(random, target);
    const double r = std::uniform_real_distribution<double>(1.5, 8)(random);
    const double step_over = r * std::uniform_real_distribution<double>(0.3, 1)(random);
    expectSound(fullTask(target, obstruction, r, kTol), r, step_over);
}

TEST_P(RandomPockets, AreFinishedByASmallerTool) {
    SCOPED_TRACE("seed " + std::to_string(GetParam()));
    std::mt19937 random(1000 + GetParam());
    const Region target = randomTarget(random);
    const Region obstruction = randomObstruction(random, target);
    const double larger = std::uniform_real_distribution<double>(4, 9)(random);
    const double r = larger * std::uniform_real_distribution<double>(0.3, 0.9)(random);
    expectSound(restTask(target, obstruction, larger, r, kTol), r, 0.8 * r);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPockets, testing::Range(1U, 61U));

/// Regions whose offsets once came out wrong: near-tangent arcs, crescents, closed necks.
INSTANTIATE_TEST_SUITE_P(HardOffsets, RandomPockets, testing::Values(115U, 165U, 179U, 269U));

}  // namespace
}  // namespace stepmill
