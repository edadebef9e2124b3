#include <random>

#include <gtest/gtest.h>

#include "stepmill/planar/boolean.h"
#include "support/occt_solids.h"

using namespace stepmill;
using namespace stepmill::test;

namespace {

/// A block with drilled holes (some tilted), pockets and a ball cavity at random.
TopoDS_Shape randomBlock(std::mt19937& random) {
    const auto pick = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    TopoDS_Shape shape = box(0, 0, 0, 80, 60, 30);
    for (int i = 0; i < 3; ++i)
        shape = cut(shape, box(pick(-10, 70), pick(-10, 50), pick(5, 28), pick(5, 30), pick(5, 30), 40));
    for (int i = 0; i < 2; ++i)
        shape = cut(shape, cylinder(pick(5, 75), pick(5, 55), pick(-5, 20), pick(1, 6), 40));
    const gp_Ax2 tilted(gp_Pnt(pick(20, 60), pick(20, 40), -10), gp_Dir(pick(-0.5, 0.5), pick(-0.5, 0.5), 1));
    shape = cut(shape, BRepPrimAPI_MakeCylinder(tilted, pick(1, 5), 80).Shape());
    return cut(shape,
               BRepPrimAPI_MakeSphere(gp_Pnt(pick(10, 70), pick(10, 50), pick(5, 35)), pick(3, 10)).Shape());
}

void expectLaws(const LayerStack& stack, const Tolerances& tol) {
    double removed = 0;
    const Region* above = nullptr;
    for (const Layer& layer : stack.layers) {
        EXPECT_FALSE(diagnose(layer.part).has_value()) << layer.bottom_z_mm << " " << *diagnose(layer.part);
        EXPECT_FALSE(diagnose(layer.shadow).has_value())
            << layer.bottom_z_mm << " " << *diagnose(layer.shadow);
        EXPECT_TRUE(covers(layer.shadow, layer.part, 2 * tol.linear_mm, tol)) << layer.bottom_z_mm;
        if (above) {
            EXPECT_TRUE(covers(layer.shadow, *above, 2 * tol.linear_mm, tol)) << layer.bottom_z_mm;
        }
        EXPECT_TRUE(covers(layer.stock, layer.part, tol.gouge_mm, tol)) << layer.bottom_z_mm;
        double hidden = 0;
        for (const HiddenVolume& entry : layer.hidden)
            hidden += entry.volume_mm3;
        EXPECT_NEAR(hidden, layer.sloped_volume_mm3, 1e-9 * (1 + hidden)) << layer.bottom_z_mm;
        removed += (area(layer.stock) - area(layer.part)) * layer.height_mm() + layer.sloped_volume_mm3;
        above = &layer.shadow;
    }
    const double wanted = stack.stock_volume_mm3 - stack.part_volume_mm3;
    EXPECT_NEAR(removed, wanted, tol.volume_share * wanted);
}

}  // namespace

TEST(SliceLaws, HoldOnRandomBlocksFromAllSides) {
    const Tolerances tol;
    for (unsigned seed = 1; seed <= 8; ++seed) {
        std::mt19937 random(seed);
        const Part block = part(randomBlock(random));
        for (const char* axis : {"+z", "-z", "+x", "-y"}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + " axis " + axis);
            expectLaws(slice(setupOf(block, *parseAxis(axis)), tol), tol);
        }
    }
}

TEST(SliceLaws, RemovedVolumeIsTheSameFromOppositeSides) {
    const Tolerances tol;
    // Which slabs are joined or halved depends on what a tool can see from its side.
    SliceOptions options = allLevels();
    options.largest_hidden_share = 2;
    for (unsigned seed = 21; seed <= 24; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const Part block = part(randomBlock(random));
        const LayerStack up = slice(setupOf(block, Vec3::UnitZ()), tol, options);
        const LayerStack down = slice(setupOf(block, -Vec3::UnitZ()), tol, options);
        ASSERT_EQ(up.layers.size(), down.layers.size());
        for (std::size_t i = 0; i < up.layers.size(); ++i) {
            const Layer& mirror = down.layers[down.layers.size() - 1 - i];
            // Fitted walls may differ by the curve tolerance on their length.
            EXPECT_NEAR(area(up.layers[i].part), area(mirror.part),
                        2 * tol.curve_fit_mm * perimeter(mirror.part) + 1e-6)
                << up.layers[i].bottom_z_mm;
        }
    }
}
