#include "stepmill/post/post.h"

#include <map>

#include <fmt/format.h>

#include "post/comment.h"
#include "post/dialect.h"
#include "post/drill_cycle.h"
#include "post/motion_writer.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

void line(std::string& out, const std::string& text) {
    out += text;
    out += '\n';
}

/// Tools by number, each once.
std::vector<const ToolAssembly*> toolsOf(const Job& job) {
    std::map<int, const ToolAssembly*> by_number;
    for (const JobOperation& operation : job.operations) {
        const ToolAssembly& tool = operation.tool;
        const auto [found, is_new] = by_number.emplace(tool.number, &tool);
        if (!is_new && found->second->id != tool.id)
            throw Error(ErrorCode::InvalidCatalog, "setup " + job.setup_id,
                        fmt::format("tools {} and {} have the same number {}", found->second->id, tool.id,
                                    tool.number));
    }
    std::vector<const ToolAssembly*> tools;
    for (const auto& [number, tool] : by_number)
        tools.push_back(tool);
    return tools;
}

/// The operations of one visit of each tool, in order, as jobs of their own.
std::vector<Job> visits(const Job& job) {
    std::vector<Job> result;
    for (const JobOperation& operation : job.operations) {
        if (result.empty() || result.back().operations.back().tool.id != operation.tool.id) {
            result.push_back(job);
            result.back().operations.clear();
            result.back().time_s = 0;  // only that of the whole setup is known
        }
        result.back().operations.push_back(operation);
    }
    return result;
}

/// Writes one program.
class ProgramWriter {
  public:
    ProgramWriter(const Job& job, const PostOptions& options, int number)
        : job_(job),
          inch_(options.inch),
          rules_(rulesOf(options.dialect)),
          number_(number),
          motion_(out_, options.inch) {}

    std::string write() {
        begin();
        const JobOperation* before = nullptr;
        for (const JobOperation& operation : job_.operations) {
            line(out_, describe(operation));
            changeOver(before, operation);
            writeMoves(operation);
            before = &operation;
        }
        end();
        return out_;
    }

  private:
    std::string length(double value_mm) const {
        return inch_ ? fmt::format("{:.4f}", mmToInch(value_mm)) : fmt::format("{:.3f}", value_mm);
    }
    const char* unit() const { return inch_ ? "inch" : "mm"; }

    void begin() {
        if (rules_.percent) line(out_, "%");
        if (!rules_.any_program_name) line(out_, fmt::format("O{:04}", number_));
        header();
        line(out_, fmt::format("{} {} G54", inch_ ? "G20" : "G21", rules_.safe_start));
        // Without it LinuxCNC and GRBL blend moves and round every corner by as much as they like.
        if (!rules_.goes_home) line(out_, "G61");
    }

    void header() {
        const Vec3& size = job_.stock_size_mm;
        line(out_,
             comment(fmt::format("Part {} from {}", job_.part_name.empty() ? job_.part_file : job_.part_name,
                                 job_.part_file)));
        line(out_, comment(fmt::format("Setup {}, tool axis {} of the part, material {}", job_.setup_id,
                                       job_.axis_name, job_.material)));
        line(out_, comment(fmt::format("Stock {} x {} x {} {}", length(size.x()), length(size.y()),
                                       length(size.z()), unit())));
        line(out_, comment("Work offset G54: X0 Y0 at the lower-left corner, Z0 at the top of the stock"));
        line(out_, comment("Machine " + job_.machine_name));
        for (const ToolAssembly* tool : toolsOf(job_))
            line(out_, comment(fmt::format("T{} {} {} D{} {}, stick-out {} {}", tool->number, tool->id,
                                           toString(tool->type), length(tool->diameter_mm), unit(),
                                           length(tool->stick_out_mm), unit())));
        const std::string time = job_.time_s > 0 ? fmt::format(", about {:.1f} min", job_.time_s / 60) : "";
        line(out_, comment(fmt::format("{} operations{}", job_.operations.size(), time)));
    }

    std::string describe(const JobOperation& operation) const {
        return comment(fmt::format("{} feature {} T{} {} {}, {} x {} {} deep to Z{}{}", operation.id,
                                   operation.feature_id, operation.tool.number, toString(operation.role),
                                   operation.pattern, operation.depths, length(operation.step_down_mm),
                                   unit(), length(operation.z_floor_mm), leaves(operation.leaves)));
    }

    std::string leaves(const FinishAllowance& allowance) const {
        if (!allowance.any()) return {};
        return fmt::format(", leaves walls {}, floor {}", length(allowance.walls_mm),
                           length(allowance.floors_mm));
    }

    void changeOver(const JobOperation* before, const JobOperation& next) {
        if (before == nullptr || before->tool.id != next.tool.id) {
            changeTool(next, before == nullptr);
            return;
        }
        if (before->speed_rpm != next.speed_rpm) line(out_, fmt::format("S{:.0f}", next.speed_rpm));
        if (before->coolant != next.coolant) line(out_, coolantWord(next.coolant));
    }

