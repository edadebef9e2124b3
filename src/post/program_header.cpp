// Comments of a program.

#include "post/program_header.h"

#include <map>

#include <fmt/format.h>

#include "post/comment.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

std::string leavesText(const FinishAllowance& allowance, bool inch) {
    if (!allowance.any()) return {};
    return fmt::format(", leaves walls {}, floor {}", lengthText(allowance.walls_mm, inch),
                       lengthText(allowance.floors_mm, inch));
}

std::string toolText(const ToolAssembly& tool, bool inch) {
    return fmt::format("T{} {} {} D{} {}, stick-out {} {}", tool.number, tool.id, toString(tool.type),
                       lengthText(tool.diameter_mm, inch), unitName(inch),
                       lengthText(tool.stick_out_mm, inch), unitName(inch));
}

std::string toleranceText(double tolerance_mm, bool inch) {
    if (tolerance_mm <= 0) return {};
    return fmt::format(", raw sides at most {} {} larger", lengthText(tolerance_mm, inch), unitName(inch));
}

std::string startText(const StartBlock& start) {
    return fmt::format("From {} {}", start.number, start.operation_id);
}

}  // namespace

std::string lengthText(double value_mm, bool inch) {
    return inch ? fmt::format("{:.4f}", mmToInch(value_mm)) : fmt::format("{:.3f}", value_mm);
}

const char* unitName(bool inch) {
    return inch ? "inch" : "mm";
}

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

std::string programHeader(const Job& job, const std::vector<StartBlock>& starts, bool inch) {
    const Vec3& size = job.stock_size_mm;
    const std::string time = job.time_s > 0 ? fmt::format(", about {:.1f} min", job.time_s / 60) : "";
    std::vector<std::string> lines{
        fmt::format("Part {} from {}", job.part_name.empty() ? job.part_file : job.part_name, job.part_file),
        fmt::format("Setup {}, tool axis {} of the part, material {}", job.setup_id, job.axis_name,
                    job.material),
        fmt::format("Stock {} x {} x {} {}{}", lengthText(size.x(), inch), lengthText(size.y(), inch),
                    lengthText(size.z(), inch), unitName(inch), toleranceText(job.stock_tolerance_mm, inch)),
        "Work offset G54: X0 Y0 at the lower-left corner, Z0 at the top of the stock",
        "Machine " + job.machine.name};
    for (const ToolAssembly* tool : toolsOf(job))
        lines.push_back(toolText(*tool, inch));
    lines.push_back(fmt::format("{} operations{}", job.operations.size(), time));
    for (const StartBlock& start : starts)
        lines.push_back(startText(start));
    std::string header;
    for (const std::string& line : lines)
        header += comment(line) + "\n";
    return header;
}

std::string operationComment(const JobOperation& operation, bool inch) {
    return comment(fmt::format("{} feature {} T{} {} {}, {} x {} {} deep to Z{}{}", operation.id,
                               operation.feature_id, operation.tool.number, toString(operation.role),
                               operation.pattern, operation.depths, lengthText(operation.step_down_mm, inch),
                               unitName(inch), lengthText(operation.z_floor_mm, inch),
                               leavesText(operation.leaves, inch)));
}

}  // namespace stepmill
