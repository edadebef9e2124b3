#include "stepmill/study/quote.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/enum_words.h"
#include "stepmill/core/units.h"
#include "study/cheaper_features.h"

namespace stepmill {
namespace {

constexpr double kMinutesPerHour = 60;

constexpr EnumWord<CheaperChange::Kind> kChanges[] = {{CheaperChange::Kind::LargerCorners, "larger-corners"},
                                                      {CheaperChange::Kind::LessDepth, "less-depth"}};

/// Of one piece and once a lot.
void quotePiece(const Plan& plan, Quote& quote) {
    const QuoteTerms& terms = quote.terms;
    const double rate = plan.machine.hourly_rate;
    const double programming_rate = terms.programming_rate > 0 ? terms.programming_rate : rate;
    for (const PlannedSetup& setup : plan.setups) {
        if (setup.operations.empty()) continue;
        ++quote.setups;
        quote.setup_min += terms.setup_min.value_or(plan.machine.settingUpMin(setup.setup.indexed));
        quote.load_s += terms.load_s.value_or(plan.machine.load_time_s);
    }
    const double slowest_s = quote.acceleration ? plan.totals.motion_s : plan.totals.time_s;
    quote.machining_s = {plan.totals.time_s, std::max(plan.totals.time_s, slowest_s)};
    quote.wear = plan.totals.cost - plan.totals.time_s / kSecondsPerHour * rate;
    quote.once =
        quote.setup_min / kMinutesPerHour * rate + terms.programming_min / kMinutesPerHour * programming_rate;
    const auto running = [&](double machining_s) {
        return (machining_s + quote.load_s) / kSecondsPerHour * rate + quote.wear;
    };
    quote.running = {running(quote.machining_s.low), running(quote.machining_s.high)};
}

QuotedLot lotOf(const Quote& quote, int quantity) {
    QuotedLot lot;
    lot.quantity = quantity;
    const auto minutes = [&](double machining_s) {
        return quote.setup_min + quantity * (machining_s + quote.load_s) / kSecondsPerMinute;
    };
    lot.time_min = {minutes(quote.machining_s.low), minutes(quote.machining_s.high)};
    lot.price = {quote.once + quantity * quote.running.low, quote.once + quantity * quote.running.high};
    lot.piece_price = {lot.price.low / quantity, lot.price.high / quantity};
    return lot;
}

std::optional<int> payingQuantity(const Quote& quote) {
    if (quote.running.high <= 0) return std::nullopt;
    return std::max(1, static_cast<int>(std::ceil(quote.once / quote.running.high)));
}

}  // namespace

std::string toString(CheaperChange::Kind kind) {
    return wordOf(kChanges, kind);
}

Quote quotePlan(const Plan& plan, const QuoteTerms& terms, const Tolerances& tol, const Progress& progress) {
    Quote quote;
    quote.part_file = plan.part.file;
    quote.material = plan.material;
    quote.currency = plan.machine.currency;
    quote.hourly_rate = plan.machine.hourly_rate;
    quote.terms = terms;
    quote.complete = plan.complete(tol);
    quote.acceleration = plan.machine.acceleration_mm_per_s2 > 0;
    quotePiece(plan, quote);
    for (const int quantity : terms.quantities)
        quote.lots.push_back(lotOf(quote, quantity));
    quote.pays_off_at = payingQuantity(quote);
    quote.costly = costlyFeatures(plan, tol, progress);
    return quote;
}

}  // namespace stepmill
