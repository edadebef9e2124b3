#pragma once

#include <string>

#include "stepmill/study/quote.h"

namespace stepmill {

/// For people: lots with times and prices, what they contain, what would make the part cheaper.
std::string quoteText(const Quote& quote);

/// quote.json, checked against schemas/quote.schema.json before it leaves.
/// \throws Error(Internal) if it breaks the schema
std::string quoteJson(const Quote& quote);

/// One self-contained HTML page.
std::string quoteHtml(const Quote& quote);

/// The first line of a table of quotes.
std::string quoteCsvHead();
/// A line a lot.
std::string quoteCsvLines(const Quote& quote);

}  // namespace stepmill
