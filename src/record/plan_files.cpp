// A plan.json with the programs that belong to it.

#include "stepmill/record/plan_files.h"

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/record/plan_json.h"

namespace stepmill {
namespace {

constexpr const char* kPlanFile = "plan.json";

/// "S1-2-T5.nc" is the second of S1: its number, 0 for other names.
int visitOf(const std::string& file, const std::string& setup_id, Dialect dialect) {
    const std::string begin = setup_id + "-";
    if (!file.starts_with(begin) || !file.ends_with(programName("", dialect))) return 0;
    return std::atoi(file.c_str() + begin.size());
}

/// The setup's program of that name, or those for every visit of a tool: none where nothing is cut.
std::vector<PostedProgram> programsIn(const std::filesystem::path& dir, const std::string& whole,
                                      const RecordedSetup& setup, Dialect dialect, std::uintmax_t max_bytes) {
    if (std::filesystem::exists(dir / whole)) return {{whole, readFile(dir / whole, max_bytes), {}}};
    std::map<int, std::string> visits;
    for (const auto& entry : std::filesystem::directory_iterator(dir)) {
        const std::string name = entry.path().filename().string();
        const int visit = visitOf(name, setup.id, dialect);
        if (visit > 0) visits[visit] = name;
    }
    if (visits.empty() && setup.hasProgram())
        return {{whole, readFile(dir / whole, max_bytes), {}}};  // which says what is missing
    std::vector<PostedProgram> programs;
    for (const auto& [visit, name] : visits)
        programs.push_back({name, readFile(dir / name, max_bytes), {}});
    return programs;
}

}  // namespace

PlanFiles postedFiles(const Plan& plan) {
    PlanFiles files;
    files.plan_json = planJson(plan);
    files.dialect = dialectOf(plan.machine);
    for (const PlannedSetup& setup : plan.setups)
        if (setup.operations.empty())
            files.programs[setup.setup.id];  // nothing is cut
        else
            files.programs[setup.setup.id] = post(jobOf(plan, setup), {files.dialect});
    return files;
}

RecordedPlan readPlan(const std::filesystem::path& dir, const std::optional<Dialect>& dialect,
                      const Tolerances& tol, std::uintmax_t max_bytes) {
    RecordedPlan plan;
    plan.files.plan_json = readFile(dir / kPlanFile, max_bytes);
    plan.record = planRecordFromText(plan.files.plan_json, tol);
    plan.files.dialect = dialect.value_or(dialectOf(plan.record.machine));
    for (const RecordedSetup& setup : plan.record.setups)
        plan.files.programs[setup.id] =
            programsIn(dir, dialect ? programName(setup.id, *dialect) : setup.program, setup,
                       plan.files.dialect, max_bytes);
    return plan;
}

std::vector<ReadProgram> readPrograms(const PlanFiles& files, const RecordedSetup& setup) {
    const auto found = files.programs.find(setup.id);
    if (found == files.programs.end())
        throw Error(ErrorCode::FileUnreadable, setup.program, "the plan's program is missing");
    std::vector<ReadProgram> programs;
    for (const PostedProgram& program : found->second)
        programs.push_back(readProgram(program.text, program.file, files.dialect));
    return programs;
}

namespace {

/// A level rapid from where the operation before has ended is no part of an operation: it starts where that
/// ends.
bool leadsToStart(const Vec3& start, const Move& move) {
    return move.kind == MoveKind::Rapid && move.to.z() == start.z();
}

JobOperation jobOperation(const RecordedOperation& planned, const ReadOperation& read) {
    JobOperation operation{planned, read.start, {}};
    for (const ReadMove& move : read.moves)
        if (operation.moves.empty() && leadsToStart(operation.start, move.fed.move))
            operation.start = move.fed.move.to;
        else
            operation.moves.push_back(move.fed);
    return operation;
}

}  // namespace

Job jobOf(const PlanRecord& record, const RecordedSetup& setup, const std::vector<ReadProgram>& programs) {
    Job job;
    job.part_name = record.part_name;
    job.part_file = record.part_file;
    job.setup_id = setup.id;
    job.axis_name = setup.axis_name;
    job.material = record.material;
    job.machine = record.machine;
    job.stock_size_mm = setup.stock_size_mm;
    job.stock_tolerance_mm = record.stock.tolerance_mm;
    job.time_s = setup.time_s;
    for (const ReadProgram& program : programs) {
        for (const ReadOperation& read : program.operations) {
            const auto found = record.operations.find(read.id);
            if (found == record.operations.end())
                throw Error(ErrorCode::InvalidCatalog, fmt::format("{}, line {}", program.file, read.line),
                            fmt::format("the plan has no operation '{}'", read.id));
            job.operations.push_back(jobOperation(found->second, read));
        }
    }
    return job;
}

}  // namespace stepmill
