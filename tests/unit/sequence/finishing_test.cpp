// Steps that leave an allowance and steps that take it off.

#include <gtest/gtest.h>

#include "support/sample_feature.h"
#include "support/told.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

using test::kTol;

ToolSequence sequenced(const Feature& feature, const std::vector<ToolAssembly>& tools,
                       const FinishAllowance& finish) {
    SequenceOptions options = inAluminium();
    options.finish = finish;
    return sequenceTools(feature, makeLibrary(tools), makeMachine(), options, kTol);
}

double lowest(const Toolpath& path) {
    double z = 0;
    for (const Move& move : path.moves)
        z = std::min(z, move.to.z());
    return z;
}

using Roles = std::vector<std::pair<std::string, Role>>;

Roles rolesOf(const ToolSequence& sequence) {
    Roles roles;
    for (const SequenceStep& step : sequence.steps)
        roles.emplace_back(step.tool_id, step.role);
    return roles;
}

/// 70 x 50 mm, 12 deep, corners of 4: 16 mm roughs, 6 mm does the corners.
Feature pocketForTwo() {
    return makePocket(makeRoundedRectangle({0, 0}, {70, 50}, 4), 12);
}

TEST(Finishing, IsNoneUnlessAskedFor) {
    const ToolSequence sequence = sequenced(pocketForTwo(), {makeMill(16), makeMill(6)}, {});
    EXPECT_EQ(rolesOf(sequence), (Roles{{"EM16", Role::Rough}, {"EM6", Role::Rest}}));
    for (const SequenceStep& step : sequence.steps)
        EXPECT_FALSE(step.leaves.any());
}

TEST(Finishing, EveryToolDoesItsFloorAndTheLastOneTheWalls) {
    const ToolSequence plain = sequenced(pocketForTwo(), {makeMill(16), makeMill(6)}, {});
    const ToolSequence sequence = sequenced(pocketForTwo(), {makeMill(16), makeMill(6)}, {0.3, 0.2});
    EXPECT_EQ(sequence.no_allowance, "");
    EXPECT_EQ(rolesOf(sequence), (Roles{{"EM16", Role::Rough},
                                        {"EM16", Role::Finish},
                                        {"EM6", Role::Rest},
                                        {"EM6", Role::Finish},
                                        {"EM6", Role::Finish}}));
    const std::vector<double> floors = {-11.8, -12, -11.8, -12, -12};
    for (std::size_t i = 0; i < floors.size(); ++i) {
        const SequenceStep& step = sequence.steps[i];
        EXPECT_NEAR(lowest(step.path), floors[i], 1e-9) << i;
        EXPECT_NEAR(step.leaves.floors_mm, floors[i] + 12, 1e-9) << i;
        EXPECT_EQ(step.leaves.walls_mm, i < 4 ? 0.3 : 0.0) << i;
        EXPECT_GE(step.proof.least_clearance_mm, 0) << i;
        EXPECT_TRUE(step.proof.rapids_clear) << i;
    }
    // The choice and what stays are those without an allowance; the time is what it really takes.
    EXPECT_EQ(sequence.lower_bound_s, plain.lower_bound_s);
    EXPECT_EQ(sequence.residual.size(), plain.residual.size());
    EXPECT_GT(sequence.time_s, plain.time_s);
}

TEST(Finishing, LeavesTheAllowanceOnWalls) {
    const Feature pocket = pocketForTwo();
    const ToolSequence sequence = sequenced(pocket, {makeMill(16), makeMill(6)}, {0.3, 0});
    ClearingTask bare;
    bare.target = pocket.target;
    bare.obstruction = pocket.obstruction;
    bare.floor_z_mm = pocket.floor_z_mm;
    bare.retract_z_mm = 5;
    for (const SequenceStep& step : sequence.steps) {
        const double radius = step.tool_id == "EM16" ? 8 : 3;
        const double clear_mm = prove(step.path, bare, radius, kTol).least_clearance_mm;
        EXPECT_NEAR(clear_mm, step.leaves.walls_mm, kTol.gouge_mm);
    }
}

