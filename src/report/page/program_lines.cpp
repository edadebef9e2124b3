#include "report/page/program_lines.h"

#include <algorithm>

#include "stepmill/plan/warning_order.h"

namespace stepmill::report {
namespace {

/// Lines that are told of an operation's start: its tool change and its first moves.
constexpr int kToldLines = 14;

std::string linesFrom(const std::string& text, std::size_t from) {
    std::size_t end = from;
    for (int line = 0; line < kToldLines && end != std::string::npos; ++line)
        end = text.find('\n', line == 0 ? from : end + 1);
    return text.substr(from, end == std::string::npos ? end : end - from);
}

}  // namespace

const PostedProgram* programOf(const ProvenPlan& proven, const PlannedSetup& setup) {
    const auto found = proven.files.programs.find(setup.setup.id);
    if (!proven.mayRun() || !isWithinTravel(proven.plan, setup.setup.id)) return nullptr;
    if (found == proven.files.programs.end() || found->second.empty()) return nullptr;
    return &found->second.front();
}

const StartBlock* startOf(const PostedProgram* program, const std::string& operation_id) {
    if (program == nullptr) return nullptr;
    const auto found =
        std::find_if(program->starts.begin(), program->starts.end(),
                     [&](const StartBlock& start) { return start.operation_id == operation_id; });
    return found == program->starts.end() ? nullptr : &*found;
}

ProgramPlace placeOf(const PostedProgram* program, const std::string& operation_id) {
    const StartBlock* start = startOf(program, operation_id);
    if (start == nullptr) return {};
    const std::size_t before = program->text.find("\n" + start->number + " ");
    if (start->number.empty() || before == std::string::npos) return {};
    const auto lines =
        std::count(program->text.begin(), program->text.begin() + static_cast<std::ptrdiff_t>(before), '\n');
    return {program->file, static_cast<int>(lines) + 2, linesFrom(program->text, before + 1)};
}

}  // namespace stepmill::report
