// What posted programs ask of cutters and spindle, read back without our reader and our cutting model:
// LinuxCNC's interpreter runs them on a stock of heights, and what goes in a stretch of feeds over the time
// it takes is no more than the tool is rated for, nor than the spindle gives; nothing plunges deeper than its
// tool may.
//
// Of each plan the first setup: what later ones find is no block.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/expected_outcomes.h"
#include "support/plan_json.h"
#include "support/planned_parts.h"
#include "support/program_judge.h"
#include "support/second_reader.h"

namespace stepmill::test {
namespace {

using Json = nlohmann::json;
using Kind = CanonEvent::Kind;

/// Cells of the stock; their side follows, but is no less than ...
constexpr double kMostCells = 2e6;
/// ... this [mm].
constexpr double kFinestMm = 0.1;
/// A stretch is as long as this many diameters: shorter ones are too few cells.
constexpr double kStretchDiameters = 3;
/// Cells that are counted whole make a stretch's removal uncertain by this share of it.
constexpr double kRateShare = 0.1;
/// Heights of programs are rounded, and a plunge begins a little over its ground [mm].
constexpr double kHeightMm = 0.01;

/// A mill in one operation, as plan.json has it.
struct Rated {
    double removal_mm3_per_min = 0;
    double max_plunge_mm = 0;
    double diameter_mm = 0;
    int flutes = 0;
    CutterProfile cutter;
};

struct Spindle {
    double power_kw = 0;
    double efficiency = 1;
    double kc11_n_per_mm2 = 0;
    double mc = 0;
};

/// Breaches, and how near to the limits the program goes.
struct Judgement {
    int too_fast = 0;
    int too_strong = 0;
    int plunges = 0;
    int stretches = 0;
    double rated_share = 0;  ///< the most of what a tool is rated for
    std::string first;
};

class CutJudge {
  public:
    CutJudge(const Json& plan, const Json& setup)
        : stock_mm_(rawStockIn(plan, transformOf(setup)).sizes()),
          map_(Box2(Vec2(0, 0), Vec2(stock_mm_.x(), stock_mm_.y())), cellMm(stock_mm_), -stock_mm_.z()) {
        map_.raise(makeRectangle(Vec2(0, 0), Vec2(stock_mm_.x(), stock_mm_.y())), 0);
        std::map<std::string, Json> tools;
        for (const Json& tool : plan.at("tools"))
            tools[tool.at("id")] = tool;
        for (const Json& operation : plan.at("operations")) {
            const Json& tool = tools.at(operation.at("tool"));
            tool_cutters_[tool.at("number")] = cutterOf(tool);
            if (!operation.contains("rating")) continue;
            rated_[operation.at("id")] = {
                1000 * operation.at("rating").at("removal_cm3_per_min").get<double>(),
                tool.at("max_plunge_mm"), tool.at("diameter_mm"), tool.value("flutes", 0), cutterOf(tool)};
        }
        const Json& spindle = plan.at("machine").at("spindle");
        for (const Json& point : spindle.at("curve"))
            spindle_.power_kw = std::max(spindle_.power_kw, point.at("power_kw").get<double>());
        spindle_.efficiency = spindle.at("efficiency");
        spindle_.kc11_n_per_mm2 = plan.at("cut_material").at("kc11_n_per_mm2");
        spindle_.mc = plan.at("cut_material").at("mc");
    }

    Judgement judge(const std::vector<CanonEvent>& events) {
        std::optional<Vec3> at;
        for (const CanonEvent& event : events) {
            if (event.kind == Kind::ToolChange) at.reset();
            if (event.kind != Kind::Rapid && event.kind != Kind::Feed && event.kind != Kind::Arc) continue;
            if (at) move(*at, event);
            at = placeOf(event);
        }
        return found_;
    }

  private:
    static double cellMm(const Vec3& stock_mm) {
        return std::max(kFinestMm, std::sqrt(stock_mm.x() * stock_mm.y() / kMostCells));
    }

