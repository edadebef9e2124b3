// The tools of a setup.

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "report/page/drawing.h"
#include "report/page/table.h"
#include "report/page/words.h"
#include "report/sheets/sheet_sections.h"
#include "stepmill/catalog/spindle.h"

namespace stepmill::report {
namespace {

/// One tool's part in a setup.
struct ToolUse {
    const ToolAssembly* tool = nullptr;
    double time_s = 0;
    double lowest_mm = 0;
    std::vector<std::string> operations;
};

std::vector<ToolUse> usesOf(const Plan& plan, const PlannedSetup& setup) {
    std::vector<ToolUse> uses;
    for (const Operation& operation : setup.operations) {
        const ToolAssembly& tool = plan.library.tool(operation.tool_id);
        auto use = std::find_if(uses.begin(), uses.end(), [&](const ToolUse& u) { return u.tool == &tool; });
        if (use == uses.end()) use = uses.insert(uses.end(), {&tool, 0, lowestMm(operation), {}});
        use->time_s += operation.motionS();
        use->lowest_mm = std::min(use->lowest_mm, lowestMm(operation));
        use->operations.push_back(shortId(operation.id));
    }
    return uses;
}

/// A plan's tools stand in the spindle; its nose is no part of what the setter puts together.
std::vector<HolderCylinder> ownHolder(const ToolAssembly& tool, const Machine& machine) {
    const std::size_t nose = std::min(machine.spindle_nose.size(), tool.holder.size());
    return {tool.holder.begin(), tool.holder.end() - static_cast<std::ptrdiff_t>(nose)};
}

double gaugeMm(const ToolAssembly& tool, const Machine& machine) {
    ToolAssembly own = tool;
    own.holder = ownHolder(tool, machine);
    return gaugeLengthMm(own);
}

std::string typeWords(const ToolAssembly& tool) {
    if (tool.hasFlanks()) return fmt::format("{} {:g}°", toString(tool.type), tool.included_angle_deg);
    return toString(tool.type);
}

std::string holderWords(const ToolAssembly& tool, const Machine& machine, const Measures& in) {
    std::vector<std::string> cylinders;
    for (const HolderCylinder& cylinder : ownHolder(tool, machine))
        cylinders.push_back(fmt::format("Ø{} × {}", in.number(cylinder.diameter_mm, 0),
                                        in.number(cylinder.top_mm - cylinder.bottom_mm, 0)));
    return cylinders.empty() ? "-" : listed(cylinders);
}

std::string makerWords(const ToolAssembly& tool) {
    std::string words = tool.description;
    for (const std::string* more : {&tool.vendor, &tool.product_id})
        if (!more->empty()) words += (words.empty() ? "" : ", ") + *more;
    return words;
}

/// The stick-out to set; with an asterisk where the plan chose it from a range.
std::string stickOut(const ToolAssembly& tool, const Measures& in) {
    return in.number(tool.stick_out_mm, 1) + (tool.stick_out_range ? "*" : "");
}

// The picture: tools stand side by side, tip down, in units of 0.1 mm of paper at the full width of a sheet.
constexpr double kWidth = 1860;
constexpr double kHeight = 260;
constexpr double kWordsHeight = 44;
constexpr double kMostPlace = 300;

Element rect(const char* css_class, double centre, double width, double top, double height) {
    return Element("rect")
        .with("class", css_class)
        .with("x", fixed(centre - width / 2, 1))
        .with("y", fixed(top, 1))
        .with("width", fixed(width, 1))
        .with("height", fixed(height, 1));
}

void drawTool(Element& svg, const ToolUse& use, const Machine& machine, double centre, double scale) {
    const ToolAssembly& tool = *use.tool;
    const auto cylinder = [&](const char* css_class, double diameter_mm, double from_mm, double to_mm) {
        if (to_mm > from_mm)
            svg.add(rect(css_class, centre, scale * diameter_mm, kHeight - scale * to_mm,
                         scale * (to_mm - from_mm)));
    };
    for (const HolderCylinder& part : ownHolder(tool, machine))
        cylinder("holder", part.diameter_mm, part.bottom_mm, part.top_mm);
    cylinder("shank", tool.shank.diameter_mm, tool.flute_length_mm, tool.stick_out_mm);
    cylinder("flutes", tool.diameter_mm, 0, std::min(tool.flute_length_mm, tool.stick_out_mm));
    svg.add(Element("text", fmt::format("T{}", tool.number))
                .with("class", "tool-name")
                .with("x", fixed(centre, 1))
                .with("y", fixed(kHeight + kWordsHeight - 10, 1)));
}

Element toolsPicture(const std::vector<ToolUse>& uses, const Machine& machine) {
    double longest_mm = 1;
    double widest_mm = 1;
    for (const ToolUse& use : uses) {
        longest_mm = std::max(longest_mm, gaugeMm(*use.tool, machine));
        for (const HolderCylinder& part : ownHolder(*use.tool, machine))
            widest_mm = std::max(widest_mm, part.diameter_mm);
        widest_mm = std::max(widest_mm, use.tool->diameter_mm);
    }
    const double place = std::min(kMostPlace, kWidth / static_cast<double>(uses.size()));
    const double scale = std::min(kHeight / longest_mm, 0.92 * place / widest_mm);
    Element svg = emptySvg(
        "svg.tools",
        fmt::format("0 0 {:g} {:g}", place * static_cast<double>(uses.size()), kHeight + kWordsHeight),
        "the setup's tools to scale");
    double centre = place / 2;
    for (const ToolUse& use : uses) {
        drawTool(svg, use, machine, centre, scale);
        centre += place;
    }
    return svg;
}

}  // namespace

std::vector<Element> toolSections(const SheetSubject& subject, const PlannedSetup& setup) {
    const Measures& in = subject.measures;
    const Machine& machine = subject.plan().machine;
    const std::vector<ToolUse> uses = usesOf(subject.plan(), setup);
    if (uses.empty()) return {};
    const std::string unit = in.unit();
    Table table({"T",
                 "H, D",
                 "tool",
                 "type",
                 {"Ø " + unit, true},
                 {"corner R " + unit, true},
                 numbers("flutes"),
                 {"flute length " + unit, true},
                 {"stick-out " + unit, true},
                 {"gauge " + unit, true},
                 "holder " + unit,
                 "operations",
                 {"lowest Z " + unit, true},
                 numbers("time")});
    bool any_range = false;
    for (const ToolUse& use : uses) {
        const ToolAssembly& tool = *use.tool;
        any_range = any_range || tool.stick_out_range.has_value();
        table.row(Element("b", fmt::format("T{}", tool.number)), fmt::format("H{0},\u00a0D{0}", tool.number),
                  tool.id == makerWords(tool) ? tool.id : tool.id + " " + makerWords(tool), typeWords(tool),
                  in.number(tool.diameter_mm), in.number(tool.corner_radius_mm),
                  tool.flutes > 0 ? std::to_string(tool.flutes) : "-", in.number(tool.flute_length_mm, 1),
                  stickOut(tool, in), in.number(gaugeMm(tool, machine), 1), holderWords(tool, machine, in),
                  listed(use.operations), in.number(use.lowest_mm), clockTime(use.time_s));
    }
    Element content("div", Element("figure.strip", toolsPicture(uses, machine)), std::move(table).element());
    if (any_range) content.add(Element("p.soft", "* of a range; the plan needs it no longer."));
    std::vector<Element> sections;
    sections.push_back(titled("Tools", std::move(content)));
    return sections;
}

}  // namespace stepmill::report
