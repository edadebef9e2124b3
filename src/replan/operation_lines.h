#pragma once

#include <map>
#include <string>
#include <vector>

#include "stepmill/record/plan_files.h"

namespace stepmill::replan {

/// The lines of each operation by its id, without block numbers, which count on over the whole program, and
/// without where it stands when its tool is changed, which the operation before tells.
using LinesById = std::map<std::string, std::vector<std::string>>;

/// \throws what readPrograms does
LinesById operationLines(const PlanFiles& files, const RecordedSetup& setup);

/// How many lines both have at their beginnings and ends.
int linesKept(const std::vector<std::string>& before, const std::vector<std::string>& after);

}  // namespace stepmill::replan
