#pragma once

#include <string>
#include <vector>

#include "stepmill/batch/batch_rows.h"
#include "stepmill/study/offers.h"

namespace stepmill {

/// For people: what each tool that can be bought saves of one piece, a line each, the most time first.
std::string offersText(const std::vector<OfferWorth>& offers, const std::string& currency);

/// buy.csv: what each saves over all pieces of a batch, the most time first:
/// tool,diameter_mm,price,parts,features,saves_min,saves_cost,currency,reaches_more_cm3
std::string offersCsv(const std::vector<OfferSum>& offers);

}  // namespace stepmill
