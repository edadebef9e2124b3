#include <filesystem>

#include <fmt/core.h>

#include "commands.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"

namespace stepmill {

namespace {

int validateLibrary(const std::string& file) {
    const std::string name = std::filesystem::path(file).filename().string();
    bool broken = false;
    for (const CatalogFinding& finding : checkToolLibrary(file)) {
        fmt::print(stderr, "{}{}: {}{}\n", name, finding.pointer, finding.doubt ? "doubtful: " : "", finding.text);
        broken = broken || !finding.doubt;
    }
    if (broken) return kBadInput;
    fmt::print("{}: {} tools, all in order\n", name, readToolLibrary(file).tools.size());
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
