#include "crib_command.h"

#include <filesystem>

#include <fmt/core.h>

#include "commands.h"
#include "output.h"
#include "run.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/catalog/write_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/crib/export_tools.h"
#include "stepmill/crib/import_tools.h"
#include "stepmill/crib/read_foreign.h"

namespace stepmill {

namespace {

namespace fs = std::filesystem;

/// Of --cutting-data: the table that is compiled in.
constexpr const char* kUsualWord = "usual";

struct CribOptions {
    std::string file;
    std::string output;
    std::string format;
    std::string unit;
    std::string cutting_data;
    std::vector<std::string> columns;
    std::vector<std::string> materials;
    bool leave_out = false;
    RunLimits limits;
};

/// "FIELD=HEAD" words as a map.
std::map<std::string, std::string> pairsOf(const std::vector<std::string>& words, const std::string& option) {
    std::map<std::string, std::string> pairs;
    for (const std::string& word : words) {
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos || equals == 0 || equals + 1 == word.size())
            throw Error(ErrorCode::Usage, option,
                        fmt::format("expected two words with '=' between, found '{}'", word.substr(0, 60)));
        pairs[word.substr(0, equals)] = word.substr(equals + 1);
    }
    return pairs;
}

CribFormat formatOf(const CribOptions& options) {
    if (!options.format.empty()) return cribFormatFrom(options.format).value();
    if (const auto format = cribFormatOf(options.file)) return *format;
    throw Error(
        ErrorCode::Usage, options.file,
        "expected .json, .tools, .hsmlib, .fctb, .fctl, .tbl, .csv or a folder; --format says what it is");
}

ForeignOptions foreignOptions(const CribOptions& options) {
    ForeignOptions foreign;
    foreign.unit = options.unit;
    foreign.columns = pairsOf(options.columns, "--column");
    foreign.materials = pairsOf(options.materials, "--material");
    foreign.leave_out = options.leave_out;
    foreign.max_file_bytes = options.limits.maxFileBytes();
    return foreign;
}

std::optional<UsualValues> usualValues(const CribOptions& options) {
    if (options.cutting_data.empty()) return std::nullopt;
    if (options.cutting_data == kUsualWord) return builtInUsualValues();
    return readUsualValues(options.cutting_data, options.limits.maxFileBytes());
}

int importLibrary(const CribOptions& options) {
    const std::optional<UsualValues> usual = usualValues(options);
    const ForeignLibrary foreign = readForeign(options.file, formatOf(options), foreignOptions(options));
    const ImportedLibrary imported = importTools(foreign, usual ? &*usual : nullptr);
    const std::string text =
        toolLibraryJson(imported.library, "imported from " + imported.library.file, imported.filled());
    // What is written is what plans will read.
    const ToolLibrary written = toolLibraryFromText(text, fs::path(options.output).filename().string());
    writeFile(options.output, text);
    printOut(importText(imported));
    printOut(fmt::format("{}: {} tools written\n", options.output, written.tools.size()));
    return imported.complete() ? kComplete : kGaps;
}

/// Each file is complete or absent.
void writeFolder(const fs::path& folder, const std::vector<CribFile>& files) {
    std::error_code trouble;
    fs::create_directories(folder, trouble);
    if (trouble) throw Error(ErrorCode::OutputUnwritable, folder.string(), trouble.message());
    for (const CribFile& file : files)
        writeFile(folder / file.name, file.bytes);
}

int exportLibrary(const CribOptions& options) {
    const ToolLibrary library = readToolLibrary(options.file, options.limits.maxFileBytes());
    const CribFormat format = cribFormatFrom(options.format).value();
    if (format == CribFormat::FreeCad)
        writeFolder(options.output, freeCadFiles(library, fs::path(options.file).stem().string()));
    else
        writeFile(options.output,
                  format == CribFormat::LinuxCnc ? linuxCncTable(library) : fusionJson(library));
    printOut(
        fmt::format("{}: {} tools written for {}\n", options.output, library.tools.size(), options.format));
    return kComplete;
}

template <typename Work>
void runOn(CLI::App& command, const std::shared_ptr<CribOptions>& options, const char* stage, int& exit_code,
           Work work) {
    addLimitOptions(command, options->limits);
    command.callback([options, stage, work, &exit_code] {
        exit_code = runInChild({options->file, options->limits}, [&](Workplace& place) {
            place.progress.show(stage, 0);
            return work(*options);
        });
    });
}

}  // namespace

void addImportCommand(CLI::App& tools, int& exit_code) {
    CLI::App* import = tools.add_subcommand("import", "Make a tool library from another program's");
    auto options = std::make_shared<CribOptions>();
    import
        ->add_option("FILE", options->file,
                     "Fusion .json or .tools, .hsmlib, FreeCAD .fctb, .fctl or folder, LinuxCNC .tbl, .csv")
        ->required();
    import->add_option("-o,--output", options->output, "tool library to write (JSON)")->required();
    import->add_option("--format", options->format, "what FILE is, whatever its name says")
        ->check(CLI::IsMember({"fusion", "fusion-zip", "hsm", "freecad", "linuxcnc", "csv"}));
    import->add_option("--unit", options->unit, "of the lengths, where the file is silent")
        ->check(CLI::IsMember({"mm", "inch"}));
    import->add_option("--cutting-data", options->cutting_data,
                       "fill what the file does not say from this table (JSON); usual: the one built in");
    import->add_option("--column", options->columns, "FIELD=HEAD: which column of a CSV is which field")
        ->allow_extra_args(false);
    import->add_option("--material", options->materials, "PRESET=MATERIAL: what a preset's material is here")
        ->allow_extra_args(false);
    import->add_flag("--leave-out", options->leave_out,
                     "leave out tools without a diameter instead of ending");
    import->footer(
        "Exit code 1: written, but tools were left out. What a file does not say is listed, never made up.\n"
        "Examples:\n"
        "  stepmill tools import library.tools -o shop.json --material 'Aluminum - Wrought=aluminium'\n"
        "  stepmill tools import tool.tbl -o shop.json --unit inch --cutting-data usual\n"
        "  stepmill tools import tools.csv -o shop.json --unit mm --column diameter=Dia --column type=Kind");
    runOn(*import, options, "importing tools", exit_code, importLibrary);
}

void addExportCommand(CLI::App& tools, int& exit_code) {
    CLI::App* command = tools.add_subcommand("export", "Write a tool library as another program reads it");
    auto options = std::make_shared<CribOptions>();
    command->add_option("FILE", options->file, "tool library (JSON)")->required();
    command->add_option("-o,--output", options->output, "file to write; of freecad a folder")->required();
    command->add_option("--format", options->format, "the program that will read it")
        ->check(CLI::IsMember({"fusion", "freecad", "linuxcnc"}))
        ->required();
    command->footer("Example: stepmill tools export shop.json --format linuxcnc -o tool.tbl");
    runOn(*command, options, "exporting tools", exit_code, exportLibrary);
}

}  // namespace stepmill
