#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/core/file.h"

namespace stepmill {

/// One thing wrong or doubtful in a catalog file.
struct CatalogFinding {
    std::string pointer;  ///< JSON pointer as a URI fragment, "#/tools/3/diameter"
    std::string text;     ///< what was expected and what was found
    bool doubt = false;   ///< the file can still be used
};

/// All that is wrong or doubtful in a tool library, in the order syntax, schema, rules, doubts; each stage
/// only when the one before found nothing.
/// \throws Error(FileUnreadable)
std::vector<CatalogFinding> checkToolLibrary(const std::filesystem::path& path,
                                             std::uintmax_t max_bytes = kMaxFileBytes);

/// Reads a tool library (schemas/tools.schema.json), converts it to mm and checks what a schema cannot
/// say: ids and numbers unique, corner radius no larger than the radius, holder cylinders from below to
/// above, step-over no larger than the diameter, flutes no longer than the stick-out.
/// \throws Error(InvalidCatalog) with "file#/json/pointer" as subject and what was expected;
///         Error(FileUnreadable).
ToolLibrary readToolLibrary(const std::filesystem::path& path, std::uintmax_t max_bytes = kMaxFileBytes);

/// All that is wrong in a library, one line each ("#/tools/3/diameter: ..."), for `stepmill tools validate`.
/// Empty when readToolLibrary() takes it; checkToolLibrary() tells the doubts too.
/// \throws Error(FileUnreadable)
std::vector<std::string> findLibraryErrors(const std::filesystem::path& path);

/// Reads a machine file (schemas/machine.schema.json). Same errors.
Machine readMachine(const std::filesystem::path& path, std::uintmax_t max_bytes = kMaxFileBytes);

/// The same from text already in memory. `file_name` is what error messages and ToolLibrary::file say.
ToolLibrary toolLibraryFromText(std::string_view text, const std::string& file_name);
Machine machineFromText(std::string_view text, const std::string& file_name);

/// The library and machine a run uses when none are named; compiled in from samples/.
ToolLibrary defaultToolLibrary();
Machine defaultMachine();

}  // namespace stepmill
