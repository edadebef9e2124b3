#include <fmt/core.h>

#include "commands.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"

namespace stepmill {

namespace {

int validateLibrary(const std::string& file) {
    const std::vector<std::string> errors = findLibraryErrors(file);
    for (const std::string& line : errors)
        fmt::print(stderr, "{}\n", line);
    if (!errors.empty()) return kBadInput;

    const ToolLibrary library = readToolLibrary(file);
    for (const std::string& pointer : library.unknown_fields)
        fmt::print(stderr, "{}{}: a field Stepmill does not know; kept aside\n", library.file, pointer);
    fmt::print("{}: {} tools, all in order\n", library.file, library.tools.size());
    return kComplete;
}

}  // namespace

void addToolsCommand(CLI::App& app, int& exit_code) {
    CLI::App* tools = app.add_subcommand("tools", "Look after tool libraries");
    tools->require_subcommand(1);
    CLI::App* check =
        tools->add_subcommand("validate", "Check a tool library and say all that is wrong with it");
    auto file = std::make_shared<std::string>();
    check->add_option("FILE", *file, "tool library (JSON)")->required();
    check->footer("Example: stepmill tools validate samples/shop_metric_tools.json");
    check->callback([file, &exit_code] { exit_code = validateLibrary(*file); });
}

}  // namespace stepmill
