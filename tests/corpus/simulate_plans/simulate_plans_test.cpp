// Whole plans of the sample parts, simulated on height maps made from the solids' facets.

#include <filesystem>

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <BRep_Tool.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/part/part_shape.h"
#include "stepmill/plan/plan.h"
#include "support/height_map.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

constexpr double kCellMm = 0.2;
/// Half a cell's diagonal at the wall, and the same at the cutter's rim.
constexpr double kRimMm = 0.3;
/// Facets lie no farther than this from the solid [mm].
constexpr double kFacetMm = 0.005;
/// Cells under the part's heights by more than this are cut into [mm].
constexpr double kGougeMm = 0.02;
/// A rest operation may run this share of its level feeds over ground that is down already: it lands beside
/// the wall by the machine's inside clearance and feeds over, which is much of its way where a millimetre is
/// left in a corner, and less is left there with an allowance.
constexpr double kAirShare = 0.65;
/// ... and each time that it comes down so much more: some corners have no more than half a millimetre left
/// [mm].
constexpr double kLeadMm = 0.5;

using test::kTol;

/// The finished part as the spindle sees it.
void raisePart(HeightMap& map, const Setup& setup) {
    const TopoDS_Shape& solid = setup.part.shape->solid;
    BRepMesh_IncrementalMesh(solid, kFacetMm, false, 0.1, false);
    for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
        TopLoc_Location location;
        const Handle(Poly_Triangulation) facets =
            BRep_Tool::Triangulation(TopoDS::Face(faces.Current()), location);
        if (facets.IsNull()) continue;
        const auto node = [&](int index) -> Vec3 {
            const gp_Pnt p = facets->Node(index).Transformed(location.Transformation());
            return setup.part_to_setup * Vec3(p.X(), p.Y(), p.Z());
        };
        for (int i = 1; i <= facets->NbTriangles(); ++i) {
            int a = 0;
            int b = 0;
            int c = 0;
            facets->Triangle(i).Get(a, b, c);
            map.raise(node(a), node(b), node(c));
        }
    }
}

Box2 mapBox(const Setup& setup) {
    Box2 box;
    box.extend(setup.stock_bbox_mm.min().head<2>());
    box.extend(setup.stock_bbox_mm.max().head<2>());
    return box;
}

/// Volume of what was cut deeper than the part allows, rims and walls left out [mm3].
double gouged(const HeightMap& stock, const HeightMap& part) {
    const std::vector<double> allowed = part.lowestWithin(kRimMm);
    double sum = 0;
    for (std::size_t i = 0; i < allowed.size(); ++i)
        if (stock.heights()[i] < allowed[i] - kGougeMm) sum += allowed[i] - stock.heights()[i];
    return sum * stock.cellMm2();
}

/// Area of the walls, which bounds what cells at them may be wrong by.
double wallArea(const PlannedSetup& planned) {
    double sum = 0;
    for (const PlannedFeature& feature : planned.features)
        sum += perimeter(feature.feature.target) * feature.feature.depth_mm();
    return sum;
}

/// How often the cutter begins to be fed on the level, having come down.
int levelWays(const Toolpath& path) {
    int ways = 0;
    bool goes_on = false;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const bool level = move.kind != MoveKind::Rapid && move.to.z() == from.z();
        ways += level && !goes_on ? 1 : 0;
        goes_on = level;
        from = move.to;
    }
    return ways;
}

