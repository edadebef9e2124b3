#include <fmt/format.h>

#include "post/comment.h"
#include "post/motion_writer.h"
#include "stepmill/core/error.h"
#include "stepmill/post/post.h"

namespace stepmill {
namespace {

/// Tools of a setup by number, each once.
std::vector<const ToolAssembly*> toolsOf(const Plan& plan, const PlannedSetup& setup) {
    std::map<int, const ToolAssembly*> by_number;
    for (const Operation& operation : setup.operations) {
        const ToolAssembly& tool = plan.library.tool(operation.tool_id);
        const auto [found, is_new] = by_number.emplace(tool.number, &tool);
        if (!is_new && found->second->id != tool.id)
            throw Error(ErrorCode::InvalidCatalog, plan.library.file,
                        fmt::format("tools {} and {} have the same number {}", found->second->id, tool.id,
                                    tool.number));
    }
    std::vector<const ToolAssembly*> tools;
    for (const auto& [number, tool] : by_number)
        tools.push_back(tool);
    return tools;
}

void line(std::string& out, const std::string& text) {
    out += text;
    out += '\n';
}

void writeHeader(std::string& out, const Plan& plan, const PlannedSetup& setup) {
    const Vec3 size = setup.setup.stock_bbox_mm.sizes();
    line(out, comment(fmt::format("Part {} from {}", plan.part.name.empty() ? plan.part.file : plan.part.name,
                                  plan.part.file)));
    line(out, comment(fmt::format("Setup {}, tool axis {} of the part, material {}", setup.setup.id,
                                  axisName(setup.setup.axis), plan.material)));
    line(out, comment(fmt::format("Stock {:.3f} x {:.3f} x {:.3f} mm", size.x(), size.y(), size.z())));
    line(out, comment("Work offset G54: X0 Y0 at the lower-left corner, Z0 at the top of the stock"));
    line(out, comment("Machine " + plan.machine.name));
    for (const ToolAssembly* tool : toolsOf(plan, setup)) {
        line(out, comment(fmt::format("T{} {} {} D{:.4g} mm, stick-out {:.4g} mm", tool->number, tool->id,
                                      toString(tool->type), tool->diameter_mm, tool->stick_out_mm)));
    }
    line(out,
         comment(fmt::format("{} operations, about {:.1f} min", setup.operations.size(), setup.time_s / 60)));
}

void writeToolChange(std::string& out, const ToolAssembly& tool, double speed_rpm) {
    line(out, "M5");
    line(out, "M9");
    line(out, fmt::format("T{} M6", tool.number));
    line(out, fmt::format("S{:.0f} M3", speed_rpm));
    line(out, fmt::format("G43 H{}", tool.number));
    line(out, "M8");
}

std::string describe(const Operation& operation, const ToolAssembly& tool) {
    return comment(fmt::format("{} feature {} T{} {} {}, {} x {:.4g} mm deep to Z{:.4f}", operation.id,
                               operation.feature_id, tool.number, toString(operation.role),
                               operation.path.pattern, operation.path.layers, operation.path.step_down_mm,
                               operation.z_floor_mm));
}

void requireDialect(const Machine& machine) {
    if (machine.dialect == "linuxcnc") return;
    throw Error(ErrorCode::Usage, "machine " + machine.name,
                "there is no post for dialect '" + machine.dialect + "'; known: linuxcnc");
}

}  // namespace

std::string program(const Plan& plan, const PlannedSetup& setup) {
    requireDialect(plan.machine);
    std::string out;
    writeHeader(out, plan, setup);
    line(out, "G21 G17 G40 G49 G80 G90 G94 G54");
    // Without it LinuxCNC blends moves and rounds every corner by as much as it likes.
    line(out, "G61");
    MotionWriter motion(out);
    const Operation* before = nullptr;
    for (const Operation& operation : setup.operations) {
        const ToolAssembly& tool = plan.library.tool(operation.tool_id);
        line(out, describe(operation, tool));
        if (before == nullptr || before->tool_id != operation.tool_id) {
            writeToolChange(out, tool, operation.speed_rpm);
            motion.forgetState();
        } else if (before->speed_rpm != operation.speed_rpm) {
            line(out, fmt::format("S{:.0f}", operation.speed_rpm));
        }
        motion.approach(operation.path.start);
        motion.write(operation.path);
        before = &operation;
    }
    line(out, "M9");
    line(out, "M5");
    line(out, "M30");
    return out;
}

std::string toolTable(const Plan& plan, const PlannedSetup& setup) {
    requireDialect(plan.machine);
    std::string out;
    for (const ToolAssembly* tool : toolsOf(plan, setup)) {
        const std::string text = comment(tool->id + " " + tool->description);
        // The table has no brackets around comments.
        line(out, fmt::format("T{} P{} Z0 D{:.4f} ;{}", tool->number, tool->number, tool->diameter_mm,
                              text.substr(1, text.size() - 2)));
    }
    return out;
}

}  // namespace stepmill
