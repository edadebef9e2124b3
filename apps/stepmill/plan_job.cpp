#include "plan_job.h"

#include <filesystem>

#include <fmt/core.h>

#include "commands.h"
#include "output.h"
#include "run.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/report/offers.h"
#include "stepmill/report/report.h"

namespace stepmill {

namespace {

namespace fs = std::filesystem;

/// Does it say that the part is in doubt, or that something asked for is not done?
bool isGap(const Warning& warning, const Plan& plan) {
    const std::string& code = warning.code;
    if (code == "no-hold") return plan.request.hold.has_value();
    return code == "unit-doubt" || code == "input-doubt" || code == "travel" || code == "sharp-edge";
}

bool hasGaps(const Plan& plan, const PlanOptions& options, const Tolerances& tol) {
    const bool unmet = std::any_of(plan.warnings.begin(), plan.warnings.end(),
                                   [&](const Warning& warning) { return isGap(warning, plan); });
    return !plan.complete(tol) || unmet || !plan.cycle.areMet() || (options.strict && !plan.warnings.empty());
}

}  // namespace

int exitCodeOf(const ProvenPlan& proven, const PlanOptions& options, const Tolerances& tol) {
    if (!proven.mayRun()) return kBug;
    return hasGaps(proven.plan, options, tol) ? kGaps : kComplete;
}

void tellFailures(const ProvenPlan& proven) {
    for (const ProofFailure& failure : proven.verification.failures) {
        const std::string operation = failure.operation.empty() ? "" : failure.operation + " of ";
        const std::string line = failure.line > 0 ? fmt::format(", line {}", failure.line) : "";
        tell("no program is written: {}{}{}: {}", operation, failure.file, line, failure.text);
    }
    if (!proven.mayRun() && proven.verification.failures.empty())
        tell("no program is written: {}: the volume books do not close, which is a bug in Stepmill",
             proven.plan.part.file);
}

namespace {

/// A job's folder as a path from where the user is: below --output, not below where a link there leads.
fs::path asGiven(const JobFolder& folder, const PlanOptions& options) {
    const fs::path given = outputFolder(options, options.folder_suffix);
    const std::string name = folder.path().filename().string();
    std::error_code ignored;
    return fs::equivalent(folder.path(), given, ignored) ? given : given / name;
}

/// What the words of the command line mean for setup sheets.
/// \throws what readJobDetails does
SheetOptions sheetOptions(const PlanOptions& options) {
    SheetOptions sheets;
    if (!options.job_file.empty())
        sheets.job = readJobDetails(options.job_file, options.limits.maxFileBytes());
    sheets.inch = options.display == "inch";
    return sheets;
}

/// What the tools of --buy are worth to a plan; empty without them.
std::vector<OfferWorth> offersFor(const Plan& plan, const PlanOptions& options, const Tolerances& tol) {
    if (options.buy_file.empty()) return {};
    return worthOfOffers(plan, readToolLibrary(options.buy_file, options.limits.maxFileBytes()), tol);
}

/// Plans, proves and writes one part, and tells what came of it.
/// \param time_s  that the run has for it
int planOne(const Part& part, const PlanOptions& options, PlanRequest request, double time_s,
            const Shop& shop, JobFolder& folder, ProgressLine& progress, const PlanListener& listener) {
    const Tolerances tol;
    const SheetOptions sheet_options = sheetOptions(options);
    request.patience = patienceFor(time_s);
    const ProvenPlan proven =
        planProven(part, request, shop.library, shop.machine, tol,
                   [&](const std::string& stage, double share) { progress.show(stage, share); });
    progress.show("writing the report", 1);
    const Sheets sheets = makeSheets(proven, sheet_options, options.pdf, tol);
    const ReportOptions report{sheet_options.inch, options.viewer};
    writePlan(proven, sheets, report, folder, tol);
    if (!sheets.why_no_pdf.empty()) tell("sheets.pdf is not written: {}", sheets.why_no_pdf);
    tellReplacedEdits(folder);
    if (!options.buy_file.empty()) progress.show("what to buy", 1);
    const std::vector<OfferWorth> offers = offersFor(proven.plan, options, tol);
    progress.show("done", 1);
    if (options.json)
        printData(proven.files.plan_json + "\n");
    else
        printOut(fmt::format("{}\nReport: {}\nSheets: {}\n", summaryText(proven.plan),
                             (asGiven(folder, options) / "report.html").string(),
                             (asGiven(folder, options) / "sheets.html").string()));
    if (!options.buy_file.empty() && !options.json)
        printOut(offersText(offers, proven.plan.machine.currency));
    tellFailures(proven);
    if (listener.planned) listener.planned(proven, folder.path(), offers);
    return exitCodeOf(proven, options, tol);
}

NewJob withSolidsOf(const Manifest& before, NewJob job) {
    for (const std::string& solid : before.solids)
        if (std::find(job.solids.begin(), job.solids.end(), solid) == job.solids.end())
            job.solids.push_back(solid);
    return job;
}

/// Each solid is a job of its own, in a folder below; the folder above names them.
int planSolids(const std::vector<Part>& parts, const PlanOptions& options, const PlanRequest& request,
               const Deadline& end, const Shop& shop, Workplace& place, const PlanListener& listener) {
    int exit_code = kComplete;
    NewJob all{JobWriter::Plan, parts.front().file, parts.front().sha256, "", {}, {}};
    const Manifest before = readManifest(place.folder->path()).value_or(Manifest{});
    std::size_t to_do = parts.size();
    for (const Part& part : parts) {
        const double time_s = end.secondsLeft() / static_cast<double>(to_do--);
        all.solids.push_back(fmt::format("solid-{}", part.solid_index));
        JobFolder folder(place.folder->path() / all.solids.back());
        exit_code = std::max(exit_code,
                             planOne(part, options, request, time_s, shop, folder, place.progress, listener));
        place.folder->write(withSolidsOf(before, all));  // a run that is stopped later leaves none unnamed
    }
    place.folder->write(all);
    return exit_code;
}

}  // namespace

int planFile(const PlanOptions& options, Workplace& place, const PlanListener& listener) {
    const Deadline end = Deadline::in(options.limits.timeout_s);
    place.progress.show("reading tools and machine", 0);
    const Shop shop = loadShop(options);
    place.progress.showImport(options.part_file);
    const PlanRequest request = planRequest(options, shop);
    if (!options.buy_file.empty()) readToolLibrary(options.buy_file, options.limits.maxFileBytes());
    sheetOptions(options);  // a job file with a slip of the pen costs no plan
    const std::vector<Part> parts = chooseParts(options);
    if (listener.imported) listener.imported(parts);
    reportImport(parts, options);
    if (parts.size() > 1) return planSolids(parts, options, request, end, shop, place, listener);
    return planOne(parts.front(), options, request, end.secondsLeft(), shop, *place.folder, place.progress,
                   listener);
}

int runPlan(const PlanOptions& options) {
    return runInChild(taskOf(options, outputFolder(options, options.folder_suffix)),
                      [&](Workplace& place) { return planFile(options, place); });
}

void addShopOptions(CLI::App& command, PlanOptions& options) {
    command.add_option("--tools", options.tools_file,
                       "tool library (JSON); default: a metric shop of 24 tools");
    command.add_option("--machine", options.machine_file, "machine (JSON); default: a machining centre");
    command.add_option(
        "--fixtures", options.fixtures_file,
        "what holds the part in each setup, and the shop's vise and blanks (JSON); default: an "
        "ordinary vise");
    command
        .add_option(
            "--hold", options.hold,
            "how setups are held that --fixtures does not name: vise, soft-jaws, screws (through its own "
            "holes), plate (sacrificial), skin (a plate, and 0.3 mm at the bottom stay), tabs (in "
            "a frame that stays; one setup); auto: the first that will do")
        ->check(CLI::IsMember({"auto", "vise", "soft-jaws", "screws", "plate", "skin", "tabs"}))
        ->capture_default_str();
    command.add_option(
        "--holes", options.holes_file,
        "which holes are tapped, reamed, bored, drilled alone or left (JSON); default: nothing is said");
    CLI::Option* materials =
        command.add_option("--materials", options.materials_file,
                           "what cuts of each material ask for, which feeds follow (JSON); default: seven "
                           "usual ones");
    command
        .add_flag("--library-feeds", options.library_feeds,
                  "the tool library's feeds, whatever is cut: no regard to rated removal, slots, power and "
                  "torque")
        ->excludes(materials);
    command.add_option("--material", options.material, "material the cutting data are for")
        ->capture_default_str();
    command.add_option("--objective", options.objective, "what the tool sequence makes least")
        ->check(CLI::IsMember({"time", "cost"}))
        ->capture_default_str();
    command
        .add_option("--surrogates", options.surrogates,
                    "who clears what a tool's holder keeps from it: one tool per place (single), or the "
                    "cheapest sequence of tools")
        ->check(CLI::IsMember({"single", "sequence"}))
        ->capture_default_str();
    command
        .add_option("--cost-model", options.cost_model,
                    "what tools are chosen by: real tool paths, or an area model of the papers (yao, lim); "
                    "the plan's times are those of its paths")
        ->check(CLI::IsMember({"paths", "yao", "lim"}))
        ->capture_default_str();
    command.add_flag("!--no-reserve", options.reserve,
                     "every setup cuts all that it reaches, also what a later one would cut for less");
    command
        .add_option(
            "--patterns", options.patterns,
            "patterns that clearing paths are chosen from, comma-separated: contour-parallel, \"contour-"
            "parallel from outside in\", stock-offset, zigzag, one-way, adaptive; contour-parallel "
            "stands in where none of them fits; default: all, adaptive where the tool library has a set "
            "for it; adaptive alone: wherever it can be")
        ->delimiter(',');
    command.add_flag("--strict", options.strict, "exit 1 on any warning as well");
}

void addSheetOptions(CLI::App& command, PlanOptions& options) {
    command.add_option("--job", options.job_file,
                       "what the head of the setup sheets says: customer, programmer, quantity, ... (JSON)");
    command.add_option("--display", options.display, "unit of report and setup sheets")
        ->check(CLI::IsMember({"mm", "inch"}))
        ->capture_default_str();
    command.add_flag("!--no-viewer", options.viewer, "a plain report.html: no script, a few hundred kB less");
    command.add_flag("--pdf", options.pdf,
                     "write sheets.pdf too, where Chromium is installed; A4, with inches Letter");
}

void addJobOptions(CLI::App& command, PlanOptions& options, const std::string& folder_suffix) {
    addPartOptions(command, options, folder_suffix);
    addShopOptions(command, options);
    addImportOption(command, options);
    addSheetOptions(command, options);
    command.add_flag("--json", options.json, "print plan.json on standard output instead of the summary");
}

void addOfferOptions(CLI::App& command, PlanOptions& options) {
    command.add_option("--buy", options.buy_file,
                       "tools that could be bought (a tool library, JSON): what each would save beside the "
                       "library's; takes several times as long");
}

void addFinishOptions(CLI::App& command, PlanOptions& options) {
    command
        .add_option("--finish-walls", options.finish_walls_mm,
                    "mm that roughing leaves on walls for a finishing pass along them; 0: no such pass")
        ->capture_default_str();
    command
        .add_option("--finish-floors", options.finish_floors_mm,
                    "mm that roughing leaves on floors for a finishing pass over them; 0: no such pass")
        ->capture_default_str();
    command
        .add_option(
            "--scallop", options.scallop_mm,
            "mm of the ridges that ball, bull-nose and chamfer cutters may leave on walls that lean; 0: "
            "none of them is used there")
        ->capture_default_str();
    command
        .add_option(
            "--break-edges", options.break_edges_mm,
            "mm by which a 90 degree chamfer mill breaks sharp edges that look up, wherever it reaches "
            "them; 0: they stay sharp")
        ->capture_default_str();
}

void addPlanningOptions(CLI::App& command, PlanOptions& options) {
    addStockOptions(command, options);
    addShopOptions(command, options);
    addFinishOptions(command, options);
}

}  // namespace stepmill
