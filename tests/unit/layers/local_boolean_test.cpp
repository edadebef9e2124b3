#include <random>

#include <gtest/gtest.h>

#include "layers/slab/local_boolean.h"
#include "stepmill/planar/boolean.h"

using namespace stepmill;

namespace {

Region withHoles(const std::vector<Region>& holes) {
    Region plate = makeRectangle(Vec2(0, 0), Vec2(100, 100));
    for (const Region& hole : holes)
        plate.loops.push_back(reversed(hole.loops.front()));
    return plate;
}

}  // namespace

TEST(CompareLoops, EqualRegionsHaveNoPlaces) {
    const Region plate = withHoles({makeCircle(Vec2(20, 20), 5), makeCircle(Vec2(60, 60), 8)});
    const layers::SharedLoops compared = layers::compareLoops(plate, plate);
    EXPECT_EQ(compared.shared.size(), 3u);
    EXPECT_TRUE(compared.places.empty());
}

TEST(CompareLoops, AHoleThatDiffersIsAFramedPlace) {
    const Region a = withHoles({makeCircle(Vec2(20, 20), 5), makeCircle(Vec2(60, 60), 8)});
    const Region b = withHoles({makeCircle(Vec2(20, 20), 4), makeCircle(Vec2(60, 60), 8)});
    const layers::SharedLoops compared = layers::compareLoops(a, b);
    EXPECT_EQ(compared.shared.size(), 2u);
    ASSERT_EQ(compared.places.size(), 1u);
    EXPECT_TRUE(compared.places[0].framed);
    EXPECT_EQ(compared.places[0].a.loops.size(), 2u);
}

TEST(UniteLocally, KeepsTheSmallerHole) {
    const Tolerances tol;
    const Region a = withHoles({makeCircle(Vec2(20, 20), 5), makeCircle(Vec2(60, 60), 8)});
    const Region b = withHoles({makeCircle(Vec2(20, 20), 4), makeCircle(Vec2(60, 60), 8)});
    const Region united = layers::uniteLocally(a, b, tol);
    EXPECT_TRUE(layers::compareLoops(united, b).places.empty());
}

TEST(UniteLocally, AgreesWithThePlainUnionOnRandomPlates) {
    const Tolerances tol;
    std::mt19937 random(7);
    const auto pick = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int round = 0; round < 60; ++round) {
        SCOPED_TRACE(round);
        const Region plate = makeRectangle(Vec2(0, 0), Vec2(100, 100));
        Region a = plate;
        Region b = plate;
        for (int i = 0; i < 8; ++i) {
            const Region hole =
                makeCircle(snapToGrid(Vec2(pick(-5, 105), pick(-5, 105))), snapToGrid(pick(1, 12)));
            if (i % 4 != 0) a = subtract(a, hole, tol);
            if (i % 4 != 1) b = subtract(b, hole, tol);
            const Region boss =
                makeCircle(snapToGrid(Vec2(pick(-5, 205), pick(-5, 105))), snapToGrid(pick(1, 6)));
            if (i % 3 != 0) a = unite(a, boss, tol);
            if (i % 3 != 1) b = unite(b, boss, tol);
        }
        const Region united = layers::uniteLocally(a, b, tol);
        EXPECT_FALSE(diagnose(united).has_value());
        EXPECT_NEAR(area(united), area(unite(a, b, tol)), 0.05);
        EXPECT_TRUE(covers(united, a, 2 * tol.linear_mm, tol));
        EXPECT_TRUE(covers(united, b, 2 * tol.linear_mm, tol));
    }
}
