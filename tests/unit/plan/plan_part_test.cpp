#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/plan/plan.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

PlanRequest inAluminium() {
    PlanRequest request;
    request.sequence.material = "aluminium";
    return request;
}

Part samplePart(const std::string& name) {
    return readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + name).front();
}

Plan planSample(const std::string& name, const Progress& progress = {}) {
    return planPart(samplePart(name), inAluminium(), defaultToolLibrary(), defaultMachine(), kTol, progress);
}

TEST(PlanPart, MachinesTheIslandPocketWhole) {
    const Plan plan = planSample("rounded_pocket.step");
    const double pocket_mm2 = 70 * 50 - 36 * (4 - kPi) - 64 * kPi;
    EXPECT_NEAR(plan.balance.stock_minus_part_mm3, pocket_mm2 * 12, 1e-3 * pocket_mm2 * 12);
    EXPECT_NEAR(plan.balance.planned_mm3, pocket_mm2 * 12, 1e-3 * pocket_mm2 * 12);
    EXPECT_TRUE(plan.complete(kTol));
    ASSERT_EQ(plan.setups.size(), 1U);
    EXPECT_FALSE(plan.setups[0].operations.empty());
    EXPECT_LE(plan.totals.lower_bound_s, plan.totals.time_s);
}

TEST(PlanPart, WhatStaysOfResidualsAddsUpToTheBooks) {
    for (const char* name : {"four_setups.step", "die_cavity.step"}) {
        const Plan plan = planSample(name);
        double stays_mm3 = 0;
        for (const PlannedSetup& setup : plan.setups)
            for (const PlannedFeature& planned : setup.features)
                for (const Residual& residual : planned.sequence.residual) {
                    ASSERT_TRUE(residual.stays_mm3);
                    EXPECT_LE(*residual.stays_mm3, residual.volume_mm3 * (1 + 1e-9)) << planned.feature.id;
                    stays_mm3 += *residual.stays_mm3;
                }
        EXPECT_NEAR(stays_mm3, plan.balance.residual_mm3, 1e-6 * (1 + stays_mm3)) << name;
    }
}

TEST(PlanPart, TotalsAreTheSumOfOperationsAndToolChanges) {
    const Plan plan = planSample("nested_pockets.step");
    double operations_s = 0;
    int changes = 0;
    for (const PlannedSetup& setup : plan.setups) {
        for (std::size_t i = 0; i < setup.operations.size(); ++i) {
            const Operation& operation = setup.operations[i];
            EXPECT_EQ(operation.id, setup.setup.id + ".O" + std::to_string(i + 1));
            operations_s += measure(operation.path, plan.machine).time_s();
            const bool changed = i == 0 || operation.tool_id != setup.operations[i - 1].tool_id;
            changes += changed ? 1 : 0;
            // From a change straight down, else from where the operation before it ended.
            if (changed)
                EXPECT_EQ(operation.path.moves.front().to.head<2>(), operation.path.start.head<2>());
            else
                EXPECT_EQ(operation.path.start, setup.operations[i - 1].path.moves.back().to);
        }
    }
    EXPECT_GT(changes, 0);
    EXPECT_EQ(plan.totals.tool_changes, changes);
    EXPECT_NEAR(plan.totals.time_s, operations_s + changes * plan.machine.tool_change_s, 1e-6);
    EXPECT_NEAR(plan.totals.time_s, plan.totals.cutting_s + plan.totals.air_s + plan.totals.tool_change_s,
                1e-6);
}

TEST(PlanPart, IsTheSameForOneThreadAndTwo) {
    const auto run = [](int threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return planSample("nested_pockets.step");
    };
    const Plan one = run(1);
    const Plan two = run(2);
    EXPECT_EQ(one.totals.time_s, two.totals.time_s);
    EXPECT_EQ(one.balance.residual_mm3, two.balance.residual_mm3);
    ASSERT_EQ(one.setups.size(), two.setups.size());
    for (std::size_t s = 0; s < one.setups.size(); ++s) {
        ASSERT_EQ(one.setups[s].operations.size(), two.setups[s].operations.size());
        for (std::size_t i = 0; i < one.setups[s].operations.size(); ++i) {
            const Operation& a = one.setups[s].operations[i];
            const Operation& b = two.setups[s].operations[i];
            EXPECT_EQ(a.tool_id, b.tool_id);
            EXPECT_EQ(a.feature_id, b.feature_id);
            EXPECT_EQ(a.path.moves.size(), b.path.moves.size());
            EXPECT_EQ(a.path.totals.cut_length_mm, b.path.totals.cut_length_mm);
        }
    }
}

