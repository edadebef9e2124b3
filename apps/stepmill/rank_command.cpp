#include <cctype>
#include <filesystem>

#include <fmt/core.h>

#include "commands.h"
#include "options.h"
#include "output.h"
#include "run.h"
#include "stepmill/core/error.h"
#include "stepmill/report/rank.h"

namespace stepmill {

namespace {

namespace fs = std::filesystem;

struct RankOptions {
    PlanOptions part;
    std::optional<double> tool_change_s;
    std::string feature;
    std::string sensitivity;
    bool buy = false;
    bool csv = false;
};

bool isTable(const std::string& file) {
    std::string extension = fs::path(file).extension().string();
    for (char& c : extension)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension == ".csv";
}

void print(const RankReport& report, const RankOptions& options) {
    if (options.csv) {
        std::vector<AccessRow> cutters;
        for (const RankedRow& row : report.ranking.rows)
            cutters.push_back(row.cutter);
        printData(accessTableCsv(cutters));
    } else {
        if (options.part.json)
            printData(rankJson(report));
        else
            printOut(rankText(report));
    }
}

void requireTableOptions(const RankOptions& options) {
    for (const auto& [given, option] :
         {std::pair(!options.feature.empty(), "--feature"),
          std::pair(!options.sensitivity.empty(), "--sensitivity"), std::pair(options.buy, "--buy")})
        if (given) throw Error(ErrorCode::Usage, option, "needs a part, not a table");
}

int rankTable(const RankOptions& options) {
    requireTableOptions(options);
    RankReport report;
    report.file = fs::path(options.part.part_file).filename().string();
    // Without a machine the paper's own totals: removal alone.
    report.ranking = rankTools(readAccessTable(options.part.part_file, options.part.limits.maxFileBytes()),
                               options.tool_change_s.value_or(0));
    print(report, options);
    return kComplete;
}

int rankParts(const RankOptions& options, ProgressLine& progress) {
    const Tolerances tol;
    progress.show("reading tools and machine", 0);
    const Shop shop = loadShop(options.part);
    progress.showImport(options.part.part_file);
    RankRequest request;
    request.setup = setupRequest(options.part);
    PlanRequest plan = planRequest(options.part, shop);
    request.sequence = std::move(plan.sequence);
    request.holes = std::move(plan.holes);
    request.feature = options.feature;
    request.tool_change_s = options.tool_change_s;
    request.purchases = options.buy;
    request.sensitivity = parameterFrom(options.sensitivity);
    for (const Part& part : chooseParts(options.part)) {
        const RankReport report =
            rankPart(part, request, shop.library, shop.machine, tol,
                     [&](const std::string& stage, double share) { progress.show(stage, share); });
        progress.show("done", 1);
        print(report, options);
    }
    return kComplete;
}

int runRank(const RankOptions& options) {
    return runInChild(taskOf(options.part), [&](Workplace& place) {
        return isTable(options.part.part_file) ? rankTable(options) : rankParts(options, place.progress);
    });
}

}  // namespace

void addRankCommand(CLI::App& app, int& exit_code) {
    CLI::App* rank = app.add_subcommand(
        "rank", "Rank cutters by what they reach and how fast they cut, for a part, a feature or a table");
    auto options = std::make_shared<RankOptions>();
    addPartOptions(*rank, options->part, "-rank");
    rank->remove_option(rank->get_option("--output"));
    rank->get_option("PART")->description("STEP file, or TABLE.csv: diameter_mm,volume_cm3,mrr_cm3_per_min");
    rank->add_option("--tools", options->part.tools_file,
                     "tool library (JSON); default: a metric shop of 24 tools");
    rank->add_option("--machine", options->part.machine_file, "machine (JSON); default: a machining centre");
    rank->add_option("--material", options->part.material, "material the cutting data are for")
        ->capture_default_str();
    rank->add_option("--objective", options->part.objective, "what sequences make least")
        ->check(CLI::IsMember({"time", "cost"}))
        ->capture_default_str();
    rank->add_option("--feature", options->feature, "rank for this feature alone, such as S1.F2");
    rank->add_option("--tool-change", options->tool_change_s,
                     "seconds of a tool change in the table; default: the machine's, 0 for a CSV table")
        ->check(numberFrom(0, 1e7, "s"));
    rank->add_option("--sensitivity", options->sensitivity,
                     "cheapest sequence of each feature for every value of this, with the break-even values")
        ->check(CLI::IsMember({"tool-change", "hourly-rate", "tool-price"}));
    rank->add_flag(
        "--buy", options->buy,
        "for each feature the tool beyond the library that would help most, and the taps, reamers and "
        "chamfer mills that the part asks for");
    rank->add_option("--holes", options->part.holes_file,
                     "hole table (JSON): the threads and fits that --buy looks for");
    CLI::Option* json = rank->add_flag("--json", options->part.json, "print all as JSON");
    rank->add_flag("--csv", options->csv, "print the table alone, as CSV that rank reads back")
        ->excludes(json);
    rank->footer(
        "Rank 0 finishes, rank 1 goes before it, and so on. The ranking is greedy, the shortest path the\n"
        "optimum over the same table; the first tool's change is not counted. Nothing is written.\n"
        "Examples:\n"
        "  stepmill rank cutters.csv --tool-change 10\n"
        "  stepmill rank bracket.step\n"
        "  stepmill rank bracket.step --feature S1.F2 --csv > cutters.csv\n"
        "  stepmill rank bracket.step --sensitivity tool-change\n"
        "  stepmill rank bracket.step --buy --tools my_tools.json --json");
    rank->callback([options, &exit_code] { exit_code = runRank(*options); });
}

}  // namespace stepmill
