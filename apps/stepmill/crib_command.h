#pragma once

#include <CLI/CLI.hpp>

namespace stepmill {

/// `tools import` and `tools export`: libraries of other programs in and out.
void addImportCommand(CLI::App& tools, int& exit_code);
void addExportCommand(CLI::App& tools, int& exit_code);

}  // namespace stepmill
