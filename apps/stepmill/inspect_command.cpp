#include <filesystem>

#include <fmt/core.h>

#include "commands.h"
#include "options.h"
#include "output.h"
#include "run.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/report/curves.h"
#include "stepmill/report/inspection.h"

namespace stepmill {

namespace {

namespace fs = std::filesystem;

struct InspectOptions {
    PlanOptions part;
    bool curves = false;
    double to_mm = 0;  ///< 0: a little beyond the widest cutter that any feature holds
};

/// Writes pages of one of several parts, or of the only one.
void writePages(JobWriter by, const Part& part, std::size_t parts, std::vector<NewFile> files,
                JobFolder& folder) {
    const NewJob pages{by, part.file, part.sha256, "", std::move(files), {}};
    if (parts == 1) return folder.write(pages);
    JobFolder(folder.path() / fmt::format("solid-{}", part.solid_index)).write(pages);
}

/// Cutters that mill, of the library the plan would use.
double smallestCutterMm(const InspectOptions& options) {
    const ToolLibrary library =
        options.part.tools_file.empty()
            ? defaultToolLibrary()
            : readToolLibrary(options.part.tools_file, options.part.limits.maxFileBytes());
    double smallest_mm = std::numeric_limits<double>::infinity();
    for (const ToolAssembly& tool : library.tools)
        if (!tool.isForHoles()) smallest_mm = std::min(smallest_mm, tool.diameter_mm);
    return std::isfinite(smallest_mm) ? smallest_mm : 0;
}

/// As for plan: 0 all can be cut, 1 something stays or the input is in doubt, 3 the books do not close.
int exitCodeOf(const Inspection& inspection, const Tolerances& tol) {
    const InspectedBooks& books = inspection.books;
    if (books.gapShare() > tol.volume_share) {
        const auto worst = std::max_element(inspection.setups.begin(), inspection.setups.end(),
                                            [](const InspectedSetup& a, const InspectedSetup& b) {
                                                return std::abs(a.gap_mm3) < std::abs(b.gap_mm3);
                                            });
        tell("{}: the volume books miss {:.3g} % of stock minus part; most in {}, {:.4g} mm3",
             inspection.part.file, 100 * books.gapShare(), worst->setup.id, worst->gap_mm3);
        return kBug;
    }
    double left_mm3 = 0;
    for (const ReasonVolume& left : books.left)
        left_mm3 += left.volume_mm3;
    const bool doubtful = std::any_of(
        inspection.part.remarks.begin(), inspection.part.remarks.end(),
        [](const Remark& remark) { return remark.code == "unit-doubt" || remark.code == "input-doubt"; });
    const double rounding = std::max(kVolumeRoundingMm3, tol.volume_share * books.stock_minus_part_mm3);
    return left_mm3 > rounding || doubtful ? kGaps : kComplete;
}

/// stdout gets the text or the JSON; files are written where they were asked for.
int inspectParts(const InspectOptions& options, Workplace& place) {
    const Tolerances tol;
    ProgressLine& progress = place.progress;
    progress.showImport(options.part.part_file);
    const std::vector<Part> parts = chooseParts(options.part);
    reportImport(parts, options.part);
    InspectRequest request;
    request.setup = setupRequest(options.part);
    request.smallest_cutter_mm = smallestCutterMm(options);
    int exit_code = kComplete;
    for (const Part& part : parts) {
        const Inspection inspection = inspectPart(
            part, request, tol, [&](const std::string& stage, double share) { progress.show(stage, share); });
        if (place.folder != nullptr) {
            progress.show("writing the pages", 0.9);
            writePages(JobWriter::Inspect, part, parts.size(),
                       {{"inspect.json", "", inspectionJson(inspection)},
                        {"inspect.html", "", inspectionHtml(inspection)}},
                       *place.folder);
        }
        progress.show("done", 1);
        if (options.part.json)
            printData(inspectionJson(inspection));
        else
            printOut(inspectionText(inspection));
        exit_code = std::max(exit_code, exitCodeOf(inspection, tol));
    }
    return exit_code;
}

PartCurves curvesOf(const Part& part, const InspectOptions& options, const Tolerances& tol,
                    ProgressLine& progress) {
    CurvesRequest request;
    request.setup = setupRequest(options.part);
    request.to_mm = options.to_mm;
    return findCurves(part, request, tol,
                      [&](const std::string& stage, double share) { progress.show(stage, share); });
}

int inspectAll(const InspectOptions& options, const fs::path& out_folder, Workplace& place) {
    const Tolerances tol;
    place.progress.showImport(options.part.part_file);
    const std::vector<Part> parts = chooseParts(options.part);
    reportImport(parts, options.part);
    for (const Part& part : parts) {
        const PartCurves curves = curvesOf(part, options, tol, place.progress);
        place.progress.show("writing the curves", 1);
        writePages(JobWriter::Curves, part, parts.size(),
                   {{"curves.csv", "", curvesCsv(curves)}, {"curves.html", "", curvesHtml(curves)}},
                   *place.folder);
        fs::path folder = out_folder;
        if (parts.size() > 1) folder /= fmt::format("solid-{}", part.solid_index);
        printOut(fmt::format("{}: {} features, curves in {}\n", part.name, curves.features.size(),
                             (folder / "curves.html").string()));
    }
    return kComplete;
}

int runInspect(const InspectOptions& options) {
    if (!options.curves)
        return runInChild(taskOf(options.part, options.part.out_dir),
                          [&](Workplace& place) { return inspectParts(options, place); });
    const fs::path folder = outputFolder(options.part, "-curves");
    return runInChild(taskOf(options.part, folder),
                      [&](Workplace& place) { return inspectAll(options, folder, place); });
}

}  // namespace

void addInspectCommand(CLI::App& app, int& exit_code) {
    CLI::App* inspect = app.add_subcommand(
        "inspect", "Show a part's setups, features, holes, faces and volume books, without planning tools");
    auto options = std::make_shared<InspectOptions>();
    addPartOptions(*inspect, options->part, "-curves");
    inspect->add_flag("--json", options->part.json, "print inspect.json instead of the text");
    addImportOption(*inspect, options->part);
    inspect->add_option("--tools", options->part.tools_file,
                        "tool library; its smallest cutter tells an engraving from a pocket");
    inspect->add_flag("--curves", options->curves,
                      "write curves.csv and curves.html: accessible volume against diameter");
    inspect->add_option("--to", options->to_mm, "largest diameter [mm]; default: what still fits somewhere")
        ->check(numberFrom(0.01, 1000, "mm"));
    inspect->footer(
        "Without --curves, -o DIR writes inspect.json and inspect.html there; nothing is written without "
        "it.\n"
        "Examples:\n"
        "  stepmill inspect bracket.step\n"
        "  stepmill inspect bracket.step --json\n"
        "  stepmill inspect bracket.step --report-import\n"
        "  stepmill inspect bracket.step -o bracket-inspect\n"
        "  stepmill inspect bracket.step --curves\n"
        "  stepmill inspect bracket.step --curves -o curves --setup +z --to 25");
    inspect->callback([options, &exit_code] { exit_code = runInspect(*options); });
}

}  // namespace stepmill
