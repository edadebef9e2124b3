// Posted programs of the sample parts and of real ones, run on a blank that is too large by its tolerance on
// every side.

#include <gtest/gtest.h>

#include <limits>

#include <fmt/format.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/plan/plan.h"
#include "stepmill/post/post.h"
#include "stepmill/post/read_program.h"
#include "support/expected_outcomes.h"
#include "support/height_map.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

constexpr double kToleranceMm = 0.5;
constexpr double kCellMm = 0.2;
/// Half a cell's diagonal in the material, and the same at the cutter's rim.
constexpr double kRimMm = 0.3;
/// A holder that is lower than the material beside it by less rests on rounding [mm].
constexpr double kFlushMm = 0.01;

constexpr std::size_t kAllSetups = std::numeric_limits<std::size_t>::max();

using test::kTol;

/// The blank as it may be, in a setup: the raw box larger on every side; where an earlier setup has cut the
/// top, that is where it was cut.
struct Blank {
    Box2 sides;
    double top_mm = 0;
    double bottom_mm = 0;

    Blank(const Box3& raw, const Setup& setup) {
        Box3 turned;
        for (int corner = 0; corner < 8; ++corner)
            turned.extend(Vec3(setup.part_to_setup * raw.corner(static_cast<Box3::CornerType>(corner))));
        const Vec2 by(kToleranceMm, kToleranceMm);
        sides = Box2(Vec2(turned.min().head<2>()) - by, Vec2(turned.max().head<2>()) + by);
        top_mm = std::abs(turned.max().z()) < kFlushMm ? kToleranceMm : 0;
        bottom_mm = turned.min().z() - kToleranceMm;
    }
};

Toolpath pathOf(const ReadOperation& operation) {
    Toolpath path;
    path.start = operation.start;
    for (const ReadMove& read : operation.moves)
        path.moves.push_back(read.fed.move);
    return path;
}

/// Places where a holder stands in material, looked at from the ends of all moves.
int holderHits(const HeightMap& stock, const Toolpath& path, const ToolAssembly& tool, double top_mm) {
    int hits = 0;
    for (const Move& move : path.moves)
        for (const HolderCylinder& cylinder : tool.holder) {
            const double z_mm = move.to.z() + cylinder.bottom_mm + kFlushMm;
            if (z_mm >= top_mm) continue;
            bool hit = false;
            stock.raster().forDisc(move.to.head<2>(), cylinder.diameter_mm / 2 - kRimMm,
                                   [&](std::size_t cell) { hit = hit || stock.heights()[cell] > z_mm; });
            hits += hit ? 1 : 0;
        }
    return hits;
}

struct Hits {
    int rapids = 0;
    int holders = 0;
    std::string first;
};

/// The programs of a plan's first setups, each on a blank of its own.
Hits run(const Plan& plan, Dialect dialect, std::size_t setups) {
    Hits hits;
    for (std::size_t i = 0; i < std::min(setups, plan.setups.size()); ++i) {
        const PlannedSetup& planned = plan.setups[i];
        const Blank blank(plan.stock.raw_bbox_mm, planned.setup);
        HeightMap stock(grown(blank.sides, 2 * kCellMm), kCellMm, blank.bottom_mm);
        stock.raise(makeRectangle(blank.sides.min(), blank.sides.max()), blank.top_mm);
        for (const PostedProgram& program : post(jobOf(plan, planned), {dialect}))
            for (const ReadOperation& read : readProgram(program.text, program.file, dialect).operations) {
                const auto operation = std::find_if(planned.operations.begin(), planned.operations.end(),
                                                    [&](const Operation& one) { return one.id == read.id; });
                const ToolAssembly& tool = plan.library.tool(operation->tool_id);
                const Toolpath path = pathOf(read);
                const HeightMap::Cut cut = stock.run(path, profileOf(tool), kRimMm);
                if (cut.rapid_hits > 0 && hits.rapids == 0)
                    hits.first = fmt::format("{} at X{:.3f} Y{:.3f} Z{:.3f}", read.id, cut.first_hit.x(),
                                             cut.first_hit.y(), cut.first_hit.z());
                hits.rapids += cut.rapid_hits;
                hits.holders += holderHits(stock, path, tool, blank.top_mm);
            }
    }
    return hits;
}

Machine machineThatEveryPartFits() {
    Machine machine = defaultMachine();
    machine.travel_mm = {4000, 4000, 2000};
    return machine;
}

Plan plan(const std::string& file, double tolerance_mm, const Machine& machine) {
    const Part part = readStep(file).front();
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.setup.stock_tolerance_mm = tolerance_mm;
    return planPart(part, request, defaultToolLibrary(), machine, kTol);
}

std::string fileOf(const std::string& sample) {
    return std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + sample + ".step";
}

void expectNothingMet(const Plan& planned, std::size_t setups) {
    for (const Dialect dialect : {Dialect::LinuxCnc, Dialect::Fanuc, Dialect::Grbl}) {
        const Hits hits = run(planned, dialect, setups);
        EXPECT_EQ(hits.rapids, 0) << toString(dialect) << ": " << hits.first;
        EXPECT_EQ(hits.holders, 0) << toString(dialect);
    }
}

class GrownBlank : public testing::TestWithParam<const char*> {};

TEST_P(GrownBlank, MeetsNoRapidAndNoHolderInAnyDialect) {
    expectNothingMet(plan(fileOf(GetParam()), kToleranceMm, defaultMachine()), kAllSetups);
}

/// What later setups of real parts find is no block any more.
class GrownBlankOf : public testing::TestWithParam<ExpectedOutcome> {};

TEST_P(GrownBlankOf, MeetsNoRapidAndNoHolderInTheFirstSetup) {
    STEPMILL_NEEDS_PART(GetParam());
    expectNothingMet(plan(GetParam().path, kToleranceMm, machineThatEveryPartFits()), 1);
}

const auto kSampleName = [](const auto& parameter) { return std::string(parameter.param); };

// Not mold_core: its second setup comes down where the first has cut from the other side, which a height map
// of one setup does not know.
INSTANTIATE_TEST_SUITE_P(SampleParts, GrownBlank,
                         testing::Values("bossed_pocket", "butterfly_pocket", "die_cavity", "four_setups",
                                         "nested_pockets", "open_slots", "plate_with_holes",
                                         "pocket_without_bosses", "rounded_pocket", "shoulder_block"),
                         kSampleName);
INSTANTIATE_TEST_SUITE_P(Slow, GrownBlank, testing::Values("die_with_islands"), kSampleName);

const auto kPartName = [](const auto& row) { return testName(row.param); };

INSTANTIATE_TEST_SUITE_P(RealParts, GrownBlankOf,
                         testing::ValuesIn(expectedRows({"machined/hole_model.stp"})), kPartName);
INSTANTIATE_TEST_SUITE_P(Slow, GrownBlankOf, testing::ValuesIn(expectedPlans({"machined", "nist"})),
                         kPartName);

/// A plan that takes the blank for exact touches it with rapids: so the test above can fail.
TEST(ExactBlank, IsMetByRapidsWhereItIsLarger) {
    Machine touching = defaultMachine();
    touching.side_clearance_mm = touching.top_clearance_mm = touching.inside_clearance_mm = 0;
    int hits = 0;
    for (const char* name : {"shoulder_block", "open_slots", "four_setups"})
        hits += run(plan(fileOf(name), 0, touching), Dialect::LinuxCnc, kAllSetups).rapids;
    EXPECT_GT(hits, 0);
}

}  // namespace
}  // namespace stepmill::test
