#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/page/words.h"
#include "report/quote/quote_words.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/report/quote.h"

namespace stepmill {
namespace {

std::string costlyText(const CostlyFeature& feature, const std::string& currency) {
    std::string text =
        fmt::format("{} {}, {:.2f} mm deep: {}, {:.2f} {}\n", feature.id, toString(feature.feature_class),
                    feature.depth_mm, report::clockTime(feature.time_s), feature.cost, currency);
    for (const CheaperChange& change : feature.changes)
        text += fmt::format("  {}: {}\n", report::changeWords(change), report::savingWords(change, currency));
    if (feature.changes.empty()) text += "  no larger corner and no less depth that was tried saves time\n";
    for (const FeatureBreakEven& found : feature.break_evens)
        text += fmt::format("  {}\n", report::breakEvenWords(found, currency));
    return text;
}

}  // namespace

std::string quoteText(const Quote& quote) {
    std::string text =
        fmt::format("{}, {}, setups: {}{}\n\n{:>8} {:>22} {:>26} {:>24}\n", quote.part_file, quote.material,
                    quote.setups, quote.complete ? "" : ", with gaps", "pieces", "machine time [min]",
                    "price [" + quote.currency + "]", "a piece [" + quote.currency + "]");
    for (const QuotedLot& lot : quote.lots)
        text +=
            fmt::format("{:>8} {:>22} {:>26} {:>24}\n", lot.quantity, report::rangeWords(lot.time_min, 1, ""),
                        report::rangeWords(lot.price, 2, ""), report::rangeWords(lot.piece_price, 2, ""));
    text += fmt::format("\n{}\n", report::payOffWords(quote));
    for (const std::string& line : report::quoteContains(quote))
        text += "  " + line + "\n";
    text += fmt::format("not in it: {}\n", fmt::join(report::quoteLacks(quote), "; "));
    if (!quote.costly.empty()) text += "\nWhat costs most, and what would make it cheaper:\n";
    for (const CostlyFeature& feature : quote.costly)
        text += costlyText(feature, quote.currency);
    return text;
}

}  // namespace stepmill
