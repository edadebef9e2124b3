#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "drawing_options.h"
#include "limits.h"
#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/material.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// The options of the commands on a part, as typed.
struct PlanOptions {
    std::string part_file;
    std::string out_dir;         ///< empty: "<part>-plan" in the current folder
    std::string fixtures_file;   ///< empty: suggested vises
    std::string holes_file;      ///< empty: nothing is said of holes
    std::string tools_file;      ///< empty: the built-in shop library
    std::string machine_file;    ///< empty: the built-in machining centre
    bool library_feeds = false;  ///< feeds of the tool library, whatever is cut
    std::string materials_file;  ///< feeds by what is cut of these; empty: the built-in ones
    std::string buy_file;        ///< tools that could be bought; empty: none are weighed
    std::string material = "aluminium";
    std::string stock = "box";                ///< "box", "auto" or a STEP file
    std::optional<std::string> stock_margin;  ///< side,top,bottom; nothing: none of a box, the shop's of auto
    std::string hold = "auto";                ///< a HoldKind's word, or "auto": the first that will do
    std::optional<double> stock_tolerance_mm;  ///< nothing: a box is sawn, a STEP file exact
    std::vector<std::string> setups;           ///< axes in order; empty or "auto": choose
    std::vector<std::string> no_setups;        ///< axes never to be chosen
    std::string objective = "time";
    std::string surrogates = "sequence";
    std::string cost_model = "paths";
    bool reserve = true;                ///< setups may leave to later ones what these cut for less
    std::vector<std::string> patterns;  ///< of clearing paths, to choose from; empty: all
    double finish_walls_mm = 0;
    double finish_floors_mm = 0;
    std::string folder_suffix;                 ///< of the folder that is written to where `out_dir` is empty
    bool rough = false;                        ///< roughing alone
    double allowance_mm = 0.5;                 ///< of roughing
    std::optional<double> floor_allowance_mm;  ///< the same on floors; nothing: as on walls
    int quantity = 1;
    double scallop_mm = kUsualScallopMm;
    double break_edges_mm = 0;  ///< 0: edges stay sharp
    std::string solid;          ///< empty: the only one; a number; "all"
    std::string unit;           ///< empty: as the file says
    DrawingWords drawing;       ///< of a part that is drawn
    int jobs = 0;               ///< 0: one per core
    RunLimits limits;
    std::string job_file;        ///< what the shop says of the job; empty: nothing
    std::string display = "mm";  ///< of report and setup sheets
    bool viewer = true;          ///< in the report
    bool pdf = false;            ///< setup sheets as a PDF too
    bool strict = false;
    bool json = false;
    bool report_import = false;
};

/// Adds the options about stock, setups, solid and unit.
void addStockOptions(CLI::App& command, PlanOptions& options);

/// Adds the part, where to write and the options about stock, setup, unit, threads and time that every
/// command on a part has.
void addPartOptions(CLI::App& command, PlanOptions& options, const std::string& folder_suffix);

/// Adds --report-import, for the commands that show a part.
void addImportOption(CLI::App& command, PlanOptions& options);

/// Prints what was read, healed and left out of each part if --report-import asks for it: on stdout, on
/// stderr where --json has stdout.
void reportImport(const std::vector<Part>& parts, const PlanOptions& options);

/// Library and machine a run uses.
/// \throws Error as readToolLibrary and readMachine do; Error(Usage) when no tool has cutting data for the
///         material.
struct Shop {
    ToolLibrary library;
    Machine machine;
    MaterialFile materials;
    std::string material;  ///< as the library calls what --material asks for
};
Shop loadShop(const PlanOptions& options);

/// Axes, margins and stock as asked for; the shop's file says what a blank of `--stock auto` is sawn from.
/// \throws Error(Usage) naming the option; what readStep and readFixtures throw.
SetupRequest setupRequest(const PlanOptions& options);

/// What the words of the command line mean for the planner.
/// \throws Error(Usage) naming the option.
PlanRequest planRequest(const PlanOptions& options, const Shop& shop);

/// The parts of the file that were asked for.
/// \throws Error(Usage) when the file holds several solids and none was chosen, or the chosen one does not
///         exist.
std::vector<Part> chooseParts(const PlanOptions& options);

}  // namespace stepmill
