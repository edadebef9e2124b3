#include <fmt/format.h>

#include "report/page/document.h"
#include "report/page/table.h"
#include "report/page/words.h"
#include "report/quote/quote_words.h"
#include "stepmill/report/quote.h"

namespace stepmill {
namespace {

using report::Element;
using report::numbers;
using report::rangeWords;
using report::Table;

Element lotsTable(const Quote& quote) {
    Table table({numbers("pieces"),
                 numbers("machine time min"),
                 {"price " + quote.currency, true},
                 {"a piece " + quote.currency, true}});
    for (const QuotedLot& lot : quote.lots)
        table.row(std::to_string(lot.quantity), rangeWords(lot.time_min, 1, ""), rangeWords(lot.price, 2, ""),
                  rangeWords(lot.piece_price, 2, ""));
    return std::move(table).element();
}

Element listOf(const std::vector<std::string>& lines) {
    Element list("ul");
    for (const std::string& line : lines)
        list.add(Element("li", line));
    return list;
}

Element costlySection(const CostlyFeature& feature, const std::string& currency) {
    Element section("section",
                    Element("h3", fmt::format("{} {}", feature.id, toString(feature.feature_class))),
                    Element("p", fmt::format("{:.2f} mm deep, {}, {:.2f} {}", feature.depth_mm,
                                             report::clockTime(feature.time_s), feature.cost, currency)));
    std::vector<std::string> lines;
    for (const CheaperChange& change : feature.changes)
        lines.push_back(report::changeWords(change) + ": " + report::savingWords(change, currency));
    if (lines.empty()) lines.emplace_back("no larger corner and no less depth that was tried saves time");
    for (const FeatureBreakEven& found : feature.break_evens)
        lines.push_back(report::breakEvenWords(found, currency));
    section.add(listOf(lines));
    return section;
}

}  // namespace

std::string quoteHtml(const Quote& quote) {
    Element main("main", Element("h1", quote.part_file),
                 Element("p.soft", fmt::format("{}, setups: {}", quote.material, quote.setups)));
    if (!quote.complete) main.add(Element("p.bad", "The plan has gaps: what stays is not in the price."));
    main.add(lotsTable(quote), Element("p", report::payOffWords(quote)), Element("h2", "What it contains"),
             listOf(report::quoteContains(quote)), Element("h2", "What it does not contain"),
             listOf(report::quoteLacks(quote)));
    if (!quote.costly.empty())
        main.add(Element("h2", "What costs most, and what would make it cheaper"),
                 Element("p.soft",
                         "Each change was sequenced with its own tools on real paths, the feature by "
                         "itself."));
    for (const CostlyFeature& feature : quote.costly)
        main.add(costlySection(feature, quote.currency));
    return report::htmlDocument("Quote: " + quote.part_file, std::move(main));
}

}  // namespace stepmill
