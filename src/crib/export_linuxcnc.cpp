// Tool tables of LinuxCNC: what read_tool_table.cpp reads.

#include <algorithm>

#include <fmt/format.h>

#include "crib/type_words.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/core/units.h"
#include "stepmill/crib/export_tools.h"

namespace stepmill {
namespace {

std::string remarkOf(const ToolAssembly& tool) {
    std::string remark = crib::hsmWord(tool.type) + ": " + tool.id;
    if (!tool.description.empty()) remark += ": " + tool.description;
    remark = plainLine(remark);
    std::replace(remark.begin(), remark.end(), ';', ',');
    return remark;
}

}  // namespace

std::string linuxCncTable(const ToolLibrary& library) {
    const double mm_per_unit = library.unit == "inch" ? kMillimetresPerInch : 1.0;
    std::string text =
        fmt::format("; lengths in {}; Z is the gauge length: touch tools off on the machine\n", library.unit);
    std::vector<const ToolAssembly*> tools;
    for (const ToolAssembly& tool : library.tools)
        tools.push_back(&tool);
    std::sort(tools.begin(), tools.end(),
              [](const ToolAssembly* a, const ToolAssembly* b) { return a->number < b->number; });
    for (const ToolAssembly* tool : tools) {
        const double gauge_mm = tool->holder.empty() ? 0 : tool->holder.back().top_mm;
        text += fmt::format("T{0} P{0} D{1:.6f} Z{2:.6f} ;{3}\n", tool->number,
                            tool->diameter_mm / mm_per_unit, gauge_mm / mm_per_unit, remarkOf(*tool));
    }
    return text;
}

}  // namespace stepmill
