#include <algorithm>
#include <filesystem>

#include <fmt/core.h>

#include "commands.h"
#include "output.h"
#include "plan_job.h"
#include "run.h"
#include "stepmill/batch/batch_list.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/report/quote.h"

namespace stepmill {

namespace {

namespace fs = std::filesystem;

constexpr int kMostPieces = 10'000'000;

struct QuoteOptions {
    PlanOptions part;
    QuoteTerms terms;
};

void makeFolder(const fs::path& folder) {
    std::error_code why;
    fs::create_directories(folder, why);
    if (why) throw Error(ErrorCode::OutputUnwritable, folder.string(), "cannot be made: " + why.message());
}

void writeQuote(const Quote& quote, const fs::path& folder) {
    makeFolder(folder);
    writeFile(folder / "quote.json", quoteJson(quote));
    writeFile(folder / "quote.csv", quoteCsvHead() + quoteCsvLines(quote));
    writeFile(folder / "quote.html", quoteHtml(quote));
}

/// Plans a part and quotes the plan.
/// \param folder  to write to; empty: none
int quoteOne(const Part& part, const QuoteOptions& options, const PlanRequest& request, const Shop& shop,
             const fs::path& folder, ProgressLine& line) {
    const Tolerances tol;
    const Progress progress = [&](const std::string& stage, double share) { line.show(stage, share); };
    const ProvenPlan proven = planProven(part, request, shop.library, shop.machine, tol, progress);
    if (!proven.mayRun()) {
        tell("{}: no program of it is proven; stepmill plan says where", part.file);
        return kBug;
    }
    const Quote quote = quotePlan(proven.plan, options.terms, tol, progress);
    if (!folder.empty()) writeQuote(quote, folder);
    line.show("done", 1);
    if (options.part.json)
        printData(quoteJson(quote));
    else
        printOut(quoteText(quote) + "\n");
    return quote.complete ? kComplete : kGaps;
}

int quoteFile(const QuoteOptions& options, const fs::path& folder, ProgressLine& line) {
    const Deadline end = Deadline::in(options.part.limits.timeout_s);
    const Shop shop = loadShop(options.part);
    line.showImport(options.part.part_file);
    PlanRequest request = planRequest(options.part, shop);
    // A smaller lot never pays for setups that only a larger one is worth.
    request.quantity = *std::min_element(options.terms.quantities.begin(), options.terms.quantities.end());
    const std::vector<Part> parts = chooseParts(options.part);
    int exit_code = kComplete;
    std::size_t to_do = parts.size();
    for (const Part& part : parts) {
        request.patience = patienceFor(end.secondsLeft() / static_cast<double>(to_do--));
        const bool only = parts.size() == 1 || folder.empty();
        const fs::path own = only ? folder : folder / fmt::format("solid-{}", part.solid_index);
        exit_code = std::max(exit_code, quoteOne(part, options, request, shop, own, line));
    }
    return exit_code;
}

int quoteInChild(const QuoteOptions& options, const fs::path& folder) {
    return runInChild(taskOf(options.part),
                      [&](Workplace& place) { return quoteFile(options, folder, place.progress); });
}

/// The lines below the head of all quote.csv in a folder; several of a file with several solids.
std::string linesBelow(const fs::path& folder) {
    std::string lines;
    std::error_code none;
    std::vector<fs::path> tables;
    for (const auto& entry : fs::recursive_directory_iterator(folder, none))
        if (entry.path().filename() == "quote.csv") tables.push_back(entry.path());
    std::sort(tables.begin(), tables.end());
    for (const fs::path& table : tables)
        lines += readFile(table).substr(quoteCsvHead().size());
    return lines;
}

/// Each part in a child of its own; what has no plan is told, and is not in the table.
int quoteFolder(QuoteOptions options) {
    const fs::path out = options.part.out_dir;
    if (out.empty()) throw Error(ErrorCode::Usage, "--output", "a folder of quotes needs one to write to");
    const std::vector<ListedPart> parts = findParts(options.part.part_file, out);
    if (parts.empty())
        throw Error(ErrorCode::Usage, options.part.part_file,
                    "expected STEP files in or below it, found none");
    makeFolder(out);
    std::string table = quoteCsvHead();
    int exit_code = kComplete;
    for (const ListedPart& part : parts) {
        options.part.part_file = part.file.string();
        const fs::path folder = out / safeFolderName(part.file.stem().string(), part.name);
        const int one = quoteInChild(options, folder);
        exit_code = std::max(exit_code, one == kBadInput ? static_cast<int>(kGaps) : one);
        if (one <= kGaps) table += linesBelow(folder);
    }
    writeFile(out / "quotes.csv", table);
    return exit_code;
}

int runQuote(const QuoteOptions& options) {
    std::error_code ignored;
    if (fs::is_directory(options.part.part_file, ignored)) return quoteFolder(options);
    return quoteInChild(options, options.part.out_dir);
}

void addTermsOptions(CLI::App& quote, QuoteTerms& terms) {
    quote
        .add_option("--quantity", terms.quantities,
                    "pieces of a lot; several with commas: planned for the smallest")
        ->delimiter(',')
        ->check(CLI::Range(1, kMostPieces))
        ->capture_default_str();
    quote
        .add_option("--setup-min", terms.setup_min,
                    "minutes to make ready for a clamping, once a lot; default: the machine's setup_time_min")
        ->check(numberFrom(0, 1e5, "min"));
    quote
        .add_option("--load-time", terms.load_s,
                    "seconds to clamp and release a piece, each clamping; default: the machine's load_time_s")
        ->check(numberFrom(0, 1e6, "s"));
    quote.add_option("--programming-min", terms.programming_min, "minutes of programming, once a lot")
        ->check(numberFrom(0, 1e6, "min"))
        ->capture_default_str();
    quote
        .add_option("--programming-rate", terms.programming_rate,
                    "money an hour of programming; 0: the machine's")
        ->check(numberFrom(0, 1e6, ""))
        ->capture_default_str();
}

}  // namespace

void addQuoteCommand(CLI::App& app, int& exit_code) {
    CLI::App* quote = app.add_subcommand(
        "quote", "Time and price of a part, or of each part of a folder, and what would make it cheaper");
    auto options = std::make_shared<QuoteOptions>();
    PlanOptions& part = options->part;
    quote->add_option("SOURCE", part.part_file, "STEP file, or a folder with all below it")->required();
    quote->add_option("-o,--output", part.out_dir,
                      "folder for quote.json, quote.csv and quote.html; default: none is written");
    addTermsOptions(*quote, options->terms);
    addPlanningOptions(*quote, part);
    quote->add_option("--jobs", part.jobs, "threads; 0: one per core")->check(numberFrom(0, 1024, ""));
    addLimitOptions(*quote, part.limits);
    quote->add_flag("--json", part.json, "print quote.json instead of the text");
    quote->footer(
        "Prices come from the machine's hourly rate, and from prices and lives of the tools.\n"
        "Examples:\n"
        "  stepmill quote bracket.step --quantity 1,10,100\n"
        "  stepmill quote bracket.step --setup-min 30 --load-time 90 --machine my_mill.json -o "
        "bracket-quote\n"
        "  stepmill quote parts -o quotes --quantity 50");
    quote->callback([options, &exit_code] { exit_code = runQuote(*options); });
}

}  // namespace stepmill
