// Features of a setup whose stock is held at the bottom.

#include "plan/holding/held_stock.h"

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/feature/describe_boundary.h"
#include "stepmill/plan/plan.h"
#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

const Region kStock = makeRectangle({0, 0}, {100, 80});
const Region kPart = makeRectangle({10, 10}, {90, 70});

/// Cut round the part down to the stock's bottom, 30 mm, with a window and a hole through the part.
FeatureSet cutThrough() {
    FeatureSet found;
    const auto add = [&](const std::string& id, const Region& target, const Region& obstruction) {
        Feature feature;
        feature.id = id;
        feature.setup_id = "S1";
        feature.top_z_mm = 0;
        feature.floor_z_mm = -30;
        feature.through = true;
        feature.target = target;
        feature.obstruction = obstruction;
        feature.area_mm2 = area(target);
        feature.volume_mm3 = 30 * feature.area_mm2;
        feature.obstacles = {{-30, -20, kPart}, {-20, 0, kPart}};
        describeBoundary(feature, kTol);
        found.features.push_back(std::move(feature));
    };
    const Region window = makeRectangle({30, 30}, {50, 50});
    const Region hole = makeCircle({70, 40}, 4);
    add("S1.F1", subtract(kStock, kPart, kTol), kPart);
    add("S1.F2", window, subtract(kPart, window, kTol));
    add("S1.F3", hole, subtract(kPart, hole, kTol));
    return found;
}

double volumeMm3(const FeatureSet& found) {
    double sum_mm3 = 0;
    for (const Feature& feature : found.features)
        sum_mm3 += feature.volume_mm3;
    for (const Unplanned& entry : found.unplanned)
        sum_mm3 += entry.volume_mm3;
    return sum_mm3;
}

LayerStack oneLayer() {
    LayerStack layers;
    Layer layer;
    layer.top_z_mm = 0;
    layer.bottom_z_mm = -30;
    layer.stock = kStock;
    layers.layers = {layer};
    layers.stock_bottom_z_mm = -30;
    return layers;
}

TEST(WithHeldStock, StopsAllAboveStockThatIsHeldAndBooksTheRest) {
    const FeatureSet whole = cutThrough();
    const HeldStock held{-19, -30, true};
    const FeatureSet free = withHeldStock(whole, held, kTol);
    ASSERT_EQ(free.features.size(), 3U);
    for (std::size_t i : {0, 1}) {
        EXPECT_DOUBLE_EQ(free.features[i].floor_z_mm, -19);
        EXPECT_DOUBLE_EQ(free.features[i].obstacles.front().bottom_z_mm, -19);
    }
    EXPECT_EQ(free.features[0].feature_class, FeatureClass::OpenPocket);
    EXPECT_EQ(free.features[1].feature_class, FeatureClass::ClosedPocket);
    EXPECT_TRUE(free.features[2].through);
    EXPECT_DOUBLE_EQ(free.features[2].floor_z_mm, -30);
    EXPECT_NEAR(volumeMm3(free), volumeMm3(whole), 1e-6);
    ASSERT_EQ(free.unplanned.size(), 2U);
    EXPECT_TRUE(free.unplanned[0].reason == Reason::Holding);
    // The hole alone goes into it.
    EXPECT_NEAR(area(heldSection(oneLayer(), free, held, kTol)),
                area(kStock) - area(whole.features[2].target), 1e-6);
}

TEST(WithHeldStock, StopsTheOutsideAloneWhereSidesAreHeld) {
    const FeatureSet whole = cutThrough();
    const HeldStock held{-23, -30, false};
    const FeatureSet free = withHeldStock(whole, held, kTol);
    ASSERT_EQ(free.features.size(), 3U);
    EXPECT_DOUBLE_EQ(free.features[0].floor_z_mm, -23);
    EXPECT_FALSE(free.features[0].through);
    EXPECT_DOUBLE_EQ(free.features[1].floor_z_mm, -30);
    EXPECT_TRUE(free.features[1].through);
    EXPECT_NEAR(volumeMm3(free), volumeMm3(whole), 1e-6);
    EXPECT_NEAR(area(heldSection(oneLayer(), free, held, kTol)),
                area(kStock) - area(whole.features[1].target) - area(whole.features[2].target), 1e-6);
}

