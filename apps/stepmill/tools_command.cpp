#include <filesystem>

#include <fmt/core.h>

#include "commands.h"
#include "output.h"
#include "run.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"

namespace stepmill {

namespace {

int validateLibrary(const std::string& file, std::uintmax_t max_bytes) {
    const std::string name = std::filesystem::path(file).filename().string();
    bool broken = false;
    for (const CatalogFinding& finding : checkToolLibrary(file, max_bytes)) {
        printErr(fmt::format("{}{}: {}{}\n", name, finding.pointer, finding.doubt ? "doubtful: " : "",
                             finding.text));
        broken = broken || !finding.doubt;
    }
    if (broken) return kBadInput;
    printOut(
        fmt::format("{}: {} tools, all in order\n", name, readToolLibrary(file, max_bytes).tools.size()));
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
    auto limits = std::make_shared<RunLimits>();
    addLimitOptions(*check, *limits);
    check->callback([file, limits, &exit_code] {
        exit_code = runInChild({*file, *limits}, [&](Workplace& place) {
            place.progress.show("checking the library", 0);
            return validateLibrary(*file, limits->maxFileBytes());
        });
    });
}

}  // namespace stepmill
