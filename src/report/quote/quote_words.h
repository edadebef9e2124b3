#pragma once

#include <string>
#include <vector>

#include "stepmill/study/quote.h"

namespace stepmill::report {

/// What the price is made of, a line each.
std::vector<std::string> quoteContains(const Quote& quote);
/// What it leaves out.
std::vector<std::string> quoteLacks(const Quote& quote);

/// "12.50 to 13.20 EUR"; one number where both are the same.
std::string rangeWords(const Range& range, int decimals, const std::string& unit);

/// "inner corners of 4.00 mm instead of 2.00 mm".
std::string changeWords(const CheaperChange& change);
/// "saves 12.3 s and 0.31 EUR a piece (EM10 > EM8)".
std::string savingWords(const CheaperChange& change, const std::string& currency);

/// "tool change 5 s: other tools below 2.10 s, above 9.00 s"; "... the same tools at any value".
std::string breakEvenWords(const FeatureBreakEven& found, const std::string& currency);

/// From which quantity on the pieces cost more than what is paid once; empty without one.
std::string payOffWords(const Quote& quote);

}  // namespace stepmill::report
