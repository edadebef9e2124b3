#include "stepmill/catalog/json_schema.h"
#include "stepmill/catalog/json_values.h"
#include "stepmill/report/quote.h"

namespace stepmill {
namespace {

using json::Json;
using json::listOf;
using json::number;
using json::numberOrNull;

Json rangeJson(const Range& range) {
    return {{"low", number(range.low)}, {"high", number(range.high)}};
}

Json lotJson(const QuotedLot& lot) {
    return {{"quantity", lot.quantity},
            {"time_min", rangeJson(lot.time_min)},
            {"price", rangeJson(lot.price)},
            {"piece_price", rangeJson(lot.piece_price)}};
}

Json termsJson(const QuoteTerms& terms) {
    return {{"setup_min", numberOrNull(terms.setup_min)},
            {"load_s", numberOrNull(terms.load_s)},
            {"programming_min", number(terms.programming_min)},
            {"programming_rate", number(terms.programming_rate)}};
}

Json changeJson(const CheaperChange& change) {
    return {{"change", toString(change.kind)},         {"from_mm", number(change.from_mm)},
            {"to_mm", number(change.to_mm)},           {"saves_s", number(change.saves_s)},
            {"saves_cost", number(change.saves_cost)}, {"tools", change.tools}};
}

Json breakEvenJson(const FeatureBreakEven& found) {
    return {{"parameter", toString(found.parameter)},
            {"now", number(found.now)},
            {"below", numberOrNull(found.below)},
            {"above", numberOrNull(found.above)}};
}

Json costlyJson(const CostlyFeature& feature) {
    return {{"id", feature.id},
            {"class", toString(feature.feature_class)},
            {"depth_mm", number(feature.depth_mm)},
            {"time_s", number(feature.time_s)},
            {"cost", number(feature.cost)},
            {"cheaper", listOf(feature.changes, changeJson)},
            {"break_evens", listOf(feature.break_evens, breakEvenJson)}};
}

}  // namespace

std::string quoteJson(const Quote& quote) {
    Json json{{"part", quote.part_file},
              {"material", quote.material},
              {"currency", quote.currency},
              {"hourly_rate", number(quote.hourly_rate)},
              {"terms", termsJson(quote.terms)},
              {"setups", quote.setups},
              {"complete", quote.complete},
              {"machining_s", rangeJson(quote.machining_s)},
              {"with_acceleration", quote.acceleration},
              {"load_s", number(quote.load_s)},
              {"wear", number(quote.wear)},
              {"setup_min", number(quote.setup_min)},
              {"once", number(quote.once)},
              {"running", rangeJson(quote.running)},
              {"lots", listOf(quote.lots, lotJson)},
              {"pays_off_at", quote.pays_off_at ? Json(*quote.pays_off_at) : Json(nullptr)},
              {"costly", listOf(quote.costly, costlyJson)}};
    return finishJson(SchemaName::Quote, std::move(json));
}

}  // namespace stepmill