    void move(const Vec3& from, const CanonEvent& event) {
        const std::string id = event.comment.substr(0, event.comment.find(' '));
        const auto found = rated_.find(id.substr(id.find('S')));
        const CutterProfile& cutter = tool_cutters_.at(event.tool);
        const bool stretch_ends = event.kind == Kind::Rapid || id != stretch_of_;
        if (stretch_ends) startStretch(id);
        if (event.kind == Kind::Rapid) return;
        const bool plunges = goesStraightDown(from, event);
        if (plunges && found != rated_.end()) plunge(from, event, found->second);
        const HeightMap::Cut cut = map_.run(pathOf(from, event), cutter, 0);
        // Ways straight down have a feed of their own; their depth is what is limited.
        if (plunges) startStretch(id);
        if (plunges || found == rated_.end()) return;
        removed_mm3_ += cut.removed_mm3;
        length_mm_ += cut.feed_mm;
        minutes_ += cut.feed_mm / event.feed_mm_per_min;
        const Rated& rated = found->second;
        if (length_mm_ < kStretchDiameters * rated.diameter_mm) return;
        weigh(rated, event);
        startStretch(id);
    }

    void startStretch(const std::string& operation) {
        stretch_of_ = operation;
        removed_mm3_ = length_mm_ = minutes_ = 0;
    }

    void weigh(const Rated& rated, const CanonEvent& event) {
        ++found_.stretches;
        const double removal = removed_mm3_ / minutes_;
        const double share = removal / rated.removal_mm3_per_min;
        found_.rated_share = std::max(found_.rated_share, share);
        if (removal > rated.removal_mm3_per_min * (1 + kRateShare))
            note(found_.too_fast, fmt::format("removes {:.2f} times what the tool is rated for", share),
                 event);
        // No chip is thicker than the feed per tooth, and thinner ones ask for more force a section.
        const double feed = length_mm_ / minutes_;
        const double tooth_mm = feed / event.speed_rpm / std::max(1, rated.flutes);
        const double least_kw =
            removal / 60e6 * spindle_.kc11_n_per_mm2 * std::pow(tooth_mm, -spindle_.mc) / spindle_.efficiency;
        if (least_kw > spindle_.power_kw * (1 + kRateShare))
            note(found_.too_strong, fmt::format("takes {:.1f} kW at least", least_kw), event);
    }

    static bool goesStraightDown(const Vec3& from, const CanonEvent& event) {
        return event.kind == Kind::Feed && from.head<2>() == placeOf(event).head<2>() &&
               event.to[2] < from.z();
    }

    void plunge(const Vec3& from, const CanonEvent& event, const Rated& rated) {
        double highest_mm = -stock_mm_.z();
        map_.raster().forDisc(
            from.head<2>(), rated.cutter.radius_mm - 2 * map_.raster().cellMm(),
            [&](std::size_t cell) { highest_mm = std::max(highest_mm, map_.heights()[cell]); });
        const double deep_mm = highest_mm - event.to[2];
        if (deep_mm > rated.max_plunge_mm + kHeightMm)
            note(found_.plunges, fmt::format("plunges {:.2f} mm, may {:g}", deep_mm, rated.max_plunge_mm),
                 event);
    }

    void note(int& count, const std::string& what, const CanonEvent& event) {
        if (found_.first.empty())
            found_.first = fmt::format("{} at X{:.3f} Y{:.3f} Z{:.3f} in {}", what, event.to[0], event.to[1],
                                       event.to[2], event.comment);
        ++count;
    }

