// Posted programs with a slip in each, judged by LinuxCNC's interpreter and by cutting the stock: a slip that
// matters is caught by verify, one that changes nothing is accepted.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/toolpath/adaptive_cutting.h"
#include "stepmill/verify/verify.h"
#include "support/planned_parts.h"
#include "support/program_edits.h"
#include "support/program_judge.h"
#include "support/second_reader.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

constexpr int kDefaultMutations = 100;
using test::kTol;
/// Each tool has a length of its own in the table, so that a wrong one shows: its number times this.
constexpr double kInchesATool = 0.1;

int numberOfMutations() {
    const char* asked = std::getenv("STEPMILL_PROGRAM_MUTATIONS");
    return asked != nullptr ? std::atoi(asked) : kDefaultMutations;
}

/// Small parts of several kinds; those of the shared folder where it is there.
std::vector<std::string> parts() {
    std::vector<std::string> chosen;
    for (const char* name : {"rounded_pocket", "plate_with_holes", "shoulder_block", "nested_pockets",
                             "open_slots", "bossed_pocket", "butterfly_pocket", "die_cavity"})
        chosen.push_back(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + name + ".step");
    const std::vector<std::string> shared = sharedParts("mfcad");
    for (std::size_t i = 0; i < shared.size() && chosen.size() < 11;
         i += std::max<std::size_t>(1, shared.size() / 6))
        chosen.push_back(shared[i]);
    return chosen;
}

/// A plan's first setup and all that judges need of it.
struct PlannedProgram {
    std::string name;
    PlanRecord record;
    std::vector<std::string> lines;
    std::string table;
    JudgedSetup judged;
    std::vector<CanonEvent> events;
    StockLeft left;
};

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += line + "\n";
    return text;
}

/// The machine's zero is 200 mm over that of G54, and somewhere else again over that of G55.
constexpr const char* kOffsets = "5221\t-1\n5222\t-2\n5223\t-7.874\n5241\t1\n5243\t-3.5\n";

/// What the last program may have left a controller in; the second needs a tool of its own, and no change of
/// planes.
constexpr const char* kLeftBefore = "G20 G18 G91 G93 G55 G64 G99\n";
constexpr const char* kLeftCompensated = "G17 G21 G41.1 D3\n";

/// A program on a controller that the last one left in another state: what it does not set itself shows.
SecondReader secondReader(const std::vector<std::string>& lines, const std::string& table,
                          const std::string& left_before = kLeftBefore) {
    return SecondReader(left_before + joined(lines), table, kOffsets);
}

/// How a program fares that runs as planned on one controller, on one with cutter compensation left on.
enum class Alone { Stands, IsRefused, RunsOtherwise };
Alone standsAlone(const std::vector<std::string>& lines, const std::string& table,
                  const std::vector<CanonEvent>& events) {
    const SecondReader reader = secondReader(lines, table, kLeftCompensated);
    if (reader.exit_code != 0) return Alone::IsRefused;
    return sameRun(canonEvents(reader.output), events) ? Alone::Stands : Alone::RunsOtherwise;
}

/// What our reader refuses by design although it may change nothing
/// [docs/adr/0008-the-reader-is-a-controller.md]: other zeros, and words after the program's end.
bool isBeyond(const std::vector<std::string>& lines) {
    const auto has = [](const std::string& line, const char* words) {
        return line.find(words) != std::string::npos;
    };
    bool ended = false;
    for (const std::string& line : lines) {
        if (has(line, "G92") || (ended && !line.empty() && line.front() != '(')) return true;
        ended = ended || has(line, "M30");
    }
    return false;
}

/// Thin cuts of a rated operation go faster than its feed, by so much and no faster than the machine.
double highestFeed(const RecordedOperation& operation, const Machine& machine) {
    const double feed =
        std::max(operation.feed_mm_per_min, operation.tool.isDrill() ? operation.plunge_feed_mm_per_min : 0);
    if (!operation.rating) return feed;
    const double thinned = kMostChipThinning * feed;
    return machine.max_feed_mm_per_min > 0 ? std::min(thinned, machine.max_feed_mm_per_min) : thinned;
}

JudgedSetup judgedSetup(const PlanRecord& record) {
    const RecordedSetup& setup = record.setups.front();
    JudgedSetup judged;
    for (const std::string& id : setup.operation_ids) {
        const RecordedOperation& operation = record.operations.at(id);
        judged.operations[id] = {operation.tool.number,
                                 profileOf(operation.tool),
                                 operation.speed_rpm,
                                 highestFeed(operation, record.machine),
                                 operation.coolant == Coolant::Mist,
                                 operation.coolant == Coolant::Flood};
    }
    for (int i = 0; i < 3; ++i)
        judged.stock_mm[static_cast<std::size_t>(i)] = setup.stock_size_mm[i];
    for (const Fixture& fixture : setup.fixtures)
        judged.safe_z_mm = std::max(judged.safe_z_mm, fixture.top_z_mm);
    judged.length_mm_per_tool = kInchesATool * kMillimetresPerInch;
    judged.travel_mm = record.machine.travel_mm;
    judged.glide_feed_mm_per_min = glideFeedMmPerMin(record.machine);
    return judged;
}

/// Tables are in inches.
std::string tableOf(const PlanRecord& record) {
    std::map<int, std::string> rows;
    for (const auto& [id, operation] : record.operations)
        rows[operation.tool.number] = fmt::format("T{0} P{0} Z{1:.1f} D0.1 ;\n", operation.tool.number,
                                                  kInchesATool * operation.tool.number);
    std::string table;
    for (const auto& [number, row] : rows)
        table += row;
    return table;
}