void expectCutsWhatItSays(const Plan& planned, const char* name) {
    double removed = 0;
    double margin = 0;
    for (const PlannedSetup& setup : planned.setups) {
        const double bottom = setup.setup.stock_bbox_mm.min().z();
        HeightMap part(mapBox(setup.setup), kCellMm, bottom);
        raisePart(part, setup.setup);
        HeightMap stock(mapBox(setup.setup), kCellMm, bottom);
        const Box2 box = mapBox(setup.setup);
        stock.raise(makeRectangle(box.min(), box.max()), setup.setup.stock_bbox_mm.max().z());
        for (const Operation& operation : setup.operations) {
            const ToolAssembly& tool = planned.library.tool(operation.tool_id);
            const HeightMap::Cut cut = stock.run(operation.path, profileOf(tool), kRimMm);
            removed += cut.removed_mm3;
            fmt::print(
                "{:<18} {:<7} {:<7} {:<6} {:<10} {:>8.0f} mm3 {:>8.0f} mm fed {:>5.1f} % air, level {:>5.1f} "
                "%, longest "
                "{:>5.1f} mm, marked {:>5.1f} %, {:>6.1f} s\n",
                name, operation.id, operation.feature_id, toString(operation.role), operation.tool_id,
                cut.removed_mm3, cut.feed_mm, 100 * cut.air_mm / cut.feed_mm,
                100 * cut.level_air_mm / std::max(1.0, cut.level_mm), cut.longest_air_mm,
                100 * operation.path.totals.feed_air_length_mm / operation.path.totals.cut_length_mm,
                operation.path.totals.time_s());
            EXPECT_EQ(cut.rapid_hits, 0) << operation.id << " first at " << cut.first_hit.transpose();
            EXPECT_GT(cut.removed_mm3, 0) << operation.id;
            // Leads and overlaps of a finishing pass run over ground that is down; a form cutter's tip does
            // where it cuts with its side.
            const double air_share =
                operation.role == Role::Finish || operation.role == Role::Form ? 1 : kAirShare;
            // The cells tell to one of them where each way of a few millimetres begins to cut.
            const double leads_mm = (kCellMm + kLeadMm) * levelWays(operation.path);
            EXPECT_LE(cut.level_air_mm, air_share * cut.level_mm + leads_mm) << operation.id;
        }
        EXPECT_EQ(gouged(stock, part), 0) << setup.setup.id;
        margin += 0.02 * kCellMm * wallArea(setup);
    }
    fmt::print("{:<18} planned {:.1f} mm3, removed {:.1f} mm3, margin {:.1f} mm3\n", name,
               planned.balance.planned_mm3, removed, margin);
    EXPECT_GT(removed, 0);
    EXPECT_NEAR(removed, planned.balance.planned_mm3, 1e-3 * planned.balance.planned_mm3 + margin);
}

class SimulatePlan : public testing::TestWithParam<const char*> {
  protected:
    static Plan plan(const FinishAllowance& finish, const std::optional<FinishAllowance>& roughing = {},
                     double scallop_mm = 0) {
        const Part part =
            readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + GetParam() + ".step").front();
        PlanRequest request;
        request.sequence.material = "aluminium";
        request.sequence.finish = finish;
        request.roughing = roughing;
        request.scallop_mm = scallop_mm;
        return planPart(part, request, defaultToolLibrary(), defaultMachine(), kTol);
    }
};

TEST_P(SimulatePlan, CutsWhatItSaysAndNothingElse) {
    expectCutsWhatItSays(plan({}), GetParam());
}

TEST_P(SimulatePlan, CutsTheSameWithAFinishingAllowance) {
    expectCutsWhatItSays(plan({0.3, 0.2}), GetParam());
}

const auto kSampleName = [](const auto& parameter) { return std::string(parameter.param); };

INSTANTIATE_TEST_SUITE_P(SampleParts, SimulatePlan,
                         testing::Values("bossed_pocket", "butterfly_pocket", "die_cavity", "four_setups",
                                         "nested_pockets", "open_slots", "plate_with_holes",
                                         "pocket_without_bosses", "rounded_pocket", "shoulder_block"),
                         kSampleName);
INSTANTIATE_TEST_SUITE_P(Slow, SimulatePlan, testing::Values("die_with_islands"), kSampleName);

class SimulateRoughing : public SimulatePlan {};

TEST_P(SimulateRoughing, CutsWhatItSaysAndNothingElse) {
    // Whole cells, so that upright walls stay between them.
    expectCutsWhatItSays(plan({}, FinishAllowance{2 * kCellMm, 2 * kCellMm}), GetParam());
}

