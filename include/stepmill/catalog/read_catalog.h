#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"

namespace stepmill {

/// Reads a tool library (schemas/tools.schema.json), converts it to mm and checks what a schema cannot
/// say: ids and numbers unique, corner radius no larger than the radius, holder cylinders from below to
/// above, step-over no larger than the diameter, flutes no longer than the stick-out.
/// \throws Error(InvalidCatalog) with "file#/json/pointer" as subject and what was expected;
///         Error(FileUnreadable).
ToolLibrary readToolLibrary(const std::filesystem::path& path);

/// All that is wrong or doubtful in a library, one line each ("#/tools/3/diameter: ..."), for
/// `stepmill tools validate`. Empty when it is fine. \throws Error(FileUnreadable)
std::vector<std::string> findLibraryErrors(const std::filesystem::path& path);

/// Reads a machine file (schemas/machine.schema.json). Same errors.
Machine readMachine(const std::filesystem::path& path);

/// The library and machine a run uses when none are named; compiled in from samples/.
ToolLibrary defaultToolLibrary();
Machine defaultMachine();

}  // namespace stepmill
