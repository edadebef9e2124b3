#include <gtest/gtest.h>

#include "stepmill/access/access_curve.h"
#include "support/random_grounds.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;
constexpr unsigned kSeeds = 12;
constexpr double kWidestMm = 40;

/// What one opening may be off by rounding, not by the method [mm2].
constexpr double kNoiseMm2 = 2e-2;

class AccessCurveLaw : public testing::TestWithParam<unsigned> {
  protected:
    /// Odd seeds are closed all round, even ones open on one side.
    Feature feature() const {
        test::RandomGround random(GetParam());
        return GetParam() % 2 == 1 ? random.closed() : random.open();
    }
};

TEST_P(AccessCurveLaw, NeverRises) {
    const FeatureGround ground(feature(), kTol);
    const AccessCurve curve = accessCurve(ground, 0, kWidestMm);
    for (std::size_t i = 1; i < curve.samples.size(); ++i)
        EXPECT_LE(curve.samples[i].area_mm2, curve.samples[i - 1].area_mm2 + kNoiseMm2)
            << "seed " << GetParam() << " at " << curve.samples[i].diameter_mm;
}

TEST_P(AccessCurveLaw, AgreesWithTheAreaOfEveryCutterBetweenSamples) {
    const FeatureGround ground(feature(), kTol);
    const AccessCurve curve = accessCurve(ground, 0, kWidestMm);
    test::RandomGround random(GetParam() + 1000);
    for (int i = 0; i < 25; ++i) {
        const double diameter = random.number(0.2, 25);
        const bool at_event = std::any_of(
            curve.events.begin(), curve.events.end(),
            [&](const AccessEvent& e) { return std::abs(e.diameter_mm - diameter) < 3 * kTol.linear_mm; });
        if (at_event) continue;
        ToolAssembly cutter = test::endMill(diameter);
        cutter.max_plunge_mm = diameter;  // the curve asks where cutters fit, not how they get there
        const CutterArea found = toolReach(ground, cutter, test::kMaterial).cutter;
        EXPECT_NEAR(curve.areaAt(diameter), found.coverable_area_mm2, curve.max_error_mm2 + kNoiseMm2)
            << "seed " << GetParam() << " at " << diameter;
    }
}

TEST_P(AccessCurveLaw, EveryJumpHasACauseAtItsDiameter) {
    const FeatureGround ground(feature(), kTol);
    const AccessCurve curve = accessCurve(ground, 0, kWidestMm);
    for (std::size_t i = 1; i < curve.samples.size(); ++i) {
        const AccessSample& low = curve.samples[i - 1];
        const AccessSample& high = curve.samples[i];
        if (high.diameter_mm - low.diameter_mm > 2 * kTol.linear_mm) continue;
        if (low.area_mm2 - high.area_mm2 <= curve.max_error_mm2) continue;
        EXPECT_TRUE(std::any_of(curve.events.begin(), curve.events.end(),
                                [&](const AccessEvent& e) {
                                    return e.diameter_mm >= low.diameter_mm - 2 * kTol.linear_mm &&
                                           e.diameter_mm <= high.diameter_mm + 2 * kTol.linear_mm;
                                }))
            << "seed " << GetParam() << " at " << low.diameter_mm;
    }
}

TEST_P(AccessCurveLaw, NecksOfClosedRoomsLetOnlyNarrowerCuttersPass) {
    const FeatureGround ground(feature(), kTol);
    if (!ground.walledIn()) GTEST_SKIP() << "centres may pass outside";
    for (const AccessEvent& event : accessCurve(ground, 0, kWidestMm).events) {
        if (event.kind != AccessEventKind::Neck) continue;
        for (const Vec2& at : event.at) {
            EXPECT_NEAR(2 * distanceToBoundary(ground.feature().target, at), event.diameter_mm,
                        2 * kTol.linear_mm)
                << "seed " << GetParam();
            const double slack = 2 * kTol.linear_mm;
            EXPECT_TRUE(contains(ground.targetOffset(-event.diameter_mm / 2 + slack), at))
                << "seed " << GetParam() << " at " << event.diameter_mm;
            EXPECT_FALSE(contains(ground.targetOffset(-event.diameter_mm / 2 - slack), at))
                << "seed " << GetParam() << " at " << event.diameter_mm;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, AccessCurveLaw, testing::Range(1u, kSeeds + 1));

}  // namespace
}  // namespace stepmill
