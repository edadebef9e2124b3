#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "stepmill/access/slivers.h"
#include "stepmill/planar/region_text.h"
#include "support/random_grounds.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::endMill;
using test::kMaterial;
using test::RandomGround;

using test::kTol;
constexpr unsigned kSeeds = 40;

/// Centres dropped because they are less than tol.sliver_mm apart leave strips about as wide and some
/// millimetres long.
constexpr double kStripMm2 = 5e-3;

/// Area of `a` outside `b`, but for strips of rounding.
double outside(const Region& a, const Region& b) {
    return area(access::withoutSliverComponents(subtract(a, b, kTol), kTol));
}

/// Odd seeds have open edges.
Feature featureOf(unsigned seed, RandomGround& random) {
    return seed % 2 == 1 ? random.open() : random.closed();
}

class AreaLaws : public testing::TestWithParam<unsigned> {
  protected:
    AreaLaws()
        : random_(GetParam()),
          ground_(featureOf(GetParam(), random_), kTol),
          trace_(__FILE__, __LINE__, "seed " + std::to_string(GetParam())) {
        double a = random_.number(2, 16);
        double b = random_.number(2, 16);
        m_ = toolReach(ground_, endMill(std::max(a, b)), kMaterial).cutter;
        n_ = toolReach(ground_, endMill(std::min(a, b)), kMaterial).cutter;
    }

    ~AreaLaws() override {
        if (!HasFailure()) return;
        std::ofstream text("area_laws_" + std::to_string(GetParam()) + ".txt");
        text << "# target\n"
             << toText(ground_.feature().target) << "# obstruction\n"
             << toText(ground_.feature().obstruction) << "# radii " << m_.radius_mm << " " << n_.radius_mm
             << "\n";
    }

    RandomGround random_;
    FeatureGround ground_;
    CutterArea m_;
    CutterArea n_;
    testing::ScopedTrace trace_;
};

TEST_P(AreaLaws, SmallerToolReachesAllTheLargerDoes) {
    EXPECT_LE(outside(m_.coverable, n_.coverable), 1e-3);  // eq. 1
    EXPECT_LE(m_.coverable_area_mm2, n_.coverable_area_mm2 + 1e-2);
}

TEST_P(AreaLaws, SecondToolCompletesTheFirst) {
    const DecomposedArea d = decomposedArea(ground_, &m_, n_);
    const Region both = unite(m_.accessible, d.area, kTol);
    EXPECT_LE(outside(n_.coverable, both), kStripMm2);  // eq. 2
    EXPECT_LE(outside(d.area, n_.accessible), 1e-3);
    EXPECT_NEAR(d.new_area_mm2, n_.coverable_area_mm2 - m_.coverable_area_mm2, 2e-2);
}

TEST_P(AreaLaws, NothingIsLeftForTheSameToolAgain) {
    const DecomposedArea d = decomposedArea(ground_, &n_, n_);
    EXPECT_TRUE(d.centres.empty()) << area(d.centres);
    EXPECT_TRUE(d.area.empty());
}

TEST_P(AreaLaws, PairIsEmptyIfAndOnlyIfBothReachTheSame) {
    const DecomposedArea d = decomposedArea(ground_, &m_, n_);
    const double more_mm2 = outside(n_.coverable, m_.coverable);
    EXPECT_EQ(d.area.empty(), more_mm2 <= kTol.area_mm2) << "new area " << more_mm2;
}

TEST_P(AreaLaws, SweptToolNeverEntersTheObstruction) {
    for (const CutterArea* tool : {&m_, &n_}) {
        for (const Loop& loop : tool->free_centres.loops) {
            for (const Vec2& centre : tessellate(loop, 0.05)) {
                ASSERT_FALSE(contains(ground_.feature().obstruction, centre));
                ASSERT_GE(distanceToBoundary(ground_.feature().obstruction, centre),
                          tool->radius_mm - kTol.gouge_mm)
                    << centre.transpose();
            }
        }
    }
}

TEST_P(AreaLaws, EveryComponentHasItsEntryClearOfTheObstruction) {
    for (const CutterArea* tool : {&m_, &n_}) {
        ASSERT_EQ(tool->entries.size(), components(tool->free_centres).size());
        for (const Entry& entry : tool->entries) {
            const double clear_mm = distanceToBoundary(ground_.feature().obstruction, entry.at);
            EXPECT_GE(clear_mm, tool->radius_mm + entry.helix_radius_mm - kTol.gouge_mm)
                << toString(entry.kind);
            if (entry.kind != EntryKind::OpenEdge) continue;
            EXPECT_GE(distanceToBoundary(ground_.feature().target, entry.at), tool->radius_mm);
        }
    }
}

TEST_P(AreaLaws, FatterHolderNeverReachesMore) {
    double before_mm2 = n_.coverable_area_mm2;
    for (const double holder_mm : {18.0, 24.0, 32.0}) {
        ToolAssembly tool = endMill(2 * n_.radius_mm);
        tool.flute_length_mm = tool.stick_out_mm = 6;
        tool.holder = {{holder_mm, 6, 60}};
        const double now_mm2 = toolReach(ground_, tool, kMaterial).collision_free_area_mm2;
        EXPECT_LE(now_mm2, before_mm2 + 1e-2) << holder_mm;
        before_mm2 = now_mm2;
    }
}

// Necks across which two components' discs nearly meet, and cusps as thin as tol.sliver_mm.
INSTANTIATE_TEST_SUITE_P(NarrowNecks, AreaLaws, testing::Values(61U, 105U, 336U));

INSTANTIATE_TEST_SUITE_P(Random, AreaLaws, testing::Range(0U, kSeeds));

}  // namespace
}  // namespace stepmill