INSTANTIATE_TEST_SUITE_P(SampleParts, SimulateRoughing,
                         testing::Values("die_cavity", "nested_pockets", "open_slots"), kSampleName);
INSTANTIATE_TEST_SUITE_P(Slow, SimulateRoughing, testing::Values("mold_core"), kSampleName);

class SimulateForms : public SimulatePlan {};

TEST_P(SimulateForms, CutWhatTheySayAndNothingElse) {
    const Plan planned = plan({}, {}, 0.02);
    ASSERT_TRUE(planned.setups.front().form) << "a leaning wall that no form cutter finishes";
    expectCutsWhatItSays(planned, GetParam());
}

INSTANTIATE_TEST_SUITE_P(SampleParts, SimulateForms, testing::Values("die_cavity"), kSampleName);
INSTANTIATE_TEST_SUITE_P(Slow, SimulateForms, testing::Values("die_with_islands"), kSampleName);

/// Flatter than this ground is shallow, and less than this it is level [tangent].
constexpr double kShallow = 0.2;
constexpr double kLevel = 0.01;
/// Slopes are taken over so many cells to either side.
constexpr int kSlopeCells = 5;

/// Heights of what stands over ground of the part that is neither level nor steep, ascending [mm].
std::vector<double> leftOverShallow(const HeightMap& stock, const HeightMap& part) {
    const Raster& raster = part.raster();
    std::vector<double> left;
    for (int row = kSlopeCells; row + kSlopeCells < raster.rows(); ++row)
        for (int column = kSlopeCells; column + kSlopeCells < raster.columns(); ++column) {
            const auto height = [&](int by_x, int by_y) {
                return part.heights()[raster.index(column + by_x, row + by_y)];
            };
            const double over_mm = 2 * kSlopeCells * kCellMm;
            const double slope = std::hypot(height(kSlopeCells, 0) - height(-kSlopeCells, 0),
                                            height(0, kSlopeCells) - height(0, -kSlopeCells)) /
                                 over_mm;
            if (slope >= kLevel && slope <= kShallow)
                left.push_back(stock.heights()[raster.index(column, row)] - height(0, 0));
        }
    std::sort(left.begin(), left.end());
    return left;
}

class SimulateSurface : public SimulatePlan {};

/// Lines over the dome leave ridges of a scallop over the skin of its bands: what stands on it is as high
/// nearly everywhere. Passes along its levels left it 0.08 mm high where they lay far apart.
TEST_P(SimulateSurface, LinesLeaveADomeEven) {
    constexpr double kScallopMm = 0.02;
    const Plan planned = plan({}, {}, kScallopMm);
    const PlannedSetup& setup = planned.setups.front();
    const Box2 box = mapBox(setup.setup);
    const double bottom = setup.setup.stock_bbox_mm.min().z();
    HeightMap solid(box, kCellMm, bottom);
    raisePart(solid, setup.setup);
    HeightMap stock(box, kCellMm, bottom);
    stock.raise(makeRectangle(box.min(), box.max()), setup.setup.stock_bbox_mm.max().z());
    for (const Operation& operation : setup.operations)
        stock.run(operation.path, profileOf(planned.library.tool(operation.tool_id)), kRimMm);
    EXPECT_EQ(gouged(stock, solid), 0);
    const std::vector<double> left = leftOverShallow(stock, solid);
    ASSERT_GT(left.size(), 10000U);
    EXPECT_LE(left[left.size() * 95 / 100] - left[left.size() / 10], kScallopMm);
}

INSTANTIATE_TEST_SUITE_P(Slow, SimulateSurface, testing::Values("mold_core"), kSampleName);

/// The shop's drills as the simulation knows them: with their points, and one for each blind hole there is.
ToolLibrary libraryWithSmallDrills() {
    ToolLibrary library = defaultToolLibrary();
    for (const double diameter_mm : {2.0, 3.0}) {
        ToolAssembly drill = library.tool("DR5");
        drill.id = fmt::format("DR{:g}", diameter_mm);
        drill.number = 900 + static_cast<int>(diameter_mm);
        drill.diameter_mm = drill.shank.diameter_mm = diameter_mm;
        for (CuttingData& cutting : drill.cutting)
            cutting.step_down_mm = diameter_mm;
        library.tools.push_back(std::move(drill));
    }
    return library;
}

