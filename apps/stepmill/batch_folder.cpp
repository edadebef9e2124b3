#include "batch_folder.h"

#include <chrono>
#include <thread>

#include <fmt/core.h>

#include "cluster_folder.h"
#include "output.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/report/batch_page.h"
#include "stepmill/report/offers.h"

namespace stepmill {

namespace fs = std::filesystem;

fs::path ledgerFile(const fs::path& batch) {
    return batch / "ledger.sqlite";
}

std::unique_ptr<FolderLock> lockBatch(const fs::path& out) {
    std::error_code why;
    fs::create_directories(out, why);
    if (why) throw Error(ErrorCode::OutputUnwritable, out.string(), "cannot be made: " + why.message());
    constexpr int kTries = 20;
    constexpr std::chrono::milliseconds kPause{100};
    for (int tried = 1;; ++tried) {
        try {
            return std::make_unique<FolderLock>(out / ".stepmill-batch-lock", out);
        } catch (const Error&) {
            if (tried == kTries) throw;
            std::this_thread::sleep_for(kPause);
        }
    }
}

std::unique_ptr<FolderLock> takeBatchFolder(const BatchOptions& options) {
    const fs::path out = options.out_dir;
    std::unique_ptr<FolderLock> lock = lockBatch(out);
    std::error_code ignored;
    if (!options.resume && fs::exists(ledgerFile(out), ignored))
        throw Error(ErrorCode::Usage, out.string(),
                    "holds a batch already; --resume goes on with it, or choose another folder");
    endOldRounds(out);
    return lock;
}

std::vector<BatchJob> jobsToDo(const BatchPlan& plan, const BatchOptions& options, const Ledger& ledger) {
    const std::map<std::string, BatchJob> known = ledger.jobs();
    std::vector<BatchJob> to_do;
    for (const BatchJob& listed : plan.jobs) {
        const auto before = known.find(listed.key.text());
        BatchJob job = before != known.end() ? before->second : listed;
        const bool gone = hasPlan(job.outcome) && !isPlanned(options.out_dir, job);
        if (gone || isDoneAgain(job.outcome, options.retry)) to_do.push_back(std::move(job));
    }
    return to_do;
}

JobLimits jobLimits(const BatchOptions& options, int at_once) {
    return {at_once, {options.limits.timeout_s, options.limits.memoryBytes()}};
}

void writeTables(const fs::path& out, const std::vector<BatchRow>& rows) {
    writeFile(out / "index.html", batchHtml(rows));
    writeFile(out / "parts.csv", partsCsv(rows));
    writeFile(out / "tools.csv", toolsCsv(rows));
    writeFile(out / "buy.csv", offersCsv(offersOf(rows)));
}

int tellBatch(const BatchOptions& options, const Ledger& ledger) {
    const std::vector<BatchRow> rows = rowsOf(ledger);
    const std::vector<Outcome> outcomes = outcomesOf(rows);
    const fs::path out = options.out_dir;
    writeTables(out, rows);
    printOut(fmt::format("{} parts: {}\nReport: {}\n", rows.size(), countWords(outcomes),
                         (out / "index.html").string()));
    return exitCodeOf(outcomes);
}

}  // namespace stepmill
