#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/page/document.h"
#include "report/page/page_style.h"
#include "report/page/words.h"
#include "stepmill/catalog/json_values.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/core/units.h"
#include "stepmill/report/batch_page.h"
#include "stepmill/report/part_views.h"

namespace stepmill {
namespace {

using json::Json;
using report::Anchor;
using report::Element;
using report::Tag;

/// A column of the page's table, and what stands in it in a row.
struct PartColumn {
    const char* head;
    const char* kind;  ///< as part_table.js knows it
    int decimals;      ///< of numbers
    Json (*cell)(const BatchRow& row);
};

/// What a figure gives; an empty cell without figures.
template <typename Value>
Json ofFigures(const BatchRow& row, Value value) {
    return row.figures ? Json(json::number(value(*row.figures))) : Json(nullptr);
}

/// Numbers are rounded as shown: what is equal to the reader is equal when it is sorted.
const std::vector<PartColumn>& partColumns() {
    using Row = const BatchRow&;
    using Figures = const PartFigures&;
    static const std::vector<PartColumn> columns{
        {"picture", "picture", 0, [](Row row) { return Json(row.figures ? row.figures->picture : ""); }},
        {"part", "part", 0, [](Row row) { return Json(plainLine(row.part.name)); }},
        {"outcome", "outcome", 0, [](Row row) { return Json(toString(row.outcome)); }},
        {"pieces", "number", 0, [](Row row) { return Json(row.part.quantity); }},
        {"due", "text", 0, [](Row row) { return Json(plainLine(row.part.due)); }},
        {"material", "text", 0,
         [](Row row) { return Json(row.figures ? plainLine(row.figures->material) : ""); }},
        {"x mm", "number", 1,
         [](Row row) { return ofFigures(row, [](Figures f) { return f.size_mm.x(); }); }},
        {"y mm", "number", 1,
         [](Row row) { return ofFigures(row, [](Figures f) { return f.size_mm.y(); }); }},
        {"z mm", "number", 1,
         [](Row row) { return ofFigures(row, [](Figures f) { return f.size_mm.z(); }); }},
        {"setups", "number", 0, [](Row row) { return ofFigures(row, [](Figures f) { return f.setups; }); }},
        {"features", "number", 0,
         [](Row row) { return ofFigures(row, [](Figures f) { return f.features; }); }},
        {"minutes", "number", 2,
         [](Row row) { return ofFigures(row, [](Figures f) { return f.time_s / kSecondsPerMinute; }); }},
        {"cost", "number", 2, [](Row row) { return ofFigures(row, [](Figures f) { return f.cost; }); }},
        {"× bound", "number", 2,
         [](Row row) {
             const bool bounded = row.figures && row.figures->lower_bound_s > 0;
             return bounded ? Json(json::number(row.figures->time_s / row.figures->lower_bound_s))
                            : Json(nullptr);
         }},
        {"stays cm³", "number", 3,
         [](Row row) { return ofFigures(row, [](Figures f) { return f.stays_mm3 / kMm3PerCm3; }); }},
        {"reason", "text", 0, [](Row row) { return Json(plainLine(row.reason)); }}};
    return columns;
}

/// Below the batch's folder; empty without a report.
std::string linkOf(const BatchRow& row) {
    if (!row.figures || row.figures->reports.empty()) return {};
    return "jobs/" + row.folder + "/" + row.figures->reports.front();
}

Json rowJson(const BatchRow& row) {
    Json cells = Json::array();
    for (const PartColumn& column : partColumns())
        cells.push_back(column.cell(row));
    cells.push_back(linkOf(row));
    return cells;
}

Element tableData(const std::vector<BatchRow>& rows) {
    const Json columns = json::listOf(partColumns(), [](const PartColumn& column) {
        return Json{{"head", column.head}, {"kind", column.kind}, {"decimals", column.decimals}};
    });
    const Json data{{"pictureBox", fmt::format("0 0 {} {}", kSmallPictureWidth, kSmallPictureHeight)},
                    {"columns", columns},
                    {"rows", json::listOf(rows, rowJson)}};
    return report::dataElement(Anchor("data", "parts"),
                               data.dump(-1, ' ', false, Json::error_handler_t::replace));
}

Element cards(const std::vector<BatchRow>& rows) {
    Element cards("div.cards");
    for (const auto& [outcome, count] : countsOf(outcomesOf(rows)))
        cards.add(
            Element("div.card", Element("b", std::to_string(count)), Element("span", toString(outcome))));
    return cards;
}

/// Where parts are searched and filtered.
Element choice(const std::vector<BatchRow>& rows) {
    Element outcomes = Element("select", Element("option", "all outcomes").with("value", ""))
                           .with("aria-label", "outcome")
                           .at(Anchor("table", "outcome"));
    for (const auto& [outcome, count] : countsOf(outcomesOf(rows)))
        outcomes.add(Element("option", toString(outcome)).with("value", toString(outcome)));
    return Element("div.choice",
                   Element("input")
                       .with("type", "search")
                       .with("aria-label", "search")
                       .with("placeholder", "search names, reasons, materials")
                       .at(Anchor("table", "search")),
                   std::move(outcomes), Element("span.soft").at(Anchor("table", "count")));
}

Element emptyTable() {
    Element heads("tr");
    for (const PartColumn& column : partColumns()) {
        const std::string_view kind = column.kind;
        Element head = Element("th").with("class", kind == "number" ? "n" : "for-" + std::string(kind));
        if (kind != "picture") head.add(Element("button", column.head).with("type", "button"));
        heads.add(std::move(head).with("scope", "col"));
    }
    return Element("div.tall", Element("table", Element("thead", std::move(heads)),
                                       Element("tbody").at(Anchor("table", "rows"))))
        .at(Anchor("table", "frame"));
}

}  // namespace

std::string batchHtml(const std::vector<BatchRow>& rows) {
    const std::string title = fmt::format("{} parts", rows.size());
    Element main(
        "main.broad", Element("h1", title), cards(rows), choice(rows),
        Element("noscript", Element("p.bad", "This table needs scripts; parts.csv has the same.")),
        emptyTable(),
        Element("p.soft",
                "Minutes and cost are of one piece, feeds and tool changes; × bound is how often the "
                "least time that these tools could take goes into them. The same as a table: "
                "parts.csv; what each tool does in all parts: tools.csv."));
    return report::scriptedDocument(title, std::move(main), tableData(rows),
                                    {{report::kPartTableScript}, {}});
}

}  // namespace stepmill
