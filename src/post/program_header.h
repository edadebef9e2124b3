#pragma once

#include <string>
#include <vector>

#include "stepmill/post/post.h"

namespace stepmill {

/// A length in the program's unit, without the unit's name.
std::string lengthText(double value_mm, bool inch);
/// "mm" or "inch".
const char* unitName(bool inch);

/// The tools of a job by number, each once.
/// \throws Error(InvalidCatalog) when two have one number
std::vector<const ToolAssembly*> toolsOf(const Job& job);

/// Comments that head a program: what it is for, its tools, and where each operation starts.
std::string programHeader(const Job& job, const std::vector<StartBlock>& starts, bool inch);

/// The comment an operation begins with; verify knows it by this.
std::string operationComment(const JobOperation& operation, bool inch);

}  // namespace stepmill