TEST(SimulateHoles, DrillsStayInsideThePointsOfHoleModel) {
    const std::filesystem::path file =
        std::filesystem::path(STEPMILL_SOURCE_DIR) / "../shared/parts/machined/hole_model.stp";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.scallop_mm = 0;
    const Plan planned =
        planPart(readStep(file.string()).front(), request, libraryWithSmallDrills(), defaultMachine(), kTol);
    const PlannedSetup& setup = planned.setups.front();
    const double bottom = setup.setup.stock_bbox_mm.min().z();
    const Box2 box = mapBox(setup.setup);
    HeightMap part(box, kCellMm, bottom);
    raisePart(part, setup.setup);
    HeightMap stock(box, kCellMm, bottom);
    stock.raise(makeRectangle(box.min(), box.max()), setup.setup.stock_bbox_mm.max().z());
    int drilled = 0;
    for (const Operation& operation : setup.operations) {
        const ToolAssembly& tool = planned.library.tool(operation.tool_id);
        const HeightMap::Cut cut = stock.run(operation.path, profileOf(tool), kRimMm);
        EXPECT_EQ(cut.rapid_hits, 0) << operation.id << " first at " << cut.first_hit.transpose();
        if (operation.role == Role::Drill) drilled += operation.holes;
    }
    EXPECT_GE(drilled, 19);
    EXPECT_EQ(gouged(stock, part), 0);
}

/// Every setup of a part tapped by the table, its taps as wide as the thread's core: what they cut beyond is
/// the thread.
/// \return  how many holes were tapped
int tappedHoles(const std::filesystem::path& file, const HoleTable& table) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.holes = table;
    const ToolLibrary library =
        readToolLibrary(std::string(STEPMILL_SOURCE_DIR) + "/samples/shop_with_taps_tools.json");
    const Plan planned = planPart(readStep(file.string()).front(), request, library, defaultMachine(), kTol);
    int tapped = 0;
    for (const PlannedSetup& setup : planned.setups) {
        const Box2 box = mapBox(setup.setup);
        HeightMap stock(box, kCellMm, setup.setup.stock_bbox_mm.min().z());
        stock.raise(makeRectangle(box.min(), box.max()), setup.setup.stock_bbox_mm.max().z());
        for (const Operation& operation : setup.operations) {
            ToolAssembly tool = planned.library.tool(operation.tool_id);
            if (operation.thread) tool.diameter_mm = coreRange(operation.thread->thread).least_mm;
            const HeightMap::Cut cut = stock.run(operation.path, profileOf(tool), kRimMm);
            EXPECT_EQ(cut.rapid_hits, 0) << operation.id << " first at " << cut.first_hit.transpose();
            if (!operation.thread) continue;
            EXPECT_EQ(cut.removed_mm3, 0) << operation.id << " comes into a hole that is not made";
            tapped += operation.holes;
        }
    }
    return tapped;
}

TEST(SimulateHoles, TapsMeetNothingButTheWallsOfHolesThatAreMade) {
    const std::filesystem::path source = STEPMILL_SOURCE_DIR;
    EXPECT_EQ(tappedHoles(source / "step_parts/plate_with_holes.step",
                          readHoleTable(source / "samples/plate_holes.json")),
              10);
    const std::filesystem::path model = source / "../shared/parts/machined/hole_model.stp";
    if (!std::filesystem::exists(model)) GTEST_SKIP() << model << " is not here";
    // One of them blind, drilled and then milled flat.
    EXPECT_EQ(tappedHoles(model, holeTableFromText(R"({"format": 1, "unit": "mm", "holes": [
        {"diameter": {"min": 4.9, "max": 5.1}, "make": "tap", "thread": "M6"}]})",
                                                   "holes.json")),
              2);
}

}  // namespace
}  // namespace stepmill::test
