// Posted programs of real parts, all setups one after the other, run by LinuxCNC's interpreter on a stock of
// small cubes: shank, holder, spindle nose and rapids meet neither material nor fixtures.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "stepmill/planar/region_json.h"
#include "support/expected_outcomes.h"
#include "support/plan_json.h"
#include "support/planned_parts.h"
#include "support/program_judge.h"
#include "support/second_reader.h"
#include "support/voxel_stock.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Kind = CanonEvent::Kind;

/// Cubes of a block; their side follows, but is no less than ...
constexpr double kCubes = 1e7;
/// ... this [mm].
constexpr double kFinestMm = 0.35;
/// What is uncertain around a cylinder, in cubes: half a diagonal for each time the stock was turned, and the
/// steps along a path.
constexpr double kRimCubes = 1.5;
/// The zero of the machine is 1000 mm over that of G54 (in inches).
constexpr const char* kOffsets = "5221\t0\n5222\t0\n5223\t-39.37\n";
/// Fixtures are looked at so far around the stock [mm].
constexpr double kAroundMm = 200;

struct Cylinder {
    double radius_mm = 0;
    double bottom_mm = 0;  ///< over the tip
    double top_mm = 0;
};

/// A tool in the spindle, as plan.json has it.
struct Spindle {
    CutterProfile cutter;
    double flutes_mm = 0;
    std::vector<Cylinder> above;  ///< shank, holder, nose of the spindle
};

Spindle spindleOf(const Json& tool, double shorter_mm) {
    Spindle spindle{cutterOf(tool), tool.at("flute_length_mm"), {}};
    const auto add = [&](const Json& one) {
        spindle.above.push_back({one.at("diameter_mm").get<double>() / 2,
                                 one.at("bottom_mm").get<double>() - shorter_mm, one.at("top_mm")});
    };
    if (!tool.at("shank").is_null()) add(tool.at("shank"));
    for (const Json& one : tool.at("holder"))
        add(one);
    spindle.above.back().top_mm = 1e6;
    return spindle;
}

/// Tops of the fixtures around the stock.
HeightMap fixturesOf(const Json& plan, const Json& setup, const Box3& stock) {
    const Vec2 around(kAroundMm, kAroundMm);
    const Box2 box(stock.min().head<2>() - around, stock.max().head<2>() + around);
    constexpr double kCellMm = 1;
    HeightMap tops(box, kCellMm, stock.min().z() - 1000);
    for (const Json& fixture : setup.at("fixtures")) {
        Region section;
        for (const Json& loop : plan.at("regions").at(fixture.at("section").get<std::size_t>()))
            section.loops.push_back(loopFromJson(plan.at("loops").at(loop.get<std::size_t>()), "loop"));
        tops.raise(section, fixture.at("top_z_mm"));
    }
    return tops;
}

struct Hits {
    int rapids = 0;
    int cylinders = 0;
    int fixtures = 0;
    std::string first;
};

/// One setup's program on the stock.
class Run {
  public:
    Run(VoxelStock& stock, const HeightMap& fixtures, const std::map<int, Spindle>& spindles, double cell_mm,
        Hits& hits)
        : stock_(stock), fixtures_(fixtures), spindles_(spindles), cell_mm_(cell_mm), hits_(hits) {}

    void run(const std::vector<CanonEvent>& events) {
        std::optional<Vec3> at;
        for (const CanonEvent& event : events) {
            if (event.kind == Kind::ToolChange) at.reset();
            if (event.kind != Kind::Rapid && event.kind != Kind::Feed && event.kind != Kind::Arc) continue;
            if (at) move(*at, event);
            at = placeOf(event);
        }
    }

  private:
    void move(const Vec3& from, const CanonEvent& event) {
        const Spindle& spindle = spindles_.at(event.tool);
        const double step_mm = std::max(cell_mm_, std::sqrt(cell_mm_ * spindle.cutter.radius_mm));
        const Toolpath path = pathOf(from, event);
        Vec3 start = path.start;
        for (const Move& move : path.moves) {
            const MovePlaces places(start, move, step_mm);
            for (int i = 0; i <= places.last(); ++i)
                stand(places.at(i), event, spindle);
            start = move.to;
        }
    }

    void stand(const Vec3& tip, const CanonEvent& event, const Spindle& spindle) {
        const double radius_mm = spindle.cutter.radius_mm;
        if (event.kind != Kind::Rapid) stock_.cut(tip, spindle.cutter);
        // A drill is as wide as that from the end of its point on.
        else if (stock_.meets(tip.head<2>(), radius_mm - rimMm(),
                              tip.z() + spindle.cutter.heightAt(radius_mm) + cell_mm_,
                              tip.z() + spindle.flutes_mm))
            note(hits_.rapids, "a rapid", tip, event);
        fixture({radius_mm, 0, spindle.flutes_mm}, tip, event);
        for (const Cylinder& cylinder : spindle.above) {
            const double bottom_mm = tip.z() + cylinder.bottom_mm + cell_mm_;
            fixture(cylinder, tip, event);
            if (bottom_mm >= stock_.topMm() || cylinder.radius_mm <= rimMm()) continue;
            if (stock_.meets(tip.head<2>(), cylinder.radius_mm - rimMm(), bottom_mm,
                             tip.z() + cylinder.top_mm))
                note(hits_.cylinders, fmt::format("D{:g}", 2 * cylinder.radius_mm).c_str(), tip, event);
        }
    }

