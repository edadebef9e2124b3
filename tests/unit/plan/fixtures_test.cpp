// Fixtures through the whole plan: kept clear of, named where they cost material, and proven.

#include <gtest/gtest.h>

#include <cmath>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/layers/fixture_solids.h"
#include "stepmill/plan/hold_stage.h"
#include "stepmill/plan/plan.h"
#include "support/occt_solids.h"
#include "support/told.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

Plan planWith(const std::string& sample, const std::vector<Fixture>& fixtures) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.fixtures.file = "clamps.json";
    request.fixtures.setups["S1"] = fixtures;
    const Part part = readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + sample).front();
    return planPart(part, request, defaultToolLibrary(), defaultMachine(), kTol);
}

double residualMm3(const Plan& plan, Reason reason) {
    double sum_mm3 = 0;
    for (const PlannedFeature& planned : plan.setups.front().features)
        for (const Residual& residual : planned.sequence.residual)
            if (residual.reason == reason) sum_mm3 += residual.volume_mm3;
    return sum_mm3;
}

/// Least distance on plan between the axis below `z_mm` and a region.
double closestMm(const Plan& plan, const Region& region, double z_mm) {
    double closest_mm = 1e300;
    for (const Operation& operation : plan.setups.front().operations)
        for (const Move& move : operation.path.moves)
            if (move.to.z() < z_mm)
                closest_mm = std::min(closest_mm, distanceToBoundary(region, move.to.head<2>()) -
                                                      plan.library.tool(operation.tool_id).radius_mm());
    return closest_mm;
}

// R' = 1.05 R for the widest, so at least that for all [Tripathi2005].
TEST(Fixtures, GrowByAShareOfTheWidestToolsRadius) {
    const ToolLibrary& library = defaultToolLibrary();
    double widest_mm = 0;
    for (const ToolAssembly& tool : library.tools) {
        double tool_mm = tool.diameter_mm;
        for (const HolderCylinder& cylinder : tool.holder)
            tool_mm = std::max(tool_mm, cylinder.diameter_mm);
        EXPECT_GE(fixtureGrowthMm({}, library), 0.05 * tool_mm / 2) << tool.id;
        widest_mm = std::max(widest_mm, tool_mm);
    }
    EXPECT_DOUBLE_EQ(fixtureGrowthMm({}, library), 0.05 * widest_mm / 2);
    FixtureFile measured;
    measured.growth = 0;
    EXPECT_EQ(fixtureGrowthMm(measured, library), 0);
}

// A bar that lies over the corner of the block, as a CAD system has it.
TEST(Fixtures, SolidsAreKeptClearOfAtEveryHeight) {
    const TopoDS_Shape bar = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp::DX()), 8, 140).Shape();
    const Eigen::Isometry3d across =
        Eigen::Translation3d(-20, 30, 8) * Eigen::AngleAxisd(degToRad(20), Vec3::UnitZ());
    const std::vector<Fixture> blocks = fixtureBlocks("bar", test::part(bar), across, kTol);
    ASSERT_GT(blocks.size(), 2U);
    const Plan plan = planWith("rounded_pocket.step", blocks);
    EXPECT_GT(residualMm3(plan, Reason::Fixture), 0);
    for (const Operation& operation : plan.setups.front().operations) {
        const double radius_mm = plan.library.tool(operation.tool_id).radius_mm();
        Vec3 from = operation.path.start;
        for (const Move& move : operation.path.moves) {
            // Arcs as chords: nothing here turns round the bar.
            const int steps = static_cast<int>(std::ceil((move.to - from).norm())) + 1;
            for (int i = 0; i <= steps; ++i) {
                const Vec3 in_bar = across.inverse() * (from + (move.to - from) * i / steps);
                if (in_bar.z() > 8 || in_bar.x() < 0 || in_bar.x() > 140) continue;
                // A tip below the bar's axis has its full width beside it.
                const double half_mm = in_bar.z() < 0 ? 8 : std::sqrt(64 - in_bar.z() * in_bar.z());
                EXPECT_GT(std::abs(in_bar.y()), half_mm + radius_mm) << operation.id;
            }
            from = move.to;
        }
    }
}

