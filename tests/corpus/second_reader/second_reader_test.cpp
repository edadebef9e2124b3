// Every posted LinuxCNC program through LinuxCNC's own interpreter: what it understands is what our reader
// understands, motion by motion, and what the plan says, length by length.

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "stepmill/record/plan_files.h"
#include "stepmill/toolpath/toolpath.h"
#include "support/expected_outcomes.h"
#include "support/planned_parts.h"
#include "support/second_reader.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

using Json = nlohmann::json;

using test::kTol;
/// The interpreter prints four decimals.
constexpr double kPrintedMm = 1.01e-4;
/// What rounding to the program's decimals does to a move's length.
constexpr double kRoundedMoveMm = 2e-4;
/// Cycles count pecks from the R plane: one peck more than planned, there and back, and rapids that stop
/// elsewhere over the last peck. Where chips are broken that peck is one more lift.
double cycleMargin(const Json& planned) {
    const double pecks = planned.at("layers");
    const double holes = planned.value("holes", 1);
    if (planned.at("pattern") == kChipBreakPattern) return holes * (kChipBreakLiftMm + kPrintedMm);
    if (planned.at("pattern") != "drill" || pecks <= 1) return 0;
    constexpr double kOverHoleMm = 1;
    constexpr double kBeyondFloorMm = 6;  // a drill's point and a little, where it goes through
    const double depth = planned.at("z_top_mm").get<double>() - planned.at("z_floor_mm").get<double>();
    return holes * (2 * (depth + kOverHoleMm + kBeyondFloorMm) + pecks);
}

double lengthOf(const Vec3& from, const CanonMotion& motion) {
    double flat = (motion.to - from).head<2>().norm();
    if (motion.kind == CanonMotion::Kind::Arc) {
        const Arc arc{motion.centre, (from.head<2>() - motion.centre).norm(), motion.turn > 0};
        flat = length(Vec2(from.head<2>()), {Vec2(motion.to.head<2>()), arc});
    }
    return std::hypot(flat, motion.to.z() - from.z());
}

/// The interpreter's motions of an operation from its first place on, without those that go nowhere.
std::vector<CanonMotion> fromStart(const CanonOperation& canon, const ReadOperation& ours,
                                   bool after_tool_change) {
    std::vector<CanonMotion> motions;
    std::size_t first = 0;
    if (after_tool_change)
        while (first < canon.motions.size() &&
               (canon.motions[first++].to - ours.start).norm() > 2 * kPrintedMm) {
        }
    Vec3 at = ours.start;
    for (std::size_t i = first; i < canon.motions.size(); ++i) {
        const CanonMotion& motion = canon.motions[i];
        // Ways home have no number; the reader lets the program's highest place stand for their end.
        if (motion.n_word.find_first_of("0123456789") == std::string::npos) continue;
        const bool stays = motion.kind != CanonMotion::Kind::Arc && (motion.to - at).norm() < kPrintedMm / 4;
        if (!stays) motions.push_back(motion);
        at = motion.to;
    }
    return motions;
}

/// Does the operation begin with motions from a place that is not known?
bool comesFromLeap(const ReadProgram& program, const std::string& id) {
    return std::any_of(program.leaps.begin(), program.leaps.end(),
                       [&](const ReadLeap& leap) { return leap.operation == id; });
}

void expectSame(const CanonMotion& canon, const ReadMove& ours, const std::string& where) {
    const Move& move = ours.fed.move;
    const auto kind = move.kind == MoveKind::Rapid ? CanonMotion::Kind::Rapid
                      : move.arc                   ? CanonMotion::Kind::Arc
                                                   : CanonMotion::Kind::Feed;
    ASSERT_EQ(static_cast<int>(canon.kind), static_cast<int>(kind)) << where;
    ASSERT_LT((canon.to - move.to).cwiseAbs().maxCoeff(), kPrintedMm) << where;
    ASSERT_NEAR(canon.feed_mm_per_min, ours.fed.feed_mm_per_min, 1e-3) << where;
    if (!move.arc) return;
    ASSERT_LT((canon.centre - move.arc->centre).cwiseAbs().maxCoeff(), kPrintedMm) << where;
    ASSERT_EQ(canon.turn, move.arc->ccw ? 1 : -1) << where;
}

/// Lengths and time of what the interpreter understood against the plan's own.
void expectPlanned(const std::vector<CanonMotion>& motions, const Vec3& start, const Json& planned,
                   double rapid_rate, const std::string& where) {
    double cut = 0;
    double air = 0;
    double time_s = planned.at("dwell_s");
    Vec3 at = start;
    double feed_floor = 1e9;
    for (const CanonMotion& motion : motions) {
        const double length = lengthOf(at, motion);
        const bool rapid = motion.kind == CanonMotion::Kind::Rapid;
        (rapid ? air : cut) += length;
        time_s += length / (rapid ? rapid_rate : motion.feed_mm_per_min) * 60;
        if (!rapid) feed_floor = std::min(feed_floor, motion.feed_mm_per_min);
        at = motion.to;
    }
    const double rounding = kRoundedMoveMm * static_cast<double>(motions.size());
    const double cycle = cycleMargin(planned);
    const double pecks = cycle > 0 ? planned.at("layers").get<double>() + 1 : 0;
    const double cut_margin = rounding + pecks;
    const double air_margin = rounding + cycle;
    EXPECT_NEAR(cut, planned.at("cut_length_mm").get<double>(), cut_margin) << where;
    EXPECT_NEAR(air, planned.at("air_length_mm").get<double>(), air_margin) << where;
    EXPECT_NEAR(time_s, planned.at("time_s").get<double>(),
                60 * (cut_margin / feed_floor + air_margin / rapid_rate) + 1e-4 * time_s)
        << where;
}

