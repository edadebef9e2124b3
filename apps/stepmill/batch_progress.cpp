#include "batch_progress.h"

#include <cstdio>

#include <unistd.h>

#include <fmt/core.h>

#include "output.h"
#include "stepmill/batch/batch_rows.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/core/units.h"

namespace stepmill {

namespace {

std::string hoursAndMinutes(double seconds) {
    const auto whole = static_cast<long>(seconds);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

BatchProgress::BatchProgress(const BatchPlan& plan, const std::vector<BatchJob>& to_do)
    : terminal_(::isatty(STDERR_FILENO) != 0), start_(std::chrono::steady_clock::now()) {
    for (const LedgerPart& part : plan.parts)
        names_[part.key].push_back(part.name);
    for (const BatchJob& job : to_do)
        to_do_ += static_cast<int>(names_[job.key.text()].size());
    if (terminal_) drawBar();
}

void BatchProgress::done(const BatchJob& job) {
    if (terminal_) {
        const std::size_t parts = names_[job.key.text()].size();
        done_ += static_cast<int>(parts);
        outcomes_.insert(outcomes_.end(), parts, job.outcome);
        drawBar();
    } else {
        printLines(job);
    }
}

void BatchProgress::printLines(const BatchJob& job) {
    for (const std::string& name : names_[job.key.text()])
        printOut(fmt::format("{}/{} {} {} {:.1f} s\n", ++done_, to_do_, toString(job.outcome),
                             plainLine(name), job.seconds));
    flushOut();
}

void BatchProgress::drawBar() const {
    constexpr int kWidth = 30;
    const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const int filled = to_do_ > 0 ? kWidth * done_ / to_do_ : kWidth;
    std::string words;
    if (done_ > 0)
        words = fmt::format("{}, {:.0f} parts/h, {} left", countWords(outcomes_),
                            kSecondsPerHour * done_ / elapsed_s,
                            hoursAndMinutes(elapsed_s / done_ * (to_do_ - done_)));
    fmt::print(stderr, "\r\033[K[{}{}] {}/{} {}", std::string(static_cast<std::size_t>(filled), '#'),
               std::string(static_cast<std::size_t>(kWidth - filled), '.'), done_, to_do_, words);
    std::fflush(stderr);
}

void BatchProgress::end() const {
    if (terminal_) std::fputs("\r\033[K", stderr);
}

}  // namespace stepmill
