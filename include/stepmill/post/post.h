#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// Languages of controllers [docs/posts.md].
enum class Dialect { LinuxCnc, Fanuc, Grbl };
std::string toString(Dialect dialect);
/// The reverse; nothing for another word.
std::optional<Dialect> dialectFrom(std::string_view word);
/// The machine's dialect.
/// \throws Error(Usage) when there is no post for it.
Dialect dialectOf(const Machine& machine);

/// "S1.ngc", "S1.nc" (Fanuc), "S1.gcode" (GRBL): where a program of that name is kept.
std::string programName(const std::string& name, Dialect dialect);

/// One motion with its own feed [mm/min]; the feed of a rapid is 0.
struct FedMove {
    Move move;
    double feed_mm_per_min = 0;
};

/// A path's moves with the feeds of their kinds.
std::vector<FedMove> fedMoves(const Toolpath& path);

/// What a post has to know of one operation.
struct JobOperation : OperationSheet {
    Vec3 start = Vec3::Zero();
    std::vector<FedMove> moves;  ///< in setup coordinates [mm]
};

/// What a post has to know of one setup, from a plan or from the files of one.
struct Job {
    std::string part_name;
    std::string part_file;
    std::string setup_id;
    std::string axis_name;
    std::string material;
    Machine machine;
    Vec3 stock_size_mm = Vec3::Zero();
    double stock_tolerance_mm = 0;  ///< raw sides may stand out so far
    double time_s = 0;
    std::vector<JobOperation> operations;  ///< in machining order
};
Job jobOf(const Plan& plan, const PlannedSetup& setup);

struct PostOptions {
    Dialect dialect = Dialect::LinuxCnc;
    bool inch = false;            ///< G20 instead of G21
    bool per_tool = false;        ///< a program for every visit of a tool instead of one for the setup
    bool optional_stops = false;  ///< before every operation but the first: home, then M1
};

/// Where an operation starts in its program.
struct StartBlock {
    std::string operation_id;
    std::string number;  ///< "N12"
};

/// A program and the name of the file it belongs in.
struct PostedProgram {
    std::string file;
    std::string text;
    std::vector<StartBlock> starts;  ///< one an operation, in order; none of a program read from its file
};

/// The programs of one setup: header comments (part, setup, stock, work offset, tools), a safe start line,
/// operations in order with their tool changes, an end. Each operation says all that its moves hang on, so
/// that the program can be run from its first block on. Arcs are G2 and G3 with I and J, helices with Z;
/// holes are G81, G82, G83, G73, G85 or G89 where the dialect has cycles.
///
/// Every arc's centre agrees with both its ends within 1 um, so that no controller refuses it; coordinates
/// have 4 decimals in mm, 5 in inches.
/// Rounding never adds up: every block is rounded from the path's own coordinates. A job without operations
/// gives a program of header and end, with `per_tool` none.
/// \throws Error(InvalidCatalog) when two tools have one number.
/// \note  Linear in the moves.
std::vector<PostedProgram> post(const Job& job, const PostOptions& options);

/// The program of one setup in the dialect of the plan's machine.
/// \throws Error(Usage) if there is no post for that dialect.
std::string program(const Plan& plan, const PlannedSetup& setup);

/// LinuxCNC tool table rows for the tools a job uses.
std::string toolTable(const Job& job);

}  // namespace stepmill