TEST(WithHeldStock, TakesFeaturesAwayThatLieInItAndThoseBelow) {
    FeatureSet found = cutThrough();
    found.features.resize(1);
    found.features[0].floor_z_mm = -24;
    found.features[0].through = false;
    Feature below = found.features[0];
    below.id = "S1.F2";
    below.parents = {"S1.F1"};
    below.top_z_mm = -24;
    below.floor_z_mm = -30;
    below.volume_mm3 = 6 * below.area_mm2;
    below.open_length_mm = 0;  // waits for one that stops
    found.features.push_back(below);
    const FeatureSet free = withHeldStock(found, {-23, -30, false}, kTol);
    ASSERT_EQ(free.features.size(), 1U);
    EXPECT_EQ(free.features[0].id, "S1.F1");
    EXPECT_EQ(free.unplanned.size(), 2U);
}

TEST(WithHeldStock, LeavesAllWhereNothingIsHeld) {
    const FeatureSet free = withHeldStock(cutThrough(), {-30, -30, true}, kTol);
    EXPECT_EQ(free.features.size(), 3U);
    EXPECT_TRUE(free.unplanned.empty());
    EXPECT_TRUE(heldSection(oneLayer(), free, {-30, -30, true}, kTol).empty());
}

Plan planned(const StockMargin& margin, std::optional<HoldKind> hold = {}) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.setup.margin = margin;
    request.hold = hold;
    const Part part = readStep(STEPMILL_SOURCE_DIR "/step_parts/rounded_pocket.step").front();
    return planPart(part, request, defaultToolLibrary(), defaultMachine(), kTol);
}

// 100 x 80 x 30 mm: the vise holds what the blank has below it, and a second setup faces that off.
TEST(Holding, GripStockIsNotCutUntilTheNextSetup) {
    const Plan plan = planned({2, 1, 12});
    ASSERT_EQ(plan.setups.size(), 2U);
    const PlannedSetup& first = plan.setups.front();
    ASSERT_TRUE(first.clamping.isVise()) << first.clamping.text;
    EXPECT_NEAR(first.clamping.held_mm, 11, 1e-9);
    const double held_z_mm = first.setup.stock_bbox_mm.min().z() + first.clamping.held_mm;
    ASSERT_FALSE(first.operations.empty());
    for (const Operation& operation : first.operations)
        for (const Move& move : operation.path.moves)
            EXPECT_GE(move.to.z(), held_z_mm - 1e-9) << operation.id;
    EXPECT_TRUE(plan.setups.back().clamping.isVise()) << plan.setups.back().clamping.text;
    EXPECT_TRUE(plan.complete(kTol));
    EXPECT_LT(plan.balance.gapShare(), 1e-3);
}

TEST(Holding, ASkinThatStaysIsNamed) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.setup.margin = {2, 0, 0};
    request.setup.axes = {Vec3::UnitZ()};
    request.hold = HoldKind::Skin;
    const Part part = readStep(STEPMILL_SOURCE_DIR "/step_parts/rounded_pocket.step").front();
    const Plan plan = planPart(part, request, defaultToolLibrary(), defaultMachine(), kTol);
    const auto& left = plan.balance.residual_by_reason;
    const auto skin = std::find_if(left.begin(), left.end(),
                                   [](const ReasonVolume& entry) { return entry.reason == Reason::Holding; });
    ASSERT_NE(skin, left.end());
    EXPECT_NEAR(skin->volume_mm3, (104 * 84 - 100 * 80) * kSkinMm, 1e-3);
    EXPECT_FALSE(plan.complete(kTol));
    EXPECT_TRUE(std::any_of(plan.warnings.begin(), plan.warnings.end(),
                            [](const Warning& warning) { return warning.code == "held-stock"; }));
}

}  // namespace
}  // namespace stepmill
