// What is still there keeps its name and its place.

#include "stepmill/plan/earlier_plan.h"

#include <gtest/gtest.h>

#include "plan/operations/earlier_operations.h"
#include "plan/order/order_operations.h"

namespace stepmill {
namespace {

Region square(double x_mm, double y_mm, double side_mm) {
    return makeRectangle({x_mm, y_mm}, {x_mm + side_mm, y_mm + side_mm});
}

Feature pocket(const std::string& id, const Region& target, double floor_z_mm = -5) {
    Feature feature;
    feature.id = id;
    feature.setup_id = "S1";
    feature.floor_z_mm = floor_z_mm;
    feature.target = target;
    feature.area_mm2 = area(target);
    return feature;
}

EarlierFeature earlier(const std::string& id, const Region& target, double floor_z_mm = -5) {
    return {id, FeatureClass::ClosedPocket, 0, floor_z_mm, target};
}

/// Two pockets side by side.
EarlierSetup twoPockets() {
    EarlierSetup setup;
    setup.id = "S1";
    setup.features = {earlier("S1.F1", square(0, 0, 10)), earlier("S1.F2", square(20, 0, 8))};
    return setup;
}

TEST(EarlierPlan, GivesNoOtherNamesWhereNothingChanged) {
    const FeatureSet found{{pocket("S1.F1", square(0, 0, 10)), pocket("S1.F2", square(20, 0, 8))}, {}};
    EXPECT_TRUE(namesFrom(twoPockets(), found, Tolerances()).empty());
}

TEST(EarlierPlan, KeepsNamesWhereNumbersShifted) {
    const FeatureSet found{{pocket("S1.F1", square(40, 0, 10), -7), pocket("S1.F2", square(0, 0, 10)),
                            pocket("S1.F3", square(20, 0, 8))},
                           {}};
    const FeatureNames names = namesFrom(twoPockets(), found, Tolerances());
    EXPECT_EQ(names, (FeatureNames{{"S1.F1", "S1.F3"}, {"S1.F2", "S1.F1"}, {"S1.F3", "S1.F2"}}));
}

TEST(EarlierPlan, KnowsAFeatureThatIsDeeperOrHasMoved) {
    const FeatureSet found{{pocket("S1.F1", square(22, 5, 8)), pocket("S1.F2", square(0, 0, 10), -6)}, {}};
    const FeatureNames names = namesFrom(twoPockets(), found, Tolerances());
    EXPECT_EQ(names, (FeatureNames{{"S1.F1", "S1.F2"}, {"S1.F2", "S1.F1"}}));
}

TEST(EarlierPlan, KnowsAFeatureThatMovedFarByItsSize) {
    const FeatureSet found{{pocket("S1.F1", square(60, 40, 8)), pocket("S1.F2", square(0, 0, 10))}, {}};
    EXPECT_EQ(namesFrom(twoPockets(), found, Tolerances()),
              (FeatureNames{{"S1.F1", "S1.F2"}, {"S1.F2", "S1.F1"}}));
}

TEST(EarlierPlan, KeepsTheNumberOfWhatIsKnownByNameAlone) {
    EarlierSetup setup = twoPockets();
    setup.features.push_back(earlier("S1.F3", {}));
    const FeatureSet found{{pocket("S1.F1", square(0, 0, 10)), pocket("S1.F2", square(20, 0, 8)),
                            pocket("S1.F3", square(50, 50, 3))},
                           {}};
    EXPECT_TRUE(namesFrom(setup, found, Tolerances()).empty());
}

TEST(EarlierPlan, RenamesBandsAndParents) {
    Feature upper = pocket("S1.F1.1", square(0, 0, 10));
    Feature lower = pocket("S1.F1.2", square(0, 0, 10), -8);
    upper.band = Band{"S1.F1", 1, 2};
    lower.band = Band{"S1.F1", 2, 2};
    lower.parents = {"S1.F1.1"};
    Feature child = pocket("S1.F2", square(1, 1, 3), -9);
    child.parents = {"S1.F1.2"};
    const FeatureSet named = renamed({{upper, lower, child}, {}}, {{"S1.F1", "S1.F2"}, {"S1.F2", "S1.F1"}});
    EXPECT_EQ(named.features[0].id, "S1.F2.1");
    EXPECT_EQ(named.features[1].id, "S1.F2.2");
    EXPECT_EQ(named.features[1].band->of, "S1.F2");
    EXPECT_EQ(named.features[1].parents, (std::vector<std::string>{"S1.F2.1"}));
    EXPECT_EQ(named.features[2].id, "S1.F1");
    EXPECT_EQ(named.features[2].parents, (std::vector<std::string>{"S1.F2.2"}));
}

TEST(EarlierPlan, IsOfAnotherSetupWhereTheAxisIsAnother) {
    stepmill::Setup setup;
    setup.id = "S1";
    setup.axis = Vec3::UnitX();
    EXPECT_EQ(earlierOf(setup, {twoPockets()}), nullptr);
    setup.axis = Vec3::UnitZ();
    EXPECT_NE(earlierOf(setup, {twoPockets()}), nullptr);
}

Operation operationOn(const std::string& feature, const std::string& tool, double x_mm = 0) {
    Operation operation;
    operation.setup_id = "S1";
    operation.feature_id = feature;
    operation.tool_id = tool;
    operation.path.start = Vec3(x_mm, 0, 5);
    return operation;
}

TEST(EarlierOperations, KeepIdsAndNumberWhatIsNewAfterThem) {
    EarlierSetup before = twoPockets();
    before.operations = {{"S1.O1", "S1.F1", "EM8", Role::Rough}, {"S1.O2", "S1.F2", "EM8", Role::Rough}};
    PlannedSetup setup;
    setup.setup.id = "S1";
    const std::vector<EarlierSetup> earlier_setups{before};
    EarlierOperations ids(setup, earlier_setups);
    EXPECT_EQ(ids.idOf(operationOn("S1.F2", "EM8")), "S1.O2");
    EXPECT_EQ(ids.idOf(operationOn("S1.F3", "EM8")), "S1.O3");
    EXPECT_EQ(ids.idOf(operationOn("S1.F2", "EM4")), "S1.O4");
    EXPECT_EQ(ids.idOf(operationOn("S1.F1", "EM8")), "S1.O1");
}

TEST(EarlierOperations, CountFromOneWithoutAnEarlierPlan) {
    PlannedSetup setup;
    setup.setup.id = "S1";
    const std::vector<EarlierSetup> none;
    EarlierOperations ids(setup, none);
    EXPECT_EQ(ids.idOf(operationOn("S1.F2", "EM8")), "S1.O1");
    EXPECT_EQ(ids.idOf(operationOn("S1.F1", "EM8")), "S1.O2");
}

const std::vector<Precedence> kFourFree{
    {"A", {}, 0, {}}, {"B", {}, 0, {}}, {"C", {}, 0, {}}, {"D", {}, 0, {}}};

TEST(ShortestOrder, KeepsAnEarlierOrderAndPutsNewWorkWhereItsToolIs) {
    // By itself the nearest comes next: A, B, C, D of the first tool, then the second tool's.
    const std::vector<Operation> operations{operationOn("A", "T", 0), operationOn("B", "T", 10),
                                            operationOn("C", "U", 20), operationOn("D", "T", 30)};
    const EarlierPlaces places{1, 0, 2, std::nullopt};
    const ShortestOrder shortest = shortestOrder(operations, kFourFree, places);
    EXPECT_EQ(shortest.order, (std::vector<int>{1, 0, 3, 2}));
    EXPECT_EQ(shortest.weighed.front().front().rule, OrderRule::Earlier);
}

TEST(ShortestOrder, SaysNothingOfAnEarlierOrderThatItFindsItself) {
    const std::vector<Operation> operations{operationOn("A", "T", 0), operationOn("B", "T", 10)};
    const std::vector<Precedence> two{kFourFree[0], kFourFree[1]};
    const ShortestOrder shortest = shortestOrder(operations, two, {0, 1});
    EXPECT_EQ(shortest.order, (std::vector<int>{0, 1}));
    EXPECT_EQ(shortest.weighed.front().size(), 3U);
}

TEST(ShortestOrder, CutsANewParentBeforeItsEarlierChild) {
    const std::vector<Operation> operations{operationOn("A", "T", 0), operationOn("B", "U", 10),
                                            operationOn("C", "T", 20)};
    const std::vector<Precedence> nested{{"A", {}, 0, {}}, {"B", {}, 0, {}}, {"C", {"B"}, 0, {}}};
    const ShortestOrder shortest = shortestOrder(operations, nested, {1, std::nullopt, 0});
    EXPECT_EQ(shortest.order, (std::vector<int>{1, 2, 0}));
}

}  // namespace
}  // namespace stepmill
