#include "run.h"

#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>

#include <unistd.h>

#include <fmt/core.h>
#include <oneapi/tbb/global_control.h>

#include "commands.h"
#include "output.h"
#include "stepmill/core/plain_text.h"

namespace stepmill {

namespace fs = std::filesystem;

ProgressLine::ProgressLine(StageBoard& board) : board_(board), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
    if (terminal_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(const std::string& stage, double share) {
    board_.set(stage);
    draw(stage, share);
}

void ProgressLine::showImport(const std::string& file) {
    const std::string stage = "importing " + fs::path(file).filename().string();
    board_.set(stage, StageBoard::Reads::Input);
    draw(stage, 0);
}

void ProgressLine::draw(const std::string& stage, double share) const {
    if (!terminal_) return;
    constexpr int kWidth = 30;
    const int done = std::clamp(static_cast<int>(share * kWidth), 0, kWidth);
    fmt::print(stderr, "\r\033[K[{}{}] {}", std::string(done, '#'), std::string(kWidth - done, '.'),
               plainLine(stage));
    std::fflush(stderr);
}

fs::path outputFolder(const PlanOptions& options, const std::string& suffix) {
    return options.out_dir.empty() ? fs::path(fs::path(options.part_file).stem().string() + suffix)
                                   : fs::path(options.out_dir);
}

Task taskOf(const PlanOptions& options, const fs::path& folder) {
    return {options.part_file, options.limits, options.jobs, folder};
}

namespace {

/// What runs in the child.
int workGuarded(const Task& task, const std::function<int(Workplace&)>& work, JobFolder* folder,
                StageBoard& board) {
    try {
        std::optional<tbb::global_control> threads;
        if (task.jobs > 0) threads.emplace(tbb::global_control::max_allowed_parallelism, task.jobs);
        ProgressLine progress(board);
        Workplace place{progress, folder};
        const int exit_code = work(place);
        flushOut();
        return exit_code;
    } catch (const std::bad_alloc&) {
        throw;  // the supervisor tells
    } catch (const std::exception& error) {
        return reportError(error);
    }
}

Supervised supervise(const Task& task, const std::function<int(Workplace&)>& work) {
    std::optional<JobFolder> folder;
    if (!task.folder.empty()) folder.emplace(task.folder);
    const Supervised run = runSupervised(
        [&](StageBoard& board) { return workGuarded(task, work, folder ? &*folder : nullptr, board); },
        task.limits.timeout_s, task.limits.memoryBytes());
    // Of a file with several solids.
    if (folder && run.end != Supervised::End::Exited) tidyFoldersBelow(folder->path());
    return run;
}

std::string killWords(int signal) {
    if (signal == SIGXCPU) return "was ended by the limit on processor time (ulimit -t)";
    if (signal == SIGKILL) return "was killed (SIGKILL); the system does that when memory runs out";
    return fmt::format("was ended by signal {} ({})", signal, ::strsignal(signal));
}

/// A crash while a file is imported is the geometry kernel's answer to that file.
EndWords crashWords(const Supervised& run, const std::string& during) {
    const std::string signal = fmt::format("signal {} ({})", run.signal, ::strsignal(run.signal));
    if (run.reads == StageBoard::Reads::Input)
        return {kBadInput, fmt::format("the geometry kernel crashed{}: {}", during, signal)};
    return {kBug, fmt::format("crashed{}: {}; this is a bug in Stepmill", during, signal)};
}

int tellEnd(const Task& task, const Supervised& run) {
    if (run.end == Supervised::End::Exited) return run.exit_code;
    const EndWords words = endWords(run, task.limits);
    // Whoever closed a pipe wants to hear no more.
    const bool closed_pipe = run.end == Supervised::End::Killed && run.signal == SIGPIPE;
    if (!closed_pipe) tell("{}: {}", task.subject, words.text);
    return words.exit_code;
}

}  // namespace

EndWords endWords(const Supervised& run, const RunLimits& limits) {
    const std::string during = run.last_stage.empty() ? "" : " while " + run.last_stage;
    switch (run.end) {
        case Supervised::End::Exited:
            return {run.exit_code, ""};
        case Supervised::End::TimedOut:
            return {kBadInput, fmt::format("stopped after {:g} s{}; allow more with --timeout",
                                           limits.timeout_s, during)};
        case Supervised::End::OutOfMemory:
            return {kBadInput, fmt::format("ran out of memory{} (limit {:g} GB); allow more with --memory",
                                           during, limits.memory_gb)};
        case Supervised::End::Stopped:
            return {kBadInput,
                    fmt::format("stopped by signal {} ({}){}", run.signal, ::strsignal(run.signal), during)};
        case Supervised::End::Killed:
            return {kBadInput, killWords(run.signal) + during};
        case Supervised::End::Crashed:
            return crashWords(run, during);
    }
    return {kBug, ""};
}

void endBy(int signal) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

int runInChild(const Task& task, const std::function<int(Workplace&)>& work) {
    Supervised run;
    int exit_code = kBug;
    {
        const StopSignals held;
        run = supervise(task, work);
        exit_code = tellEnd(task, run);
    }
    const bool closed_pipe = run.end == Supervised::End::Killed && run.signal == SIGPIPE;
    if (run.end == Supervised::End::Stopped || closed_pipe) endBy(run.signal);
    return exit_code;
}

void tellReplacedEdits(const JobFolder& folder) {
    for (const std::string& name : folder.replacedEdits())
        tell("{}: had been edited since it was written, and is replaced", (folder.path() / name).string());
}

}  // namespace stepmill
