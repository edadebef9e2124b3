#include "stepmill/post/post.h"

#include <algorithm>

#include <fmt/format.h>

#include "post/comment.h"
#include "post/dialect.h"
#include "post/drill_cycle.h"
#include "post/motion_writer.h"
#include "post/operation_start.h"
#include "post/program_header.h"
#include "post/tap_cycle.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

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
          motion_(body_, options.inch),
          start_(job, options, body_, motion_) {}

    PostedProgram write(const std::string& file) {
        const JobOperation* before = nullptr;
        for (const JobOperation& operation : job_.operations) {
            body_ += operationComment(operation, inch_) + "\n";
            start_.write(before, operation);
            writeMoves(operation);
            before = &operation;
        }
        start_.end();
        return {file, top() + body_ + (rules_.percent ? "%\n" : ""), start_.starts()};
    }

  private:
    /// What stands before the first operation; its last part are where operations start.
    std::string top() const {
        std::string text = rules_.percent ? "%\n" : "";
        if (!rules_.any_program_name) text += fmt::format("O{:04}\n", number_);
        text += programHeader(job_, start_.starts(), inch_) + start_.safeLine() + "\n";
        // What an earlier program allowed at corners holds no more; operations say what they allow.
        return rules_.blends_corners ? text + "G61\n" : text;
    }

    std::string dwellWord(double dwell_s) const {
        if (dwell_s <= 0) return "";
        return rules_.dwell_in_ms ? fmt::format(" P{:.0f}", 1000 * dwell_s)
                                  : fmt::format(" P{:.3f}", dwell_s);
    }

    void writeMoves(const JobOperation& operation) {
        if (operation.thread) return writeTapping(operation);
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

    void writeTapping(const JobOperation& operation) {
        if (rules_.tapping == Tapping::None)
            throw Error(ErrorCode::Usage, operation.id,
                        fmt::format("taps {}, and this controller has no motion coupled to the spindle: plan "
                                    "for its machine, which leaves the thread out",
                                    operation.thread->thread.name));
        const std::optional<FoundTapCycle> found = findTapCycle(operation);
        if (!found)
            throw Error(ErrorCode::InvalidCatalog, operation.id,
                        "its moves are no tapping: down, up again at the same place, and on to the next");
        motion_.write(operation.start,
                      {operation.moves.begin(),
                       operation.moves.begin() + static_cast<std::ptrdiff_t>(found->moves_before)});
        if (rules_.tapping == Tapping::G331)
            motion_.tapCoupled(found->cycle);
        else
            motion_.tapRigid(found->cycle);
    }

    /// Move by move, with a dwell at the bottom of every hole.
    void writeExpanded(const JobOperation& operation, const std::string& dwell) {
        const std::vector<FedMove>& moves = operation.moves;
        if (dwell.empty()) return motion_.write(operation.start, moves);
        double bottom_mm = operation.start.z();
        for (const FedMove& one : moves)
            bottom_mm = std::min(bottom_mm, one.move.to.z());
        Vec3 from = operation.start;
        auto first = moves.begin();
        for (auto next = moves.begin(); next != moves.end(); ++next) {
            if (next->move.kind == MoveKind::Rapid || next->move.to.z() > bottom_mm) continue;
            motion_.write(from, {first, next + 1});
            body_ += "G4" + dwell + "\n";
            from = next->move.to;
            first = next + 1;
        }
        motion_.write(from, {first, moves.end()});
    }

    const Job& job_;
    bool inch_;
    const DialectRules& rules_;
    int number_;
    std::string body_;
    MotionWriter motion_;
    OperationStart start_;
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
        return {ProgramWriter(job, options, setup).write(programName(job.setup_id, options.dialect))};
    std::vector<PostedProgram> programs;
    for (const Job& visit : visits(job)) {
        const int number = static_cast<int>(programs.size()) + 1;
        const std::string name =
            fmt::format("{}-{}-T{}", job.setup_id, number, visit.operations.front().tool.number);
        programs.push_back(ProgramWriter(visit, options, kProgramsASetup * setup + number)
                               .write(programName(name, options.dialect)));
    }
    return programs;
}

std::string toolTable(const Job& job) {
    std::string out;
    for (const ToolAssembly* tool : toolsOf(job)) {
        const std::string text = comment(tool->id + " " + tool->description);
        // The table has no brackets around comments.
        out += fmt::format("T{} P{} Z0 D{:.4f} ;{}\n", tool->number, tool->number, tool->diameter_mm,
                           text.substr(1, text.size() - 2));
    }
    return out;
}

}  // namespace stepmill