    void fixture(const Cylinder& cylinder, const Vec3& tip, const CanonEvent& event) {
        const double bottom_mm = tip.z() + cylinder.bottom_mm;
        bool met = false;
        fixtures_.raster().forDisc(tip.head<2>(), cylinder.radius_mm - 1,
                                   [&](std::size_t cell) { met |= fixtures_.heights()[cell] > bottom_mm; });
        if (met) note(hits_.fixtures, "a fixture", tip, event);
    }

    void note(int& count, const char* what, const Vec3& tip, const CanonEvent& event) {
        if (hits_.first.empty())
            hits_.first = fmt::format("{} of T{} at X{:.3f} Y{:.3f} Z{:.3f} in {}", what, event.tool, tip.x(),
                                      tip.y(), tip.z(), event.comment);
        ++count;
    }

    double rimMm() const { return kRimCubes * cell_mm_; }

    VoxelStock& stock_;
    const HeightMap& fixtures_;
    const std::map<int, Spindle>& spindles_;
    double cell_mm_;
    Hits& hits_;
};

/// All setups of a plan.
/// \param shorter_mm  how much lower than planned shanks, holders and spindle are
Hits simulated(const fs::path& job, double shorter_mm) {
    const Json plan = Json::parse(slurp(job / "plan.json"));
    std::map<int, Spindle> spindles;
    for (const Json& tool : plan.at("tools"))
        spindles[tool.at("number")] = spindleOf(tool, shorter_mm);
    const std::string table = toolTableOf(plan);
    Hits hits;
    std::optional<VoxelStock> stock;
    Eigen::Isometry3d before;
    for (const Json& setup : plan.at("setups")) {
        if (setup.at("operations").empty()) continue;
        const Eigen::Isometry3d here = transformOf(setup);
        const Box3 box = rawStockIn(plan, here);
        const double cell_mm = std::max(kFinestMm, std::cbrt(box.sizes().prod() / kCubes));
        stock = stock ? stock->turned(box, before * here.inverse()) : VoxelStock(box, cell_mm);
        const HeightMap fixtures = fixturesOf(plan, setup, box);
        const SecondReader reader(slurp(job / setup.at("program").get<std::string>()), table, kOffsets);
        EXPECT_EQ(reader.exit_code, 0) << reader.refusal;
        const double volume = stock->volumeMm3();
        Run(*stock, fixtures, spindles, cell_mm, hits).run(canonEvents(reader.output));
        fmt::print("{} with cubes of {:.2f} mm: {:.0f} of {:.0f} mm3 cut\n",
                   setup.at("id").get<std::string>(), cell_mm, volume - stock->volumeMm3(), volume);
        EXPECT_LT(stock->volumeMm3(), volume);
        before = here;
    }
    return hits;
}

fs::path planOf(const ExpectedOutcome& part) {
    const PlannedPart planned = plannedPart(
        part.path,
        {"--machine", std::string(STEPMILL_SOURCE_DIR) + "/tests/corpus/whole_machine/large_machine.json"});
    EXPECT_LE(planned.run.exit_code, 1) << planned.run.err;
    return planned.folder;
}

class WholeMachine : public testing::TestWithParam<ExpectedOutcome> {
  protected:
    void SetUp() override {
        STEPMILL_NEEDS_PART(GetParam());
        STEPMILL_NEEDS_SECOND_READER();
    }
};

TEST_P(WholeMachine, MeetsNeitherMaterialNorFixtures) {
    const Hits hits = simulated(planOf(GetParam()), 0);
    EXPECT_EQ(hits.rapids, 0) << hits.first;
    EXPECT_EQ(hits.cylinders, 0) << hits.first;
    EXPECT_EQ(hits.fixtures, 0) << hits.first;
}

/// So the test above can fail.
TEST_P(WholeMachine, IsMetWhereToolsAreShorterThanPlanned) {
    EXPECT_GT(simulated(planOf(GetParam()), 25).cylinders, 0);
}

const auto kPartName = [](const auto& row) { return testName(row.param); };
INSTANTIATE_TEST_SUITE_P(RealParts, WholeMachine,
                         testing::ValuesIn(expectedRows({"step_parts/four_setups.step",
                                                         "machined/aagnet_partC.step"})),
                         kPartName);
INSTANTIATE_TEST_SUITE_P(Slow, WholeMachine,
                         testing::ValuesIn(expectedRows({"nist/nist_ctc_01_asme1_rd.stp",
                                                         "nist/nist_ftc_06_asme1_rd.stp"})),
                         kPartName);

}  // namespace
}  // namespace stepmill::test
