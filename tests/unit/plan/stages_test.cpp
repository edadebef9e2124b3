#include "stepmill/plan/stages.h"

#include <set>

#include <gtest/gtest.h>

#include "stepmill/plan/removed.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

Part samplePart(const std::string& name) {
    return readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + name).front();
}

double removable(const stepmill::Setup& setup) {
    return setup.stock.volume_mm3 - setup.part.volume_mm3;
}

/// Of all stages, each cut whole but those left out, counted from 1.
std::vector<std::string> idsOf(SetupWalk walk, const std::set<std::size_t>& left_out) {
    std::vector<std::string> ids;
    while (const std::optional<Stage> stage = walk.next()) {
        ids.push_back(stage->setup.id);
        if (left_out.count(ids.size()) == 0) walk.cut(*stage, featurePrisms(stage->found));
    }
    return ids;
}

TEST(SetupWalk, LeavesThePartWhereEveryFeatureIsCut) {
    const Part part = samplePart("four_setups.step");
    const std::vector<stepmill::Setup> setups = chooseSetups(part, {});
    SetupWalk walk(setups, {}, kTol);
    int count = 0;
    while (const std::optional<Stage> stage = walk.next()) {
        ++count;
        double sum = -stage->air_mm3;
        for (const Feature& feature : stage->found.features)
            sum += feature.volume_mm3;
        for (const Unplanned& unplanned : stage->found.unplanned)
            sum += unplanned.volume_mm3;
        EXPECT_NEAR(sum, removable(stage->setup), kTol.volume_share * removable(setups.front()))
            << stage->setup.id;
        walk.cut(*stage, featurePrisms(stage->found));
    }
    EXPECT_EQ(count, 4);
    EXPECT_NEAR(walk.left().volume_mm3, part.volume_mm3, 1e-5 * part.volume_mm3);
}

TEST(SetupWalk, LeavesOutAChosenSetupWithNothingToCut) {
    std::vector<stepmill::Setup> setups = chooseSetups(samplePart("plate_with_holes.step"), {});
    ASSERT_EQ(setups.size(), 1U);
    SetupRequest below;
    below.axes = {-Vec3::UnitZ()};
    setups.push_back(chooseSetups(setups.front().part, below).front());
    EXPECT_EQ(idsOf(SetupWalk(setups, {}, kTol), {}).size(), 2U);
    setups.back().chosen = true;
    EXPECT_EQ(idsOf(SetupWalk(setups, {}, kTol), {}).size(), 1U);
}

TEST(SetupWalk, GivesTheIdOfASetupLeftOutToTheNext) {
    const std::vector<std::string> ids =
        idsOf(SetupWalk(chooseSetups(samplePart("four_setups.step"), {}), {}, kTol), {2});
    EXPECT_EQ(ids, (std::vector<std::string>{"S1", "S2", "S2", "S3"}));
}

PlannedFeature pocket() {
    PlannedFeature planned;
    planned.feature.target = makeRectangle(Vec2(0, 0), Vec2(40, 20));
    planned.feature.area_mm2 = 800;
    planned.feature.volume_mm3 = 8000;
    planned.feature.floor_z_mm = -10;
    planned.sequence.floor_z_mm = -10;
    planned.sequence.steps.emplace_back();
    return planned;
}

Residual leaving(const Region& region, double height_mm) {
    Residual residual;
    residual.region = region;
    residual.area_mm2 = area(region);
    residual.volume_mm3 = residual.area_mm2 * height_mm;
    return residual;
}

TEST(RemovedBy, TakesNothingWithoutATool) {
    PlannedFeature planned = pocket();
    planned.sequence.steps.clear();
    EXPECT_TRUE(removedBy(planned, kTol).empty());
}

TEST(RemovedBy, LeavesResidualsOverTheirHeight) {
    PlannedFeature planned = pocket();
    planned.sequence.residual = {leaving(makeRectangle(Vec2(0, 0), Vec2(5, 5)), 10)};
    EXPECT_NEAR(volumeOf(removedBy(planned, kTol)), 8000 - 250, 1e-6);
    planned.sequence.residual = {leaving(planned.feature.target, 2)};
    EXPECT_NEAR(volumeOf(removedBy(planned, kTol)), 8000 - 1600, 1e-6);
}

TEST(RemovedBy, EndsWhereTheToolsDo) {
    PlannedFeature planned = pocket();
    planned.sequence.floor_z_mm = -7;
    planned.sequence.residual = {leaving(makeRectangle(Vec2(0, 0), Vec2(5, 5)), 7),
                                 leaving(planned.feature.target, 3)};
    EXPECT_NEAR(volumeOf(removedBy(planned, kTol)), (800 - 25) * 7, 1e-6);
}

TEST(RemovedBy, ReachesDownWhereMoreStaysBelowThanIsCut) {
    PlannedFeature planned = pocket();
    planned.sequence.floor_z_mm = -4;
    planned.sequence.residual = {leaving(planned.feature.target, 6)};
    EXPECT_NEAR(volumeOf(removedBy(planned, kTol)), 800 * 4, 1e-6);
    planned.sequence.floor_z_mm = -5;
    planned.sequence.residual = {leaving(makeRectangle(Vec2(0, 0), Vec2(5, 5)), 5),
                                 leaving(planned.feature.target, 5)};
    EXPECT_NEAR(volumeOf(removedBy(planned, kTol)), (800 - 25) * 5, 1e-6);
}

}  // namespace
}  // namespace stepmill