TEST(PlanPart, ReportsProgressThatNeverFallsAndEndsAtOne) {
    double last = 0;
    bool fell = false;
    planSample("rounded_pocket.step", [&](const std::string&, double share) {
        fell = fell || share < last;
        last = share;
    });
    EXPECT_FALSE(fell);
    EXPECT_EQ(last, 1);
}

TEST(PlanPart, RefusesAMaterialTheLibraryDoesNotKnow) {
    PlanRequest request;
    request.sequence.material = "cheese";
    try {
        planPart(samplePart("rounded_pocket.step"), request, defaultToolLibrary(), defaultMachine(), kTol);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Usage);
    }
}

TEST(PlanPart, KeepsWhatNoToolCanMakeAsResidualWithAReason) {
    ToolLibrary only_wide = defaultToolLibrary();
    std::erase_if(only_wide.tools, [](const ToolAssembly& tool) { return tool.diameter_mm < 50; });
    ASSERT_FALSE(only_wide.tools.empty());
    const Plan plan =
        planPart(samplePart("rounded_pocket.step"), inAluminium(), only_wide, defaultMachine(), kTol);
    EXPECT_FALSE(plan.complete(kTol));
    EXPECT_TRUE(plan.setups[0].operations.empty());
    EXPECT_EQ(plan.totals.time_s, 0);
    EXPECT_NEAR(plan.balance.residual_mm3, plan.balance.stock_minus_part_mm3,
                1e-3 * plan.balance.stock_minus_part_mm3);
    EXPECT_LE(plan.balance.gapShare(), kTol.volume_share);
    EXPECT_TRUE(std::any_of(plan.warnings.begin(), plan.warnings.end(),
                            [](const Warning& warning) { return warning.code == "no-tool"; }));
}

TEST(PlanPart, GoesThroughFourSetupsAndLeavesNothing) {
    const Plan plan = planSample("four_setups.step");
    ASSERT_EQ(plan.setups.size(), 4U);
    EXPECT_EQ(plan.setups[0].setup.stock.kind, Stock::Kind::Box);
    double arrives_mm3 = plan.stock.volume_mm3;
    for (const PlannedSetup& setup : plan.setups) {
        // Each stock is what the setup before it left, and each account closes.
        EXPECT_NEAR(setup.setup.stock.volume_mm3, arrives_mm3, 0.1) << setup.setup.id;
        arrives_mm3 = setup.setup.stock.volume_mm3 - setup.balance.planned_mm3;
        EXPECT_LE(setup.balance.gapShare() * setup.balance.stock_minus_part_mm3,
                  kTol.volume_share * plan.balance.stock_minus_part_mm3)
            << setup.setup.id;
        EXPECT_FALSE(setup.clamping.text.empty());
    }
    EXPECT_TRUE(plan.complete(kTol)) << plan.balance.residual_mm3 << " " << plan.balance.unreachable_mm3;
    EXPECT_LE(plan.balance.gapShare(), kTol.volume_share);
}

TEST(PlanPart, CutsWhatTwoSetupsReachOnce) {
    PlanRequest request = inAluminium();
    request.setup.axes = {Vec3::UnitZ(), -Vec3::UnitZ()};
    const Plan plan =
        planPart(samplePart("plate_with_holes.step"), request, defaultToolLibrary(), defaultMachine(), kTol);
    ASSERT_EQ(plan.setups.size(), 2U);
    EXPECT_NEAR(plan.setups[0].balance.planned_mm3, plan.balance.planned_mm3, 1);
    EXPECT_LE(plan.balance.gapShare(), kTol.volume_share);
}

TEST(PlanPart, ResidualsStayInTheStockOfTheNextSetup) {
    PlanRequest request = inAluminium();
    request.setup.axes = {Vec3::UnitZ(), Vec3::UnitX()};
    ToolLibrary only_wide = defaultToolLibrary();
    std::erase_if(only_wide.tools, [](const ToolAssembly& tool) { return tool.diameter_mm < 50; });
    const Plan plan = planPart(samplePart("rounded_pocket.step"), request, only_wide, defaultMachine(), kTol);
    ASSERT_EQ(plan.setups.size(), 2U);
    EXPECT_DOUBLE_EQ(plan.setups[1].setup.stock.volume_mm3, plan.stock.volume_mm3);
    EXPECT_NEAR(plan.balance.residual_mm3, plan.balance.stock_minus_part_mm3,
                1e-3 * plan.balance.stock_minus_part_mm3);
}

TEST(VolumeBalance, GapIsTheShareNoEntryAccountsFor) {
    VolumeBalance balance;
    balance.stock_minus_part_mm3 = 1000;
    balance.planned_mm3 = 900;
    balance.residual_mm3 = 50;
    balance.unreachable_mm3 = 40;
    EXPECT_NEAR(balance.gapShare(), 0.01, 1e-12);
}

}  // namespace
}  // namespace stepmill