    void changeTool(const JobOperation& next, bool first) {
        const ToolAssembly& tool = next.tool;
        line(out_, "M5");
        line(out_, "M9");
        if (rules_.goes_home) line(out_, "G91 G28 Z0.");
        if (rules_.goes_home) line(out_, "G90");
        if (rules_.tool_changer) {
            line(out_, fmt::format("T{} M6", tool.number));
        } else {
            line(out_, comment(fmt::format("Put in T{} {}, then set Z0 with it on the top of the stock",
                                           tool.number, tool.id)));
            line(out_, fmt::format("T{}", tool.number));
            if (!first) line(out_, "M0");
        }
        line(out_, fmt::format("S{:.0f} M3", next.speed_rpm));
        if (rules_.tool_lengths && !rules_.goes_home) line(out_, fmt::format("G43 H{}", tool.number));
        line(out_, coolantWord(next.coolant));
        motion_.forgetState();
        z_words_ = rules_.goes_home ? fmt::format(" G43 H{}", tool.number) : "";
    }

    static std::string coolantWord(Coolant coolant) {
        return coolant == Coolant::Flood ? "M8" : coolant == Coolant::Mist ? "M7" : "M9";
    }

    std::string dwellWord(double dwell_s) const {
        if (dwell_s <= 0) return "";
        return rules_.dwell_in_ms ? fmt::format(" P{:.0f}", 1000 * dwell_s)
                                  : fmt::format(" P{:.3f}", dwell_s);
    }

    void writeMoves(const JobOperation& operation) {
        motion_.approach(operation.start, z_words_);
        z_words_.clear();
        const std::string dwell = dwellWord(operation.dwell_s);
        const auto found = rules_.cycles ? findCycle(operation) : std::nullopt;
        // No cycle has both pecks and a dwell.
        if (!found || (found->cycle.peck_mm > 0 && !dwell.empty())) {
            writeExpanded(operation, dwell);
            return;
        }
        const std::vector<FedMove> way(operation.moves.begin(),
                                       operation.moves.begin() + found->moves_before);
        motion_.write(operation.start, way);
        motion_.drill(found->cycle, dwell);
    }

    /// Move by move, with the dwell after the last feed.
    void writeExpanded(const JobOperation& operation, const std::string& dwell) {
        const std::vector<FedMove>& moves = operation.moves;
        if (dwell.empty()) return motion_.write(operation.start, moves);
        auto last = moves.end();
        while (last != moves.begin() && (last - 1)->move.kind == MoveKind::Rapid)
            --last;
        motion_.write(operation.start, {moves.begin(), last});
        line(out_, "G4" + dwell);
        motion_.write(last == moves.begin() ? operation.start : (last - 1)->move.to, {last, moves.end()});
    }

    void end() {
        line(out_, "M9");
        line(out_, "M5");
        if (rules_.goes_home) line(out_, "G91 G28 Z0.");
        if (rules_.goes_home) line(out_, "G90");
        line(out_, "M30");
        if (rules_.percent) line(out_, "%");
    }

    const Job& job_;
    bool inch_;
    const DialectRules& rules_;
    int number_;
    std::string out_;
    MotionWriter motion_;
    std::string z_words_;  ///< go with the first block after a tool change
};

/// The number in "S2".
int numberOf(const std::string& setup_id) {
    return std::max(1, std::atoi(setup_id.c_str() + 1));
}

/// Fanuc's programs of tools are numbered from 100 times the setup.
constexpr int kProgramsASetup = 100;

}  // namespace

std::vector<PostedProgram> post(const Job& job, const PostOptions& options) {
    toolsOf(job);  // refuses two tools of one number before anything is written
    const int setup = numberOf(job.setup_id);
    if (!options.per_tool)
        return {{programName(job.setup_id, options.dialect), ProgramWriter(job, options, setup).write()}};
    std::vector<PostedProgram> programs;
    for (const Job& visit : visits(job)) {
        const int number = static_cast<int>(programs.size()) + 1;
        const std::string name =
            fmt::format("{}-{}-T{}", job.setup_id, number, visit.operations.front().tool.number);
        programs.push_back({programName(name, options.dialect),
                            ProgramWriter(visit, options, kProgramsASetup * setup + number).write()});
    }
    return programs;
}

std::string toolTable(const Job& job) {
    std::string out;
    for (const ToolAssembly* tool : toolsOf(job)) {
        const std::string text = comment(tool->id + " " + tool->description);
        // The table has no brackets around comments.
        line(out, fmt::format("T{} P{} Z0 D{:.4f} ;{}", tool->number, tool->number, tool->diameter_mm,
                              text.substr(1, text.size() - 2)));
    }
    return out;
}

}  // namespace stepmill
