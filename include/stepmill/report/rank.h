#pragma once

#include <string>

#include "stepmill/study/rank.h"

namespace stepmill {

/// For people: the table, both sequences, break-even values, purchases.
std::string rankText(const RankReport& report);

/// The same for programs, checked against schemas/rank.schema.json before it leaves.
/// \throws Error(Internal) if it breaks the schema
std::string rankJson(const RankReport& report);

}  // namespace stepmill
