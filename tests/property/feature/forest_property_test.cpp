// Laws of features on random blocks with pockets, holes and steps cut to random depths.

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "stepmill/feature/feature.h"
#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;
const Vec2 kSize(100, 80);
constexpr double kHeight = 40;
constexpr int kCases = 60;
constexpr int kPoints = 300;

using Random = std::mt19937_64;

double between(Random& random, double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
}

/// A cut from the top: a rectangle, a rounded one or a circle, some of them across the block's edge.
struct Cut {
    Region region;
    double depth_mm = 0;
};

Cut randomCut(Random& random) {
    const Vec2 at(between(random, 0, kSize.x()), between(random, 0, kSize.y()));
    const Vec2 half(between(random, 3, 25), between(random, 3, 25));
    const int kind = std::uniform_int_distribution<int>(0, 2)(random);
    Cut cut;
    // Some reach through the block.
    cut.depth_mm = between(random, 0, 1) < 0.2 ? kHeight : std::round(between(random, 1, kHeight - 1));
    cut.region = kind == 0   ? makeRectangle(at - half, at + half)
                 : kind == 1 ? makeRoundedRectangle(at - half, at + half, 2)
                             : makeCircle(at, half.x());
    return cut;
}

struct Block {
    std::vector<Cut> cuts;
    LayerStack stack;
};

Block makeBlock(Random& random) {
    Block block;
    const int count = std::uniform_int_distribution<int>(1, 7)(random);
    for (int i = 0; i < count; ++i)
        block.cuts.push_back(randomCut(random));
    std::vector<double> depths{kHeight};
    for (const Cut& cut : block.cuts)
        depths.push_back(cut.depth_mm);
    std::sort(depths.begin(), depths.end());
    depths.erase(std::unique(depths.begin(), depths.end()), depths.end());

    const Region stock = makeRectangle({0, 0}, kSize);
    LayerStack& stack = block.stack;
    stack.setup_id = "S1";
    stack.stock_bottom_z_mm = -kHeight;
    double top = 0;
    for (const double depth : depths) {
        Layer layer;
        layer.top_z_mm = top;
        layer.bottom_z_mm = -depth;
        layer.stock = stock;
        layer.part = stock;
        for (const Cut& cut : block.cuts)
            if (cut.depth_mm >= depth) layer.part = subtract(layer.part, cut.region, kTol);
        // Every cut comes from the top, so the part only widens downwards.
        layer.shadow = layer.part;
        stack.stock_volume_mm3 += area(stock) * layer.height_mm();
        stack.part_volume_mm3 += area(layer.part) * layer.height_mm();
        top = layer.bottom_z_mm;
        stack.layers.push_back(std::move(layer));
    }
    return block;
}

bool holds(const Feature& feature, const Vec3& p) {
    return p.z() < feature.top_z_mm && p.z() > feature.floor_z_mm && contains(feature.target, p.head<2>());
}

class RandomBlocks : public ::testing::TestWithParam<int> {};

TEST_P(RandomBlocks, EveryPointThatIsCutLiesInOneFeatureAndBooksClose) {
    Random random(static_cast<std::uint64_t>(GetParam()));
    const Block block = makeBlock(random);
    const FeatureSet found = recogniseFeatures(block.stack, kTol);
    double owned = 0;
    for (const Feature& feature : found.features)
        owned += feature.volume_mm3;
    for (const Unplanned& unplanned : found.unplanned)
        owned += unplanned.volume_mm3;
    const double removable = block.stack.stock_volume_mm3 - block.stack.part_volume_mm3;
    EXPECT_NEAR(owned, removable, 1e-3 * removable) << "seed " << GetParam();

    for (int i = 0; i < kPoints; ++i) {
        const Vec3 p(between(random, 0, kSize.x()), between(random, 0, kSize.y()),
                     between(random, -kHeight, 0));
        double away = 1e300;
        bool cut_away = false;
        for (const Cut& cut : block.cuts) {
            away = std::min(away, distanceToBoundary(cut.region, p.head<2>()));
            cut_away = cut_away || (-p.z() < cut.depth_mm && contains(cut.region, p.head<2>()));
        }
        // Strips narrower than a sliver belong to nobody.
        if (away < 2 * kTol.sliver_mm) continue;
        const auto owners = std::count_if(found.features.begin(), found.features.end(),
                                          [&](const Feature& feature) { return holds(feature, p); });
        EXPECT_EQ(owners, cut_away ? 1 : 0) << "seed " << GetParam() << " at " << p.transpose();
    }
}

TEST_P(RandomBlocks, ParentsComeFirstAndEndWhereTheirChildrenBegin) {
    Random random(static_cast<std::uint64_t>(GetParam()));
    const FeatureSet found = recogniseFeatures(makeBlock(random).stack, kTol);
    std::map<std::string, const Feature*> before;
    for (const Feature& feature : found.features) {
        for (const std::string& id : feature.parents) {
            ASSERT_TRUE(before.count(id)) << "seed " << GetParam() << ": " << id << " after " << feature.id;
            EXPECT_DOUBLE_EQ(before[id]->floor_z_mm, feature.top_z_mm) << "seed " << GetParam();
        }
        before[feature.id] = &feature;
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomBlocks, ::testing::Range(1, kCases + 1));

}  // namespace
}  // namespace stepmill
