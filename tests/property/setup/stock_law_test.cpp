// Random cuts from several sides: the solid loses what the planar books say, and no more than it has.

#include <gtest/gtest.h>

#include <random>

#include "stepmill/planar/boolean.h"
#include "stepmill/setup/in_process.h"
#include "unit/layers/solids.h"

using namespace stepmill;
using namespace stepmill::test;

namespace {

const Tolerances kTol;

class RandomCuts {
  public:
    explicit RandomCuts(unsigned seed) : random_(seed) {}

    /// A pocket or hole, often against a side, in half-millimetres so that walls coincide now and then.
    Region region(const Vec2& size) {
        const Vec2 centre(half(0, size.x()), half(0, size.y()));
        if (random_() % 2 == 0) return makeCircle(centre, 1 + 0.5 * static_cast<double>(random_() % 12));
        const Vec2 reach(half(1, 15), half(1, 15));
        return makeRectangle(centre - reach, centre + reach);
    }

    /// Prisms from the top that do not overlap: each is what the ones before it left of a region.
    std::vector<Prism> prisms(const stepmill::Setup& setup, const std::vector<Prism>& arriving) {
        const Vec3 size = setup.stock_bbox_mm.sizes();
        std::vector<Prism> found;
        Region taken;
        for (int i = 0; i < 4; ++i) {
            Region cut = intersect(region(size.head<2>()), arriving.front().region, kTol);
            if (!taken.empty()) cut = subtract(cut, taken, kTol);
            if (area(cut) < 1) continue;
            taken = taken.empty() ? cut : unite(taken, cut, kTol);
            found.push_back({std::move(cut), 0, -std::min(size.z(), half(1, 20))});
        }
        return found;
    }

  private:
    double half(double low, double high) {
        return low + 0.5 * static_cast<double>(random_() % static_cast<unsigned>(2 * (high - low)));
    }
    std::mt19937 random_;
};

std::vector<Prism> boxSlab(const stepmill::Setup& setup) {
    const Box3& box = setup.stock_bbox_mm;
    return {{makeRectangle(box.min().head<2>(), box.max().head<2>()), 0, box.min().z()}};
}

}  // namespace

TEST(StockLaw, TheSolidLosesThePrismsVolume) {
    const Part block = part(box(0, 0, 0, 60, 40, 20));
    for (unsigned seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        RandomCuts cuts(seed);
        const stepmill::Setup first = setupOf(block);
        const std::vector<Prism> removed = cuts.prisms(first, boxSlab(first));
        const StockAfter after = stockAfter(first, removed, boxSlab(first), kTol);
        EXPECT_NEAR(after.removed_mm3, volumeOf(removed), 1e-4 * volumeOf(removed) + 1e-3);
    }
}

TEST(StockLaw, CutsAcrossEachOtherTakeNoMoreThanTheirPrisms) {
    const Part block = part(box(0, 0, 0, 60, 40, 20));
    for (unsigned seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        RandomCuts cuts(seed);
        const stepmill::Setup first = setupOf(block);
        const StockAfter after = stockAfter(first, cuts.prisms(first, boxSlab(first)), boxSlab(first), kTol);
        const stepmill::Setup second =
            onStock(setupOf(block, seed % 2 == 0 ? Vec3(1, 0, 0) : Vec3(0, -1, 0)), after.stock);
        // The box around the stock stands for its hull: prisms may hold air.
        const std::vector<Prism> removed = cuts.prisms(second, boxSlab(second));
        const StockAfter last = stockAfter(second, removed, boxSlab(second), kTol);
        EXPECT_LE(last.removed_mm3, volumeOf(removed) * (1 + 1e-4) + 1e-3);
        EXPECT_GE(last.removed_mm3, -1e-3);
    }
}
