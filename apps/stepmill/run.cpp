#include "run.h"

#include <unistd.h>

#include <fmt/core.h>
#include <oneapi/tbb/global_control.h>

#include "commands.h"
#include "stepmill/report/report.h"

namespace stepmill {

namespace fs = std::filesystem;

ProgressLine::ProgressLine(StageBoard& board) : board_(board), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
    if (terminal_) fmt::print(stderr, "\r\033[K");
}

void ProgressLine::show(const std::string& stage, double share) {
    board_.set(stage);
    if (!terminal_) return;
    constexpr int kWidth = 30;
    const int done = std::clamp(static_cast<int>(share * kWidth), 0, kWidth);
    fmt::print(stderr, "\r\033[K[{}{}] {}", std::string(done, '#'), std::string(kWidth - done, '.'), stage);
    std::fflush(stderr);
}

fs::path outputFolder(const PlanOptions& options, const std::string& suffix) {
    return options.out_dir.empty() ? fs::path(fs::path(options.part_file).stem().string() + suffix)
                                   : fs::path(options.out_dir);
}

int runInChild(const PlanOptions& options, const fs::path& folder,
               const std::function<int(ProgressLine&)>& work) {
    const Supervised run = runSupervised(
        [&](StageBoard& board) {
            try {
                ProgressLine progress(board);
                std::optional<tbb::global_control> threads;
                if (options.jobs > 0)
                    threads.emplace(tbb::global_control::max_allowed_parallelism, options.jobs);
                return work(progress);
            } catch (const std::exception& error) {
                return reportError(error);
            }
        },
        options.timeout_s);
    if (run.end == Supervised::End::Exited) return run.exit_code;

    removeUnfinished(folder);
    const bool importing = run.last_stage.rfind("importing", 0) == 0;
    if (run.end == Supervised::End::TimedOut) {
        fmt::print(stderr, "stepmill: {}: stopped after {:g} s while {}; allow more with --timeout\n",
                   options.part_file, options.timeout_s, run.last_stage);
        return kBadInput;
    }
    fmt::print(stderr, "stepmill: {}: the geometry kernel crashed (signal {}) while {}\n", options.part_file,
               run.signal, run.last_stage);
    return importing ? kBadInput : kBug;
}

}  // namespace stepmill
