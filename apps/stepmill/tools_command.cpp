#include <filesystem>

#include <fmt/core.h>

#include "commands.h"
#include "crib_command.h"
#include "output.h"
#include "run.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/crib/tool_squawks.h"
#include "stepmill/report/tool_page.h"

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

int listTools(const std::string& file, std::uintmax_t max_bytes) {
    printOut(toolListText(readToolLibrary(file, max_bytes)));
    return kComplete;
}

/// A library with what no one measured of it.
struct OpenLibrary {
    ToolLibrary library;
    FilledFields filled;
};

OpenLibrary openLibrary(const std::string& file, std::uintmax_t max_bytes) {
    const std::string text = readFile(file, max_bytes);
    return {toolLibraryFromText(text, std::filesystem::path(file).filename().string()), filledFieldsIn(text)};
}

int checkTools(const std::string& file, std::uintmax_t max_bytes) {
    const auto [library, filled] = openLibrary(file, max_bytes);
    const std::vector<ToolSquawk> squawks = toolSquawks(library, filled);
    for (const ToolSquawk& squawk : squawks)
        printOut(fmt::format("{:<8} {}{}{}\n", wordOf(kSquawkGrades, squawk.grade), squawk.tool,
                             squawk.tool.empty() ? "" : ": ", squawk.text));
    const bool any_danger = !squawks.empty() && squawks.front().grade == SquawkGrade::Danger;
    printOut(fmt::format("{}: {} tools, {} squawks\n", library.file, library.tools.size(), squawks.size()));
    return any_danger ? kGaps : kComplete;
}

struct ShowOptions {
    std::string file;
    std::string tool;
    std::string picture;
};

/// By name or by number: "EM12", "5", "T5".
const ToolAssembly& chosenTool(const ToolLibrary& library, const std::string& wanted) {
    for (const ToolAssembly& tool : library.tools)
        if (tool.id == wanted) return tool;
    for (const ToolAssembly& tool : library.tools)
        if (wanted == std::to_string(tool.number) || wanted == fmt::format("T{}", tool.number)) return tool;
    throw Error(ErrorCode::Usage, "ID",
                fmt::format("expected a tool of {} by its id or number, found '{}'; tools list names them",
                            library.file, wanted.substr(0, 40)));
}

int showTool(const ShowOptions& options, std::uintmax_t max_bytes) {
    const auto [library, filled] = openLibrary(options.file, max_bytes);
    const ToolAssembly& tool = chosenTool(library, options.tool);
    const auto fields = filled.find(tool.id);
    if (!options.picture.empty()) writeFile(options.picture, toolSvg(tool));
    printOut(toolText(tool, fields == filled.end() ? std::vector<FilledField>{} : fields->second));
    return kComplete;
}

using LibraryWork = int (*)(const std::string&, std::uintmax_t);

/// A command on a library alone.
void addLibraryCommand(CLI::App& tools, int& exit_code, const char* name, const char* what,
                       LibraryWork work) {
    CLI::App* command = tools.add_subcommand(name, what);
    auto file = std::make_shared<std::string>();
    command->add_option("FILE", *file, "tool library (JSON)")->required();
    command->footer(fmt::format("Example: stepmill tools {} samples/shop_metric_tools.json", name));
    auto limits = std::make_shared<RunLimits>();
    addLimitOptions(*command, *limits);
    command->callback([file, limits, work, &exit_code] {
        exit_code = runInChild({*file, *limits}, [&](Workplace& place) {
            place.progress.show("reading the library", 0);
            return work(*file, limits->maxFileBytes());
        });
    });
}

void addShowCommand(CLI::App& tools, int& exit_code) {
    CLI::App* show = tools.add_subcommand("show", "All that a library says of a tool, and its picture");
    auto options = std::make_shared<ShowOptions>();
    show->add_option("FILE", options->file, "tool library (JSON)")->required();
    show->add_option("ID", options->tool, "its id or number")->required();
    show->add_option("-o,--output", options->picture, "write a picture to scale to this file (SVG)");
    show->footer("Example: stepmill tools show samples/shop_metric_tools.json EM12 -o em12.svg");
    auto limits = std::make_shared<RunLimits>();
    addLimitOptions(*show, *limits);
    show->callback([options, limits, &exit_code] {
        exit_code = runInChild({options->file, *limits}, [&](Workplace& place) {
            place.progress.show("reading the library", 0);
            return showTool(*options, limits->maxFileBytes());
        });
    });
}

}  // namespace

void addToolsCommand(CLI::App& app, int& exit_code) {
    CLI::App* tools = app.add_subcommand("tools", "Look after tool libraries");
    tools->require_subcommand(1);
    addLibraryCommand(*tools, exit_code, "validate", "Check a tool library and say all that is wrong with it",
                      validateLibrary);
    addLibraryCommand(*tools, exit_code, "list", "List the tools of a library", listTools);
    addLibraryCommand(*tools, exit_code, "check",
                      "Say what to heed in a valid library, graded; exit code 1 where something may collide",
                      checkTools);
    addShowCommand(*tools, exit_code);
    addImportCommand(*tools, exit_code);
    addExportCommand(*tools, exit_code);
}

}  // namespace stepmill
