#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/core/file.h"
#include "stepmill/post/post.h"
#include "stepmill/post/read_program.h"
#include "stepmill/record/plan_record.h"

namespace stepmill {

/// A plan.json and programs that belong to it.
struct PlanFiles {
    std::string plan_json;
    Dialect dialect = Dialect::LinuxCnc;
    /// Of each setup, by its id: one, or one for every visit of a tool in their order.
    std::map<std::string, std::vector<PostedProgram>> programs;
};

/// The files that a plan is written with: plan.json, and the programs in its machine's dialect.
/// \throws Error(Usage) if there is no post for that dialect; what planJson() and post() throw
PlanFiles postedFiles(const Plan& plan);

/// A plan's files with what its plan.json says, read once.
struct RecordedPlan {
    PlanFiles files;
    PlanRecord record;
};

/// The files `stepmill plan` wrote, or those `stepmill post` wrote beside them.
/// \param dialect    whose programs; none: those plan.json names, or those for every visit of a tool that
///                   post put in their place
/// \param max_bytes  larger files are not read
/// \throws Error(FileUnreadable) naming the file that is missing; what planRecordFromText throws.
RecordedPlan readPlan(const std::filesystem::path& dir, const std::optional<Dialect>& dialect,
                      const Tolerances& tol, std::uintmax_t max_bytes = kMaxFileBytes);

/// Reads a setup's programs back.
/// \throws what readProgram does; Error(FileUnreadable) when there is none.
std::vector<ReadProgram> readPrograms(const PlanFiles& files, const RecordedSetup& setup);

/// Programs of a setup with what the plan knows of it, ready for a post.
/// \throws Error(InvalidCatalog) when they have an operation the plan does not know.
Job jobOf(const PlanRecord& record, const RecordedSetup& setup, const std::vector<ReadProgram>& programs);

}  // namespace stepmill