std::optional<PlannedProgram> planned(const std::string& part) {
    const PlannedPart plan = plannedPart(part);
    EXPECT_LE(plan.run.exit_code, 1) << part << ": " << plan.run.err;
    if (plan.run.exit_code > 1) return std::nullopt;
    const auto [files, record] = readPlan(plan.folder, std::nullopt, kTol);
    PlannedProgram program;
    program.name = std::filesystem::path(part).stem().string();
    program.record = record;
    if (program.record.setups.empty() || program.record.setups.front().operation_ids.empty())
        return std::nullopt;
    std::istringstream text(files.programs.at(program.record.setups.front().id).front().text);
    for (std::string line; std::getline(text, line);)
        program.lines.push_back(line);
    program.table = tableOf(program.record);
    program.judged = judgedSetup(program.record);
    const SecondReader reader = secondReader(program.lines, program.table);
    EXPECT_EQ(reader.exit_code, 0) << reader.refusal;
    program.events = canonEvents(reader.output);
    program.left = leftBy(program.events, program.judged);
    EXPECT_EQ(standsAlone(program.lines, program.table, program.events), Alone::Stands) << program.name;
    EXPECT_EQ(worseThan(program.left, program.events, program.judged), "")
        << program.name << " as it was planned";
    return program;
}

/// Why verify does not take the program; empty: it does.
std::string caught(const PlannedProgram& program, const std::vector<std::string>& lines) {
    try {
        const ReadProgram read = readProgram(joined(lines), "S1.ngc", Dialect::LinuxCnc);
        Verification verification;
        verifySetup(program.record, program.record.setups.front(), {read}, kTol, verification);
        if (verification.proven()) return {};
        const ProofFailure& first = verification.failures.front();
        EXPECT_FALSE(first.file.empty());
        return fmt::format("line {}: {}", first.line, first.text);
    } catch (const Error& error) {
        EXPECT_NE(error.code(), ErrorCode::Internal) << error.what();
        return error.what();
    }
}

/// How a judge sees an edit.
enum class Judged { Refused, Worse, Same, Other };
constexpr const char* kJudged[] = {"refused", "worse", "same", "other"};

struct Table {
    int count[kEditKinds][4][2] = {};

    void print() const {
        fmt::print("{:<16}{:>18}{:>18}{:>18}{:>18}\n", "caught/accepted", kJudged[0], kJudged[1], kJudged[2],
                   kJudged[3]);
        int sum[4][2] = {};
        for (int kind = 0; kind < kEditKinds; ++kind) {
            fmt::print("{:<16}", toString(static_cast<EditKind>(kind)));
            for (int judged = 0; judged < 4; ++judged) {
                fmt::print("{:>12} /{:>4}", count[kind][judged][1], count[kind][judged][0]);
                for (int is_caught = 0; is_caught < 2; ++is_caught)
                    sum[judged][is_caught] += count[kind][judged][is_caught];
            }
            fmt::print("\n");
        }
        fmt::print("{:<16}", "all");
        for (const auto& one : sum)
            fmt::print("{:>12} /{:>4}", one[1], one[0]);
        fmt::print("\n");
    }
};

void judgeOne(const PlannedProgram& program, unsigned seed, Table& table) {
    std::mt19937 random(seed);
    const ProgramEdit edit = editProgram(program.lines, random);
    const SecondReader reader = secondReader(edit.lines, program.table);
    Judged judged = Judged::Refused;
    std::string why = reader.refusal;
    if (reader.exit_code == 0) {
        const std::vector<CanonEvent> events = canonEvents(reader.output);
        why.clear();
        if (sameRun(events, program.events)) {
            const Alone alone = standsAlone(edit.lines, program.table, events);
            judged = isBeyond(edit.lines) || alone == Alone::IsRefused ? Judged::Other
                     : alone == Alone::Stands                          ? Judged::Same
                                                                       : Judged::Worse;
            if (judged == Judged::Worse) why = "relies on what the last program left";
        } else {
            why = worseThan(program.left, events, program.judged);
            judged = why.empty() ? Judged::Other : Judged::Worse;
        }
    }
    const std::string complaint = caught(program, edit.lines);
    ++table.count[static_cast<int>(edit.kind)][static_cast<int>(judged)][complaint.empty() ? 0 : 1];
    const std::string where =
        fmt::format("seed {}, {}, {}: {}\n  judged {}: {}\n  verify: {}", seed, program.name,
                    toString(edit.kind), edit.what, kJudged[static_cast<int>(judged)], why, complaint);
    if (judged == Judged::Refused || judged == Judged::Worse) {
        EXPECT_NE(complaint, "") << where;
    } else if (judged == Judged::Same) {
        EXPECT_EQ(complaint, "") << where;
    } else if (std::getenv("STEPMILL_TELL_OTHERS") != nullptr) {
        fmt::print("{}\n", where);
    }
}

TEST(ProgramMutations, ThatMatterAreCaughtAndOthersAreAccepted) {
    STEPMILL_NEEDS_SECOND_READER();
    std::vector<PlannedProgram> programs;
    for (const std::string& part : parts())
        if (auto program = planned(part)) programs.push_back(std::move(*program));
    ASSERT_FALSE(programs.empty());
    Table table;
    for (int seed = 1; seed <= numberOfMutations(); ++seed)
        judgeOne(programs[static_cast<std::size_t>(seed) % programs.size()], static_cast<unsigned>(seed),
                 table);
    fmt::print("{} programs\n", programs.size());
    table.print();
}

}  // namespace
}  // namespace stepmill::test
