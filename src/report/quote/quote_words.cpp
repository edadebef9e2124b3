#include "report/quote/quote_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/page/words.h"
#include "stepmill/core/plain_text.h"

namespace stepmill::report {

std::vector<std::string> quoteContains(const Quote& quote) {
    const QuoteTerms& terms = quote.terms;
    const std::string clampings =
        quote.setups == 1 ? "1 clamping" : fmt::format("{} clampings", quote.setups);
    return {fmt::format("machining {} a piece: {}", rangeWords(quote.machining_s, 1, "s"),
                        quote.acceleration
                            ? "at the programmed feeds alone, and with the machine's acceleration"
                            : "at the programmed feeds; the machine's acceleration is not known, so it "
                              "will take longer"),
            fmt::format("loading {:.1f} s a piece, in {}", quote.load_s, clampings),
            fmt::format("tool wear {:.2f} {} a piece, by the lives and prices of the library", quote.wear,
                        quote.currency),
            fmt::format("setting up {:.1f} min once a lot, {}", quote.setup_min, clampings),
            fmt::format("programming {:g} min once a lot", terms.programming_min),
            fmt::format("the machine at {:.2f} {} an hour", quote.hourly_rate, quote.currency)};
}

std::vector<std::string> quoteLacks(const Quote& quote) {
    std::vector<std::string> lacks{"stock material",  "fixtures",  "tools that are to be bought",
                                   "inspection",      "deburring", "scrap",
                                   "overhead, profit"};
    if (!quote.complete) lacks.emplace_back("what stays on the part: the plan has gaps");
    return lacks;
}

std::string rangeWords(const Range& range, int decimals, const std::string& unit) {
    const std::string low = fixed(range.low, decimals);
    const std::string high = fixed(range.high, decimals);
    return low == high ? low + " " + unit : low + " to " + high + " " + unit;
}

std::string changeWords(const CheaperChange& change) {
    if (change.kind == CheaperChange::Kind::LargerCorners)
        return fmt::format("inner corners of {:.2f} mm instead of {:.2f} mm", change.to_mm, change.from_mm);
    return fmt::format("a depth of {:.2f} mm instead of {:.2f} mm", change.to_mm, change.from_mm);
}

std::string savingWords(const CheaperChange& change, const std::string& currency) {
    return fmt::format("saves {:.1f} s and {:.2f} {} a piece ({})", change.saves_s, change.saves_cost,
                       currency, fmt::join(change.tools, " > "));
}

std::string breakEvenWords(const FeatureBreakEven& found, const std::string& currency) {
    const bool change = found.parameter == Parameter::ToolChange;
    const std::string unit = change ? "s" : currency + "/h";
    std::vector<std::string> sides;
    if (found.below) sides.push_back(fmt::format("below {:.2f} {}", *found.below, unit));
    if (found.above) sides.push_back(fmt::format("above {:.2f} {}", *found.above, unit));
    return fmt::format("{} {:g} {}: {}", change ? "tool change" : "hourly rate", found.now, unit,
                       sides.empty() ? "the same tools at any value"
                                     : fmt::format("other tools {}", fmt::join(sides, " and ")));
}

std::string payOffWords(const Quote& quote) {
    if (!quote.pays_off_at) return {};
    return fmt::format(
        "From {} pieces on, what is paid once ({:.2f} {}) is no more than the pieces themselves.",
        *quote.pays_off_at, quote.once, quote.currency);
}

}  // namespace stepmill::report
