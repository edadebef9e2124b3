#include "stepmill/report/offers.h"

#include <algorithm>

#include <fmt/format.h>

#include "report/page/csv_cell.h"
#include "report/page/words.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

using report::csvCell;
using report::fixed;

std::string lineOf(const OfferWorth& offer, const std::string& currency) {
    return fmt::format("  {} ({} mm, {} {}): {} feature{}, saves {} min and {} {}, reaches {} cm3 more\n",
                       plainLine(offer.tool_id), fixed(offer.diameter_mm, 2), fixed(offer.price, 2),
                       plainLine(currency), offer.features, offer.features == 1 ? "" : "s",
                       fixed(offer.saves_s / kSecondsPerMinute, 2), fixed(offer.saves_cost, 2),
                       plainLine(currency), fixed(offer.more_mm3 / kMm3PerCm3, 3));
}

}  // namespace

std::string offersText(const std::vector<OfferWorth>& offers, const std::string& currency) {
    if (offers.empty()) return "What to buy: none of these tools helps\n";
    std::vector<OfferWorth> sorted = offers;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const OfferWorth& a, const OfferWorth& b) { return a.saves_s > b.saves_s; });
    std::string text = "What to buy, each alone beside the library:\n";
    for (const OfferWorth& offer : sorted)
        text += lineOf(offer, currency);
    return text;
}

std::string offersCsv(const std::vector<OfferSum>& offers) {
    std::string csv =
        "tool,diameter_mm,price,parts,features,saves_min,saves_cost,currency,reaches_more_cm3\n";
    for (const OfferSum& offer : offers)
        csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", csvCell(offer.worth.tool_id),
                           fixed(offer.worth.diameter_mm, 3), fixed(offer.worth.price, 2), offer.parts,
                           offer.worth.features, fixed(offer.worth.saves_s / kSecondsPerMinute, 3),
                           fixed(offer.worth.saves_cost, 2), csvCell(offer.currency),
                           fixed(offer.worth.more_mm3 / kMm3PerCm3, 6));
    return csv;
}

}  // namespace stepmill
