#include "stepmill/batch/batch_rows.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "stepmill/batch/cluster_jobs.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

/// What a job told, on one line; commands begin theirs with the program's name.
std::string lineOf(const std::string& message) {
    constexpr std::string_view kProgram = "stepmill: ";
    std::istringstream lines(message);
    std::string all;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(kProgram)) line.erase(0, kProgram.size());
        if (!line.empty()) all += (all.empty() ? "" : "; ") + line;
    }
    return all;
}

BatchRow rowOf(LedgerPart part, const std::map<std::string, BatchJob>& jobs) {
    BatchRow row;
    row.part = std::move(part);
    const auto job = jobs.find(row.part.key);
    if (!row.part.trouble.empty()) {
        row.outcome = Outcome::Missing;
        row.reason = row.part.trouble;
    } else if (job != jobs.end()) {
        row.outcome = job->second.outcome;
        row.folder = job->second.folder;
        row.reason = lineOf(job->second.message);
        if (!job->second.figures.empty()) row.figures = figuresFromJson(job->second.figures);
        // What stays of a complete part is rounding.
        if (row.outcome == Outcome::Complete) row.reason.clear();
        if (row.figures && row.outcome == Outcome::Gaps) row.reason = row.figures->reason;
    }
    return row;
}

}  // namespace

std::vector<BatchRow> rowsOf(const Ledger& ledger, const std::filesystem::path& recorded) {
    std::map<std::string, BatchJob> jobs = ledger.jobs();
    if (!recorded.empty())
        for (auto& [key, job] : jobs)
            if (job.outcome == Outcome::Waiting) job = recordedJob(recorded, job).job;
    std::vector<BatchRow> rows;
    for (LedgerPart& part : ledger.parts())
        rows.push_back(rowOf(std::move(part), jobs));
    return rows;
}

std::vector<ToolTask> toolTasksOf(const std::vector<BatchRow>& rows) {
    std::vector<ToolTask> tasks;
    std::optional<bool> in_money;
    for (const BatchRow& row : rows) {
        if (!row.figures || row.figures->tasks.empty()) continue;
        if (in_money.value_or(row.figures->tasks_in_money) != row.figures->tasks_in_money)
            throw Error(
                ErrorCode::Usage, row.part.name,
                "is planned for another objective than parts before it; their tools cannot be weighed "
                "together");
        in_money = row.figures->tasks_in_money;
        for (ToolTask task : row.figures->tasks) {
            task.pieces *= row.part.quantity;
            tasks.push_back(std::move(task));
        }
    }
    return tasks;
}

std::vector<OfferSum> offersOf(const std::vector<BatchRow>& rows) {
    std::map<std::pair<std::string, std::string>, OfferSum> sums;
    for (const BatchRow& row : rows) {
        if (!row.figures) continue;
        for (const OfferWorth& offer : row.figures->offers) {
            OfferSum& sum = sums[{offer.tool_id, row.figures->currency}];
            const int features = sum.worth.features + offer.features;
            const double saves_s = sum.worth.saves_s + row.part.quantity * offer.saves_s;
            const double saves_cost = sum.worth.saves_cost + row.part.quantity * offer.saves_cost;
            const double more_mm3 = sum.worth.more_mm3 + row.part.quantity * offer.more_mm3;
            sum.worth = {offer.tool_id, offer.diameter_mm, offer.price, features,
                         saves_s,       saves_cost,        more_mm3};
            sum.currency = row.figures->currency;
            ++sum.parts;
        }
    }
    std::vector<OfferSum> offers;
    for (auto& [key, sum] : sums)
        offers.push_back(std::move(sum));
    std::stable_sort(offers.begin(), offers.end(),
                     [](const OfferSum& a, const OfferSum& b) { return a.worth.saves_s > b.worth.saves_s; });
    return offers;
}

PlannedTools plannedTools(const std::vector<BatchRow>& rows) {
    PlannedTools planned;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        if (!hasPlan(rows[row].outcome) || !rows[row].figures) continue;
        planned.rows.push_back(row);
        std::vector<std::string>& ids = planned.tools.emplace_back();
        for (const ToolUse& use : rows[row].figures->tools)
            ids.push_back(use.tool_id);
    }
    return planned;
}

std::vector<Outcome> outcomesOf(const std::vector<BatchRow>& rows) {
    std::vector<Outcome> outcomes;
    outcomes.reserve(rows.size());
    for (const BatchRow& row : rows)
        outcomes.push_back(row.outcome);
    return outcomes;
}

std::vector<std::pair<Outcome, int>> countsOf(const std::vector<Outcome>& outcomes) {
    std::vector<std::pair<Outcome, int>> counts;
    for (const Outcome outcome : allOutcomes()) {
        const auto count = std::count(outcomes.begin(), outcomes.end(), outcome);
        if (count > 0) counts.emplace_back(outcome, static_cast<int>(count));
    }
    return counts;
}

std::string countWords(const std::vector<Outcome>& outcomes) {
    std::string words;
    for (const auto& [outcome, count] : countsOf(outcomes))
        words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, toString(outcome));
    return words.empty() ? "no parts" : words;
}

}  // namespace stepmill