    Vec3 stock_mm_;
    HeightMap map_;
    std::map<std::string, Rated> rated_;
    std::map<int, CutterProfile> tool_cutters_;
    Spindle spindle_;
    std::string stretch_of_;
    double removed_mm3_ = 0;
    double length_mm_ = 0;
    double minutes_ = 0;
    Judgement found_;
};

/// Of the first setup's program, with every feed so many times as high.
Judgement judged(const std::string& part, const std::vector<std::string>& options, double faster = 1) {
    const PlannedPart planned = plannedPart(part, options);
    EXPECT_LE(planned.run.exit_code, 1) << planned.run.err;
    const Json plan = Json::parse(slurp(planned.folder / "plan.json"));
    const Json& setup = plan.at("setups").front();
    const SecondReader reader(slurp(planned.folder / setup.at("program").get<std::string>()),
                              toolTableOf(plan));
    EXPECT_EQ(reader.exit_code, 0) << reader.refusal;
    std::vector<CanonEvent> events = canonEvents(reader.output);
    for (CanonEvent& event : events)
        event.feed_mm_per_min *= faster;
    Judgement found = CutJudge(plan, setup).judge(events);
    fmt::print("{} stretches, the fastest {:.2f} times as rated\n", found.stretches, found.rated_share);
    return found;
}

class RatedCuts : public testing::TestWithParam<ExpectedOutcome> {
  protected:
    void SetUp() override {
        STEPMILL_NEEDS_PART(GetParam());
        STEPMILL_NEEDS_SECOND_READER();
    }

    void expectWithin(std::vector<std::string> options) const {
        // A part that is larger than the machine's travel has no program.
        if (GetParam().part.starts_with("nist/")) {
            options.push_back("--machine");
            options.push_back(std::string(STEPMILL_SOURCE_DIR) +
                              "/tests/corpus/whole_machine/large_machine.json");
        }
        const Judgement found = judged(GetParam().path, options);
        EXPECT_GT(found.stretches, 0);
        EXPECT_EQ(found.too_fast, 0) << found.first;
        EXPECT_EQ(found.too_strong, 0) << found.first;
        EXPECT_EQ(found.plunges, 0) << found.first;
    }
};

TEST_P(RatedCuts, AreWithinWhatToolsAndSpindleGiveInAluminium) {
    expectWithin({});
}

TEST_P(RatedCuts, AreWithinWhatToolsAndSpindleGiveInSteel) {
    expectWithin({"--material", "steel"});
}

/// So the tests above can fail.
TEST(RatedCutsJudge, FindsSlotsAtTheLibrarysFeed) {
    STEPMILL_NEEDS_SECOND_READER();
    const std::string pocket = std::string(STEPMILL_SOURCE_DIR) + "/step_parts/rounded_pocket.step";
    EXPECT_EQ(judged(pocket, {}).too_fast, 0);
    EXPECT_GT(judged(pocket, {}, 1.5).too_fast, 0);
}

const std::string kNothingToCut = "machined/simple_block_rawpiece.stp";
const std::string kSlowSample = "step_parts/die_with_islands.step";

const auto kPartName = [](const auto& row) { return testName(row.param); };
/// The sample parts, but for those whose two plans take minutes.
std::vector<ExpectedOutcome> quickSamples() {
    std::vector<ExpectedOutcome> rows = expectedPlans({"step_parts"});
    std::erase_if(rows, [](const ExpectedOutcome& row) { return row.part == kSlowSample; });
    return rows;
}

std::vector<ExpectedOutcome> slowRows() {
    std::vector<ExpectedOutcome> rows = expectedPlans({"machined", "nist"});
    std::erase_if(rows, [](const ExpectedOutcome& row) { return row.part == kNothingToCut; });
    for (ExpectedOutcome& row : expectedRows({kSlowSample}))
        rows.push_back(std::move(row));
    return rows;
}

INSTANTIATE_TEST_SUITE_P(SampleParts, RatedCuts, testing::ValuesIn(quickSamples()), kPartName);
INSTANTIATE_TEST_SUITE_P(RealParts, RatedCuts, testing::ValuesIn(expectedRows({"machined/hole_model.stp"})),
                         kPartName);
INSTANTIATE_TEST_SUITE_P(Slow, RatedCuts, testing::ValuesIn(slowRows()), kPartName);

}  // namespace
}  // namespace stepmill::test
