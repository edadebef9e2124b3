// Sharp edges, and the operations that break them.

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/plan/edge_breaks.h"
#include "stepmill/plan/plan.h"
#include "stepmill/plan/stages.h"
#include "stepmill/planar/region.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

constexpr double kWidthMm = 0.4;

Part sample(const std::string& name) {
    return readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + name).front();
}

ToolLibrary formTools() {
    return readToolLibrary(std::string(STEPMILL_SOURCE_DIR) + "/samples/shop_with_forms_tools.json");
}

Plan planWith(const std::string& name, double width_mm, const ToolLibrary& library) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.break_edges_mm = width_mm;
    return planPart(sample(name), request, library, defaultMachine(), kTol);
}

EdgeBreaks breaksOf(const std::string& name) {
    const Part part = sample(name);
    SetupWalk walk(chooseSetups(part, {}), {}, kTol);
    return {walk.next()->layers, kWidthMm, kTol};
}

double edgesMm(const EdgeBreaks& breaks) {
    double sum_mm = 0;
    for (const EdgeBreaks::FaceEdges& face : breaks.faces())
        for (const Path& edge : face.edges)
            sum_mm += length(edge);
    return sum_mm;
}

double brokenMm3(const Plan& plan) {
    double sum_mm3 = 0;
    for (const PlannedSetup& setup : plan.setups)
        for (const Operation& operation : setup.operations)
            sum_mm3 += operation.breaks_mm3;
    return sum_mm3;
}

TEST(EdgeBreaks, AreTheOutlineOfTheTopTheRimOfThePocketAndItsBoss) {
    const EdgeBreaks breaks = breaksOf("rounded_pocket.step");
    ASSERT_EQ(breaks.faces().size(), 2U);
    EXPECT_EQ(breaks.faces()[0].edges.size(), 2U);
    EXPECT_EQ(breaks.faces()[1].edges.size(), 1U);
    double boundary_mm = 0;
    for (const EdgeBreaks::FaceEdges& face : breaks.faces()) {
        boundary_mm += perimeter(face.face);
        for (const Path& edge : face.edges)
            EXPECT_TRUE(edge.closed());
    }
    EXPECT_NEAR(edgesMm(breaks), boundary_mm, 1e-6);
}

TEST(EdgeBreaks, GoAsWideAsTheyAreHighOverTheirFoot) {
    const EdgeBreaks breaks = breaksOf("rounded_pocket.step");
    const double top_mm = breaks.faces().front().z_mm;
    const double all_mm = edgesMm(breaks);
    EXPECT_NEAR(area(breaks.mayGo(top_mm - 0.1, top_mm)), kWidthMm * all_mm, 1);
    EXPECT_NEAR(area(breaks.mayGo(top_mm - 0.3, top_mm - 0.2)), 0.2 * all_mm, 0.5);
    EXPECT_NEAR(area(breaks.goesHalfWay(top_mm - 0.4, top_mm - 0.2)), 0.1 * all_mm, 0.5);
    EXPECT_TRUE(breaks.mayGo(top_mm - 1, top_mm - 0.2).empty());
}

TEST(EdgeBreaks, TakeAChamferMillAfterAllElse) {
    const Plan plan = planWith("rounded_pocket.step", kWidthMm, formTools());
    const PlannedSetup& setup = plan.setups.front();
    ASSERT_TRUE(setup.edges);
    EXPECT_TRUE(setup.edges->sharp.empty());
    const Operation& last = setup.operations.back();
    EXPECT_EQ(last.role, Role::Form);
    EXPECT_EQ(last.feature_id, edgeGroundId(setup.setup.id));
    const double edge_mm = edgesMm(breaksOf("rounded_pocket.step"));
    EXPECT_NEAR(brokenMm3(plan), edge_mm * kWidthMm * kWidthMm / 2, 0.02 * edge_mm * kWidthMm * kWidthMm);
}

TEST(EdgeBreaks, AreNoPartOfTheVolumeBooks) {
    const Plan plain = planWith("rounded_pocket.step", 0, formTools());
    const Plan broken = planWith("rounded_pocket.step", kWidthMm, formTools());
    EXPECT_FALSE(plain.setups.front().edges);
    EXPECT_EQ(brokenMm3(plain), 0);
    EXPECT_DOUBLE_EQ(plain.balance.planned_mm3, broken.balance.planned_mm3);
    EXPECT_GT(broken.totals.time_s, plain.totals.time_s);
}

TEST(EdgeBreaks, WithoutAMillOfTheirAngleAllAreNamed) {
    const Plan plan = planWith("rounded_pocket.step", kWidthMm, defaultToolLibrary());
    const PlannedSetup& setup = plan.setups.front();
    ASSERT_TRUE(setup.edges);
    double sharp_mm = 0;
    for (const SharpStretch& stretch : setup.edges->sharp)
        sharp_mm += stretch.length_mm;
    EXPECT_NEAR(sharp_mm, edgesMm(breaksOf("rounded_pocket.step")), 0.5);
    EXPECT_TRUE(std::any_of(plan.warnings.begin(), plan.warnings.end(), [](const Warning& warning) {
        return warning.code == "sharp-edge" &&
               warning.text.find("no chamfer mill of 90 degrees") != std::string::npos;
    }));
}

}  // namespace
}  // namespace stepmill