TEST(Finishing, ThroughFeaturesHaveNoFloorToFinish) {
    Feature window = makePocket(makeRoundedRectangle({0, 0}, {40, 30}, 5), 8, FeatureClass::ThroughPocket);
    window.through = true;
    const ToolSequence sequence = sequenced(window, {makeMill(10)}, {0.3, 0.2});
    EXPECT_EQ(rolesOf(sequence), (Roles{{"EM10", Role::Rough}, {"EM10", Role::Finish}}));
    EXPECT_NEAR(lowest(sequence.steps[0].path), -8, 1e-9);
    EXPECT_EQ(sequence.no_allowance, "");
}

TEST(Finishing, DrilledHolesHaveNone) {
    const Feature hole = makePocket(makeCircle({0, 0}, 4), 10, FeatureClass::HoleBlind);
    Feature through = hole;
    through.feature_class = FeatureClass::HoleThrough;
    through.through = true;
    const ToolSequence sequence = sequenced(through, {makeDrill(8)}, {0.3, 0.2});
    EXPECT_EQ(rolesOf(sequence), (Roles{{"DR8", Role::Drill}}));
    EXPECT_EQ(sequence.no_allowance, "");
}

TEST(Finishing, IsGivenUpWhereTheToolWouldNotPassBesideTheAllowance) {
    // Two rooms joined by a neck of 8.2 mm, which 8 mm passes only without an allowance of 0.3.
    const Region rooms =
        unite(makeRoundedRectangle({0, 0}, {40, 40}, 5), makeRoundedRectangle({60, 0}, {100, 40}, 5), kTol);
    const Feature feature = makePocket(unite(rooms, makeRectangle({35, 16}, {65, 24.2}), kTol), 6);
    const ToolSequence sequence = sequenced(feature, {makeMill(8)}, {0.3, 0.2});
    EXPECT_TRUE(test::tells(sequence.no_allowance, {"walls", "EM8", "pass"}));
    EXPECT_EQ(rolesOf(sequence), (Roles{{"EM8", Role::Rough}, {"EM8", Role::Finish}}));
    EXPECT_EQ(sequence.steps[0].leaves, (FinishAllowance{0, 0.2}));
}

TEST(Finishing, IsGivenUpWhereItIsMoreThanAStepOverOrStepDown) {
    const ToolSequence sequence = sequenced(pocketForTwo(), {makeMill(16), makeMill(6)}, {4, 0});
    EXPECT_TRUE(test::tells(sequence.no_allowance, {"walls", "step-over", "EM6"}));
    EXPECT_EQ(sequence.steps.size(), 2U);
}

TEST(Finishing, ShallowFloorsAreCutInOne) {
    const Feature shallow = makePocket(makeRoundedRectangle({0, 0}, {70, 50}, 4), 0.4);
    const ToolSequence sequence = sequenced(shallow, {makeMill(6)}, {0, 0.2});
    EXPECT_EQ(sequence.steps.size(), 1U);
    EXPECT_TRUE(test::tells(sequence.no_allowance, {"floor", "0.4 mm"}));
}

TEST(Finishing, OtherWaysThroughTheDagHaveItToo) {
    const Machine machine = makeMachine();
    const ToolLibrary library = makeLibrary({makeMill(16), makeMill(6)});
    SequenceOptions options = inAluminium();
    options.finish = {0.3, 0.2};
    const ToolSequence sequence = sequenceTools(pocketForTwo(), library, machine, options, kTol);
    const std::vector<SequenceChoice> choices = choicesOf(sequence);
    ASSERT_GT(choices.size(), 1U);
    const ToolSequence other = withChoice(sequence, 1);
    EXPECT_EQ(other.steps.back().role, Role::Finish);
    EXPECT_EQ(withChoice(other, 0).steps.size(), sequence.steps.size());
}

}  // namespace
}  // namespace stepmill::test
