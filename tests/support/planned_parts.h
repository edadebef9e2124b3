#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/run_program.h"

namespace stepmill::test {

/// What `stepmill plan` said of a part, and the job folder it wrote (missing where the part was refused).
struct PlannedPart {
    ProgramRun run;
    std::filesystem::path folder;
};

/// Plans a part with the program under test, or takes the plan that another test has made.
///
/// Plans are kept in the build folder ("planned_parts") until the program changes. Tests that run side by
/// side wait for each other. Nobody writes into such a folder: copyOfPlan() is for tests that spoil theirs.
/// \param options  of the command line, without the part, -o and --timeout
PlannedPart plannedPart(const std::string& part, const std::vector<std::string>& options = {});

/// The plan's files in a folder of the test's own, which must not exist; the part must have a plan.
void copyOfPlan(const std::string& part, const std::filesystem::path& folder,
                const std::vector<std::string>& options = {});

/// What finishing passes are tested with.
inline const std::vector<std::string> kWithAllowance{"--finish-walls", "0.3", "--finish-floors", "0.2"};

}  // namespace stepmill::test
