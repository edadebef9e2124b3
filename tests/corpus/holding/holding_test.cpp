// What holds random plates holds them to the end: the programs run on height maps that know nothing of the
// planner's own proof.

#include <gtest/gtest.h>

#include <deque>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stepmill/core/file.h"
#include "stepmill/post/read_program.h"
#include "stepmill/record/plan_record.h"
#include "support/height_map.h"
#include "support/random_plates.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;

constexpr double kCellMm = 0.5;
/// Rims of cutters and of held stock are uncertain by a cell's diagonal [mm].
constexpr double kRimMm = 0.8;
constexpr double kFlushMm = 1e-3;
/// Fewer cells are crumbs between passes, which chips carry off.
constexpr std::size_t kCrumbCells = 8;

const Tolerances kTol;

Toolpath pathOf(const ReadOperation& operation) {
    Toolpath path;
    path.start = operation.start;
    for (const ReadMove& read : operation.moves)
        path.moves.push_back(read.fed.move);
    return path;
}

/// Cells of held stock that no longer stand as high as they are held.
std::size_t cutHeld(const HeightMap& stock, const RecordedSetup& setup) {
    std::size_t cut = 0;
    for (const Fixture& fixture : setup.fixtures) {
        if (fixture.kind != FixtureKind::HeldStock) continue;
        std::vector<char> outside = stock.raster().cellsOf(fixture.section);
        for (char& cell : outside)
            cell = cell ? 0 : 1;
        const std::vector<double> inside_mm = stock.raster().distanceTo(outside);
        for (std::size_t i = 0; i < inside_mm.size(); ++i)
            if (inside_mm[i] > kRimMm && stock.heights()[i] < fixture.top_z_mm - kFlushMm) ++cut;
    }
    return cut;
}

/// The least height of the stock right beside the jaws, over its bottom; all of it without jaws.
double gripLeft(const HeightMap& stock, const RecordedSetup& setup) {
    double least = setup.stock_size_mm.z();
    for (const Fixture& fixture : setup.fixtures) {
        if (fixture.kind != FixtureKind::Jaw) continue;
        const Box2 jaw = boundingBox(fixture.section);
        for (std::size_t i = 0; i < stock.heights().size(); ++i) {
            const Vec2 at = stock.raster().centre(i);
            const bool beside = (at.array() > jaw.min().array() - 2 * kRimMm).all() &&
                                (at.array() < jaw.max().array() + 2 * kRimMm).all();
            if (beside) least = std::min(least, stock.heights()[i] + setup.stock_size_mm.z());
        }
    }
    return least;
}

/// Pieces that stand over the stock's bottom, each by its count of cells.
std::vector<std::size_t> pieces(const HeightMap& stock, double bottom_mm) {
    const Raster& raster = stock.raster();
    std::vector<char> seen(raster.count(), 0);
    std::vector<std::size_t> found;
    for (std::size_t first = 0; first < raster.count(); ++first) {
        if (seen[first] || stock.heights()[first] <= bottom_mm + kFlushMm) continue;
        std::deque<std::size_t> open{first};
        seen[first] = 1;
        std::size_t cells = 0;
        while (!open.empty()) {
            const std::size_t at = open.front();
            open.pop_front();
            ++cells;
            const auto columns = static_cast<std::size_t>(raster.columns());
            const auto visit = [&](bool there, std::size_t next) {
                if (!there || seen[next] || stock.heights()[next] <= bottom_mm + kFlushMm) return;
                seen[next] = 1;
                open.push_back(next);
            };
            visit(at % columns > 0, at - 1);
            visit(at % columns + 1 < columns, at + 1);
            visit(at >= columns, at - columns);
            visit(at + columns < raster.count(), at + columns);
        }
        if (cells > kCrumbCells) found.push_back(cells);
    }
    return found;
}

/// The raw stock of a first setup, cut by its program; what holds it is looked at after every operation.
class HeldRun {
  public:
    HeldRun(const PlanRecord& record, const fs::path& job)
        : record_(record), setup_(record.setups.front()), stock_(boxOf(setup_), kCellMm, bottomMm()) {
        stock_.raise(makeRectangle(Vec2(0, 0), setup_.stock_size_mm.head<2>()), 0);
        program_ = readProgram(readFile(job / setup_.program), setup_.program, Dialect::LinuxCnc);
    }

    void run() {
        for (const ReadOperation& operation : program_.operations) {
            stock_.run(pathOf(operation), profileOf(record_.operations.at(operation.id).tool), 0);
            check(operation.id);
        }
    }

  private:
    static Box2 boxOf(const RecordedSetup& setup) {
        return {Vec2(0, 0), Vec2(setup.stock_size_mm.head<2>())};
    }
    double bottomMm() const { return -setup_.stock_size_mm.z(); }

    void check(const std::string& after) const {
        EXPECT_EQ(cutHeld(stock_, setup_), 0U) << after;
        const Clamping& held = setup_.clamping;
        if (!held.isVise()) return;
        EXPECT_GE(gripLeft(stock_, setup_),
                  held.from_mm + held.depth_mm + record_.request->vise->jaw_clearance_mm - kFlushMm)
            << after;
        EXPECT_EQ(pieces(stock_, bottomMm()).size(), 1U) << "something falls loose in " << after;
    }

    const PlanRecord& record_;
    const RecordedSetup& setup_;
    HeightMap stock_;
    ReadProgram program_;
};

struct Blank {
    std::vector<std::string> options;
    HoldKind first;  ///< what holds the first setup
};

void expectHeld(std::uint64_t seed, const Blank& blank) {
    Dice dice(seed);
    const SamplePart plate = randomPlate(fmt::format("plate_{}", seed), dice);
    SCOPED_TRACE(fmt::format("seed {}: {} {}", seed, plate.about, fmt::join(blank.options, " ")));
    const TemporaryFolder folder;
    const fs::path file = fs::path(folder.path()) / (plate.name + ".step");
    std::ofstream(file) << sampleStepText(plate);
    const fs::path job = fs::path(folder.path()) / "job";
    std::vector<std::string> words{stepmillBinary(), "plan",       file.string(), "-o",
                                   job.string(),     "--no-viewer"};
    words.insert(words.end(), blank.options.begin(), blank.options.end());
    const ProgramRun run = runProgram(words);
    ASSERT_LE(run.exit_code, 1) << run.err;
    const PlanRecord record = planRecordFromText(readFile(job / "plan.json"), kTol);
    EXPECT_EQ(record.setups.front().clamping.kind, blank.first) << record.setups.front().clamping.text;
    HeldRun(record, job).run();
    for (const RecordedSetup& setup : record.setups)
        EXPECT_NE(setup.clamping.kind, HoldKind::None) << setup.clamping.text;
}

class RandomPlates : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomPlates, AreHeldToTheEndOfTheSetup) {
    expectHeld(GetParam(), {{"--stock", "auto"}, HoldKind::Vise});
    expectHeld(GetParam(), {{"--hold", "vise"}, HoldKind::Vise});
    expectHeld(GetParam(), {{}, HoldKind::Plate});
    expectHeld(GetParam(), {{"--hold", "skin"}, HoldKind::Skin});
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPlates, testing::Range<std::uint64_t>(1, 7));

}  // namespace
}  // namespace stepmill::test
