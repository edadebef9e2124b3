#include "stepmill/part/import_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stepmill/part/part.h"

namespace stepmill {
namespace {

std::string shapeLine(const std::string& title, const ImportedShape& shape) {
    return fmt::format("  {:<18}{} faces, {} edges, volume {:.3f} mm3, area {:.3f} mm2\n", title, shape.faces,
                       shape.edges, shape.volume_mm3, shape.area_mm2);
}

}  // namespace

std::string importText(const Part& part) {
    if (!part.import) return fmt::format("Import of {}: not read from a file\n", part.name);
    const ImportReport& report = *part.import;
    std::string text = fmt::format("Import of {}, solid {}: {}, used {} times\n", part.file, part.solid_index,
                                   report.entity, part.count);
    text += fmt::format("  {:<18}{}, length unit {}\n", "schema", part.schema,
                        report.units.empty() ? "none" : fmt::format("{}", fmt::join(report.units, ", ")));
    text += fmt::format("  {:<18}{} shells, {} faces, {} edges\n", "in the file", report.shells_in_file,
                        report.faces_in_file, report.edges_in_file);
    text += shapeLine("read", report.built);
    text += shapeLine("healed", report.healed);
    text += fmt::format("  {:<18}vertices {:.3g} mm off their edges, edges {:.3g} mm off their faces\n",
                        "largest gaps", report.vertex_gap_mm, report.edge_gap_mm);
    text += fmt::format("  {:<18}{} shells, {} loose faces, {} loose edges, {} points\n", "left out",
                        report.strays.shells, report.strays.faces, report.strays.edges, report.strays.points);
    for (const Remark& remark : part.remarks)
        text += fmt::format("  {:<18}{}\n", remark.code, remark.text);
    text += "  entities of the shape\n";
    for (const auto& [keyword, count] : report.kinds)
        text += fmt::format("    {:>7} {}\n", count, keyword);
    return text;
}

}  // namespace stepmill
