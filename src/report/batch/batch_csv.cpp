#include <cmath>
#include <map>

#include <fmt/format.h>

#include "report/page/csv_cell.h"
#include "report/page/words.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/core/units.h"
#include "stepmill/report/batch_page.h"

namespace stepmill {
namespace {

using report::csvCell;
using report::fixed;

std::string figureCells(const PartFigures& figures) {
    return fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{}", csvCell(figures.material), fixed(figures.size_mm.x(), 3),
        fixed(figures.size_mm.y(), 3), fixed(figures.size_mm.z(), 3), figures.solids, figures.setups,
        figures.features, fixed(figures.time_s / kSecondsPerMinute, 3),
        fixed(figures.motion_s / kSecondsPerMinute, 3), fixed(figures.cost, 2), csvCell(figures.currency),
        fixed(figures.lower_bound_s / kSecondsPerMinute, 3), fixed(figures.stays_mm3 / kMm3PerCm3, 6));
}

std::string partLine(const BatchRow& row) {
    constexpr const char* kNoFigures = ",,,,,,,,,,,,";
    const std::string folder = row.folder.empty() ? "" : "jobs/" + row.folder;
    return fmt::format("{},{},{},{},{},{},{},{}\n", csvCell(row.part.name), row.part.quantity,
                       csvCell(row.part.due), csvCell(row.part.options), toString(row.outcome),
                       row.figures ? figureCells(*row.figures) : kNoFigures, csvCell(row.reason), folder);
}

struct ToolSum {
    ToolUse use;
    int parts = 0;
    double lives = 0;  ///< of all pieces
};

/// Tools of different libraries may have one id: by diameter too.
std::map<std::pair<std::string, double>, ToolSum> toolSums(const std::vector<BatchRow>& rows) {
    std::map<std::pair<std::string, double>, ToolSum> sums;
    for (const BatchRow& row : rows) {
        if (!row.figures) continue;
        for (const ToolUse& use : row.figures->tools) {
            ToolSum& sum = sums[{use.tool_id, use.diameter_mm}];
            ++sum.parts;
            sum.use.operations += use.operations;
            sum.use.visits += use.visits;
            sum.use.cutting_s += use.cutting_s;
            sum.use.life_used += use.life_used;
            sum.lives += row.part.quantity * use.life_used;
        }
    }
    return sums;
}

}  // namespace

std::string partsCsv(const std::vector<BatchRow>& rows) {
    std::string csv =
        "part,quantity,due,options,outcome,material,x_mm,y_mm,z_mm,solids,setups,features,time_min,"
        "time_with_acceleration_min,cost,currency,bound_min,stays_cm3,reason,folder\n";
    for (const BatchRow& row : rows)
        csv += partLine(row);
    return csv;
}

std::string toolsCsv(const std::vector<BatchRow>& rows) {
    std::string csv = "tool,diameter_mm,parts,operations,visits,cutting_min,life_used,cutters\n";
    for (const auto& [tool, sum] : toolSums(rows))
        csv += fmt::format("{},{},{},{},{},{},{},{}\n", csvCell(tool.first), fixed(tool.second, 3), sum.parts,
                           sum.use.operations, sum.use.visits,
                           fixed(sum.use.cutting_s / kSecondsPerMinute, 3), fixed(sum.use.life_used, 4),
                           sum.lives > 0 ? std::to_string(std::lround(std::ceil(sum.lives))) : "");
    return csv;
}

std::string orderCsv(const std::vector<BatchRow>& rows, const PlannedTools& planned, const PartOrder& order) {
    std::string csv = "position,part,tools\n";
    int position = 0;
    const auto add = [&](const std::string& place, std::size_t part) {
        csv += fmt::format("{},{},{}\n", place, csvCell(rows[planned.rows[part]].part.name),
                           csvCell(report::listed(planned.tools[part])));
    };
    for (const std::size_t part : order.parts)
        add(std::to_string(++position), part);
    for (const std::size_t part : order.too_many)
        add("", part);
    return csv;
}

std::string orderText(const PartOrder& order) {
    std::string text = fmt::format("as planned, in this order {} tools are put in", order.loads);
    text += order.bound == order.loads ? std::string("; no order puts in fewer\n")
                                       : fmt::format("; no order puts in fewer than {}\n", order.bound);
    if (!order.too_many.empty())
        text += fmt::format("{} parts need more tools than there are places\n", order.too_many.size());
    return text;
}

std::string magazineText(const Magazine& magazine) {
    std::string text = fmt::format("{} of {} tools: {}\n", magazine.tools.size(), magazine.values.size(),
                                   plainLine(report::listed(magazine.tools)));
    text += fmt::format("all parts with them: {}; with every tool: {}\n", fixed(magazine.cost, 1),
                        fixed(magazine.all_tools_cost, 1));
    text += magazine.proven ? std::string("no other set that fits is better\n")
                            : fmt::format("no set that serves as many features can take less than {}\n",
                                          fixed(magazine.bound, 1));
    if (magazine.unserved > 0)
        text += fmt::format("{} features have no way with these tools: another magazine must cut them\n",
                            magazine.unserved);
    return text;
}

std::string magazineCsv(const Magazine& magazine) {
    std::string csv = "tool,in_magazine,serves_alone,saves\n";
    for (const ToolValue& value : magazine.values)
        csv += fmt::format("{},{},{},{}\n", csvCell(value.tool), value.inside ? "yes" : "no", value.serves,
                           fixed(value.saves, 3));
    return csv;
}

}  // namespace stepmill
