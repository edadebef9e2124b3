#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/batch/ledger.h"
#include "stepmill/batch/part_figures.h"

namespace stepmill {

/// A part of a batch with what came of it: a row of its tables.
struct BatchRow {
    LedgerPart part;
    Outcome outcome = Outcome::Waiting;
    std::string folder;                  ///< of its job, below jobs/; empty without one
    std::string reason;                  ///< why it is not complete; one line
    std::optional<PartFigures> figures;  ///< of its plan; nothing without one
};

/// In the list's order.
/// \param recorded  the batch's folder, where records that are not in the ledger yet
/// count too; empty: they do not
std::vector<BatchRow> rowsOf(const Ledger& ledger, const std::filesystem::path& recorded = {});

/// The features of all planned parts, each as often as its part's quantity says.
/// \throws Error(Usage) where some parts were planned for the least time and others for the least cost
std::vector<ToolTask> toolTasksOf(const std::vector<BatchRow>& rows);

/// What a tool that can be bought is worth to all planned parts, each as often as its quantity says.
struct OfferSum {
    OfferWorth worth;      ///< of all pieces; features are counted once a part
    std::string currency;  ///< each has a sum of its own
    int parts = 0;         ///< that it helps
};

/// The offers of all rows, those that save most time first.
std::vector<OfferSum> offersOf(const std::vector<BatchRow>& rows);

/// Rows that have a plan, and the tools that each plan takes.
struct PlannedTools {
    std::vector<std::size_t> rows;
    std::vector<std::vector<std::string>> tools;  ///< ids
};
PlannedTools plannedTools(const std::vector<BatchRow>& rows);

/// How many parts came to each outcome, in the order of reports, those of none left out.
std::vector<std::pair<Outcome, int>> countsOf(const std::vector<Outcome>& outcomes);

/// "12 complete, 3 gaps, 1 refused".
std::string countWords(const std::vector<Outcome>& outcomes);

/// The outcomes of rows.
std::vector<Outcome> outcomesOf(const std::vector<BatchRow>& rows);

}  // namespace stepmill
