#pragma once

#include "options.h"

namespace stepmill {

/// Adds the options of the commands that plan a part and write its job: those of a part, the shop, what is
/// made least, what is printed.
void addJobOptions(CLI::App& command, PlanOptions& options, const std::string& folder_suffix);

/// Plans, proves and writes the parts of the file that were asked for; prints what came of it. Returns the
/// exit code. \throws Error as the stages do
int runPlan(const PlanOptions& options);

}  // namespace stepmill
