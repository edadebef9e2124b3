// Real parts of which a hole moved: as good as planned from scratch, in a part of the time.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sample_parts.h"
#include "solids.h"
#include "stepmill/core/file.h"
#include "stepmill/part/part_shape.h"
#include "support/expected_outcomes.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

/// A hole along z of a part, and where it goes.
struct MovedHole {
    std::string part;
    Vec3 bottom_mm;
    double diameter_mm = 0;
    double depth_mm = 0;
    double to_x_mm = 0;
};

std::string holeName(const testing::TestParamInfo<MovedHole>& info) {
    return testName(expectedRows({info.param.part}).front());
}
void PrintTo(const MovedHole& hole, std::ostream* out) {
    *out << hole.part;
}

TopoDS_Shape pin(const MovedHole& hole, double x_mm) {
    const double bottom_mm = hole.bottom_mm.z();
    return cylinder(x_mm, hole.bottom_mm.y(), hole.diameter_mm, bottom_mm, bottom_mm + hole.depth_mm);
}

std::string revised(const std::string& file, const MovedHole& hole) {
    const TopoDS_Shape solid = readStep(file).front().shape->solid;
    const TopoDS_Shape filled = assemble(solid, {pin(hole, hole.bottom_mm.x())}, {});
    return sampleStepText({"revised", "a hole moved", assemble(filled, {}, {pin(hole, hole.to_x_mm)})});
}

class RevisedPart : public testing::TestWithParam<MovedHole> {
  protected:
    std::string path(const std::string& name) const { return folder_.path() + "/" + name; }

    static ProgramRun stepmill(Words words) {
        words.insert(words.begin(), stepmillBinary());
        ProgramRun run = runProgram(words);
        EXPECT_LE(run.exit_code, 1) << run.err;
        return run;
    }
    Json planOf(const std::string& job) const { return Json::parse(readFile(path(job) + "/plan.json")); }

    TemporaryFolder folder_;
};

/// What is left of stock minus part [mm3].
double leftMm3(const Json& plan) {
    const Json& books = plan["volume_balance"];
    return books["residual_mm3"].get<double>() + books["unreachable_mm3"].get<double>();
}

TEST_P(RevisedPart, TakesLessToPlanAndIsAsGood) {
    const ExpectedOutcome part = expectedRows({GetParam().part}).front();
    STEPMILL_NEEDS_PART(part);
    writeFile(path("b.step"), revised(part.path, GetParam()));
    stepmill({"plan", part.path, "-o", path("job")});
    const ProgramRun again = stepmill({"replan", path("job"), "--part", path("b.step"), "-o", path("new")});
    const ProgramRun scratch = stepmill({"plan", path("b.step"), "-o", path("scratch")});
    stepmill({"verify", path("new"), "--part", path("b.step")});
    RecordProperty("replan_share", std::to_string(again.cpu_s / scratch.cpu_s));

    const Json plan = planOf("new");
    const Json anew = planOf("scratch");
    EXPECT_LE(plan["totals"]["motion_time_s"].get<double>(),
              1.02 * anew["totals"]["motion_time_s"].get<double>());
    EXPECT_NEAR(leftMm3(plan), leftMm3(anew),
                1e-3 * plan["volume_balance"]["stock_minus_part_mm3"].get<double>());
    // What was weighed before is told as it was then.
    const Json before = planOf("job");
    EXPECT_EQ(plan["setup_axes"], before["setup_axes"]);
    EXPECT_EQ(plan.value("assignment", Json()), before.value("assignment", Json()));
    EXPECT_EQ(plan.value("setup_choices", Json()), before.value("setup_choices", Json()));
    const Json change = Json::parse(readFile(path("new") + "/replan.json"));
    for (const Json& feature : change["features"])
        EXPECT_NE(feature["change"], "new") << feature["id"];
}

INSTANTIATE_TEST_SUITE_P(Parts, RevisedPart,
                         testing::Values(MovedHole{"machined/hole_model.stp", {0, -20, 0}, 5, 20, 3}),
                         holeName);
INSTANTIATE_TEST_SUITE_P(Slow, RevisedPart,
                         testing::Values(MovedHole{
                             "nist/nist_ctc_01_asme1_rd.stp", {-160, 45, -50}, 25, 50, -150}),
                         holeName);

}  // namespace
}  // namespace stepmill::test
