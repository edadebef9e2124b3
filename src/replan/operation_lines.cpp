#include "replan/operation_lines.h"

#include <algorithm>
#include <sstream>

namespace stepmill::replan {
namespace {

/// "N12 G0 X1" is "G0 X1".
std::string withoutNumber(const std::string& line) {
    if (line.empty() || line.front() != 'N') return line;
    const std::size_t end = line.find_first_not_of("0123456789", 1);
    if (end == std::string::npos) return {};
    const std::size_t word = line.find_first_not_of(' ', end);
    return word == std::string::npos ? "" : line.substr(word);
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(withoutNumber(line));
    return lines;
}

/// After a tool change a program names the place where the machine stands: that is where the operation before
/// ended, and no way of this one.
void leaveOutPlaceOfChange(std::vector<std::string>& operation) {
    const auto change = std::find_if(operation.begin(), operation.end(),
                                     [](const std::string& line) { return line.ends_with(" M6"); });
    const auto rapid = std::find_if(change, operation.end(),
                                    [](const std::string& line) { return line.starts_with("G0 "); });
    if (rapid != operation.end() && rapid->starts_with("G0 X")) operation.erase(rapid);
}

/// From each operation's comment to the next one's.
void addOperations(const std::string& text, const ReadProgram& program, LinesById& operations) {
    const std::vector<std::string> lines = linesOf(text);
    for (std::size_t i = 0; i < program.operations.size(); ++i) {
        const bool last = i + 1 == program.operations.size();
        const auto begin = lines.begin() + (program.operations[i].line - 1);
        const auto end = last ? lines.end() : lines.begin() + (program.operations[i + 1].line - 1);
        std::vector<std::string> own(begin, end);
        if (i > 0) leaveOutPlaceOfChange(own);
        std::vector<std::string>& all = operations[program.operations[i].id];
        all.insert(all.end(), own.begin(), own.end());
    }
}

}  // namespace

LinesById operationLines(const PlanFiles& files, const RecordedSetup& setup) {
    LinesById operations;
    if (!setup.hasProgram()) return operations;
    const std::vector<ReadProgram> programs = readPrograms(files, setup);
    for (std::size_t i = 0; i < programs.size(); ++i)
        addOperations(files.programs.at(setup.id)[i].text, programs[i], operations);
    return operations;
}

int linesKept(const std::vector<std::string>& before, const std::vector<std::string>& after) {
    const std::size_t most = std::min(before.size(), after.size());
    std::size_t begin = 0;
    while (begin < most && before[begin] == after[begin])
        ++begin;
    std::size_t end = 0;
    while (end < most - begin && before[before.size() - 1 - end] == after[after.size() - 1 - end])
        ++end;
    return static_cast<int>(begin + end);
}

}  // namespace stepmill::replan