/// T words by the table, in the program's order.
std::string tableOf(const PlanRecord& record) {
    Job job;
    for (const auto& [id, operation] : record.operations) {
        job.operations.emplace_back();
        job.operations.back().tool = operation.tool;
    }
    return toolTable(job);
}

struct Count {
    int withheld = 0;  ///< setups beyond the machine's travel have no program
    int programs = 0;
    int motions = 0;
    int arcs = 0;
};

void compare(const PlanFiles& files, const PlanRecord& record, const RecordedSetup& setup,
             const std::string& part, Count& count) {
    if (files.programs.at(setup.id).empty()) {
        ++count.withheld;
        return;
    }
    const SecondReader second(files.programs.at(setup.id).front().text, tableOf(record));
    ASSERT_EQ(second.exit_code, 0) << part << " " << setup.id << ": " << second.refusal;
    const ReadProgram ours = readPrograms(files, setup).front();
    // A program without operations goes home and ends.
    if (ours.operations.empty()) return;
    ASSERT_EQ(second.operations.size(), ours.operations.size()) << part;
    const Json plan = Json::parse(files.plan_json);
    std::map<std::string, Json> planned;
    for (const Json& operation : plan.at("operations"))
        planned[operation.at("id")] = operation;
    ++count.programs;
    for (std::size_t i = 0; i < ours.operations.size(); ++i) {
        const ReadOperation& operation = ours.operations[i];
        const CanonOperation& canon = second.operations[i];
        const std::string where = part + " " + operation.id;
        ASSERT_EQ(canon.id, operation.id) << part;
        EXPECT_EQ(canon.tool, record.operations.at(operation.id).tool.number) << where;
        const std::vector<CanonMotion> motions =
            fromStart(canon, operation, comesFromLeap(ours, operation.id));
        std::vector<ReadMove> moves = operation.moves;
        std::erase_if(moves, [](const ReadMove& move) { return move.home; });
        ASSERT_EQ(motions.size(), moves.size()) << where;
        for (std::size_t k = 0; k < motions.size(); ++k) {
            expectSame(motions[k], moves[k],
                       fmt::format("{} line {} {}", where, moves[k].line, motions[k].n_word));
            if (testing::Test::HasFatalFailure()) return;
            count.arcs += motions[k].kind == CanonMotion::Kind::Arc;
        }
        count.motions += static_cast<int>(motions.size());
        expectPlanned(motions, operation.start, planned.at(operation.id), record.machine.rapid_mm_per_min,
                      where);
    }
}

void expectUnderstood(const ExpectedOutcome& expected, const std::vector<std::string>& options) {
    const PlannedPart planned = plannedPart(expected.path, options);
    ASSERT_LE(planned.run.exit_code, 1) << planned.run.err;
    const auto [files, record] = readPlan(planned.folder, std::nullopt, kTol);
    Count count;
    for (const RecordedSetup& setup : record.setups)
        compare(files, record, setup, expected.part, count);
    fmt::print("{} programs, {} motions ({} arcs) understood as we do\n", count.programs, count.motions,
               count.arcs);
    // A raw piece that is the part already has a program without motions.
    if (count.withheld == 0) {
        EXPECT_EQ(count.motions > 0, !record.operations.empty());
    }
}

class SecondReaderOf : public testing::TestWithParam<ExpectedOutcome> {
  protected:
    void SetUp() override {
        STEPMILL_NEEDS_SECOND_READER();
        STEPMILL_NEEDS_PART(GetParam());
    }
};

TEST_P(SecondReaderOf, UnderstandsThePlanAsWeDo) {
    expectUnderstood(GetParam(), {});
}

using SecondReaderOfFinishing = SecondReaderOf;

TEST_P(SecondReaderOfFinishing, UnderstandsThePlanAsWeDo) {
    expectUnderstood(GetParam(), kWithAllowance);
}

TEST(SecondReaderOfThreads, UnderstandsThePlanAsWeDo) {
    STEPMILL_NEEDS_SECOND_READER();
    const std::string source = STEPMILL_SOURCE_DIR;
    for (const ExpectedOutcome& row : expectedPlans({"step_parts"}))
        if (row.part.find("plate_with_holes") != std::string::npos)
            return expectUnderstood(row, {"--holes", source + "/samples/plate_holes.json", "--tools",
                                          source + "/samples/shop_with_taps_tools.json"});
    FAIL() << "the plate is gone";
}

const auto kPartName = [](const auto& row) { return testName(row.param); };
const std::vector<ExpectedOutcome> kSampleParts = expectedPlans({"step_parts"});
const std::vector<ExpectedOutcome> kAllParts = expectedPlans({"step_parts", "machined", "nist"});

INSTANTIATE_TEST_SUITE_P(Corpus, SecondReaderOf, testing::ValuesIn(kAllParts), kPartName);
INSTANTIATE_TEST_SUITE_P(Corpus, SecondReaderOfFinishing,
                         testing::ValuesIn(withSlowProofs(kSampleParts, false)), kPartName);
INSTANTIATE_TEST_SUITE_P(Slow, SecondReaderOfFinishing,
                         testing::ValuesIn(withSlowProofs(expectedOf("step_parts"), true)), kPartName);

}  // namespace
}  // namespace stepmill::test