// 100 x 80 x 30 block with a pocket from (15, 15) to (85, 65).
TEST(Fixtures, AClampOverAPocketLeavesWhatIsUnderIt) {
    const Fixture clamp{"clamp", makeRectangle(Vec2(-20, 30), Vec2(35, 50)), 0, 25};
    const Plan plan = planWith("rounded_pocket.step", {clamp});
    // 20 mm of the pocket's length and its 20 mm, larger on each side and round at its corners.
    const double more_mm = fixtureGrowthMm({}, defaultToolLibrary());
    const double corners_mm2 = 0.5 * more_mm * more_mm * (4 - kPi);
    EXPECT_NEAR(residualMm3(plan, Reason::Fixture), ((20 + more_mm) * (20 + 2 * more_mm) - corners_mm2) * 12,
                1e-3);
    EXPECT_FALSE(plan.complete(kTol));
    EXPECT_LT(plan.balance.gapShare(), 1e-3);
    EXPECT_GE(closestMm(plan, clamp.section, 25), more_mm - 1e-3);
    EXPECT_NE(plan.setups.front().clamping.text.find("clamps.json says: clamp"), std::string::npos);
    // Rapids run over it.
    for (const Operation& operation : plan.setups.front().operations)
        EXPECT_GE(operation.path.moves.back().to.z(), 25);
}

TEST(Fixtures, BesideTheStockTheyCostNothing) {
    const Plan plan =
        planWith("rounded_pocket.step", {{"stop", makeRectangle(Vec2(-30, 0), Vec2(0, 80)), -30, -5}});
    EXPECT_EQ(residualMm3(plan, Reason::Fixture), 0);
    EXPECT_TRUE(plan.complete(kTol));
}

TEST(Fixtures, AreRefusedInTheStockAndNamedWhereTheSetupDoesNotExist) {
    try {
        planWith("rounded_pocket.step", {{"stop", makeRectangle(Vec2(-30, 0), Vec2(2, 80)), -30, -5}});
        FAIL() << "taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Usage);
        EXPECT_TRUE(test::tells(error.what(), {"stop", "S1", "stock"}));
    }
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.fixtures.setups["S9"] = {};
    const Part part = readStep(STEPMILL_SOURCE_DIR "/step_parts/rounded_pocket.step").front();
    const Plan plan = planPart(part, request, defaultToolLibrary(), defaultMachine(), kTol);
    EXPECT_TRUE(std::any_of(plan.warnings.begin(), plan.warnings.end(), [](const Warning& warning) {
        return warning.code == "fixtures-unused" && warning.subject == "S9";
    }));
}

TEST(Fixtures, NothingGoesIntoAPlateUnderThePart) {
    // 10 mm thick with through holes, on a plate that touches it. Touching it does not grow into it.
    const Plan plan = planWith("plate_with_holes.step",
                               {{"plate", makeRectangle(Vec2(-50, -50), Vec2(400, 400)), -60, -10}});
    EXPECT_EQ(residualMm3(plan, Reason::Fixture), 0);
    for (const Operation& operation : plan.setups.front().operations)
        for (const Move& move : operation.path.moves)
            EXPECT_GE(move.to.z(), -10) << operation.id;
    EXPECT_LT(plan.balance.gapShare(), 1e-3);
}

TEST(Fixtures, HoldersPassBesideHighOnes) {
    // Beside the pocket's wall stands a post of 80 mm: no holder reaches over it.
    const Fixture post{"post", makeRectangle(Vec2(0, 20), Vec2(12, 60)), 0, 80};
    const Plan plan = planWith("rounded_pocket.step", {post});
    const double more_mm = fixtureGrowthMm({}, defaultToolLibrary());
    for (const Operation& operation : plan.setups.front().operations) {
        const ToolAssembly& tool = plan.library.tool(operation.tool_id);
        for (const HolderCylinder& cylinder : tool.holder) {
            double closest_mm = 1e300;
            for (const Move& move : operation.path.moves)
                if (move.to.z() + cylinder.bottom_mm < 80)
                    closest_mm = std::min(closest_mm, distanceToBoundary(post.section, move.to.head<2>()));
            EXPECT_GE(closest_mm, cylinder.diameter_mm / 2 + more_mm - 1e-3) << operation.id;
        }
    }
    EXPECT_LT(plan.balance.gapShare(), 1e-3);
}

}  // namespace
}  // namespace stepmill
