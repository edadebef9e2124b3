#pragma once

#include <string>
#include <vector>

#include "stepmill/batch/batch_rows.h"
#include "stepmill/batch/magazine.h"
#include "stepmill/batch/part_order.h"

namespace stepmill {

/// index.html of a batch: counts, and a table of all parts that is sorted, filtered and searched in the
/// browser, with links to the reports below jobs/. Same rows, same bytes.
std::string batchHtml(const std::vector<BatchRow>& rows);

/// parts.csv: the same table [RFC 4180]. Words that a spreadsheet would take for a formula begin with a
/// single quote.
std::string partsCsv(const std::vector<BatchRow>& rows);

/// tools.csv: what each tool does in all planned parts, one piece of each; by id:
/// tool,diameter_mm,parts,operations,visits,cutting_min,life_used,cutters
/// The last counts quantities: how many of the tool all pieces use up, by its life where the library gives
/// it.
std::string toolsCsv(const std::vector<BatchRow>& rows);

/// For people: the tools, what they take of all parts, how far from the best that may be.
std::string magazineText(const Magazine& magazine);

/// magazine.csv: what each tool is worth beside those in the magazine, by id:
/// tool,in_magazine,serves_alone,saves
std::string magazineCsv(const Magazine& magazine);

/// order.csv: the planned parts in the order in which few tools are exchanged between them; at the end,
/// without a position, those that need more tools than there are places: position,part,tools
std::string orderCsv(const std::vector<BatchRow>& rows, const PlannedTools& planned, const PartOrder& order);

/// For people.
std::string orderText(const PartOrder& order);

}  // namespace stepmill
