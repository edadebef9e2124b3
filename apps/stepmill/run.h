#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "limits.h"
#include "options.h"
#include "stepmill/core/supervise.h"
#include "stepmill/job/job_folder.h"

namespace stepmill {

/// A line on a terminal that is overwritten; silent elsewhere. Also keeps the stage where a supervisor finds
/// it.
class ProgressLine {
  public:
    explicit ProgressLine(StageBoard& board);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(const std::string& stage, double share);
    /// The geometry kernel reads this file from now on.
    void showImport(const std::string& file);

  private:
    void draw(const std::string& stage, double share) const;

    StageBoard& board_;
    bool terminal_;
};

/// One run of a command.
struct Task {
    std::string subject;  ///< the file or folder it is about, for messages
    RunLimits limits;
    int jobs = 0;                       ///< threads; 0: one per core
    std::filesystem::path folder = {};  ///< that it writes to; empty: none
};

/// What a command's work is given.
struct Workplace {
    ProgressLine& progress;
    JobFolder* folder = nullptr;  ///< of Task::folder, locked for this run; null without one
};

/// Where a command writes: --output, or "<part><suffix>" in the current folder.
std::filesystem::path outputFolder(const PlanOptions& options, const std::string& suffix);

/// The task of a command on a part.
Task taskOf(const PlanOptions& options, const std::filesystem::path& folder = {});

/// What ended a child, for people, and the exit code that means.
struct EndWords {
    int exit_code = 0;
    std::string text;  ///< empty where it exited by itself
};
EndWords endWords(const Supervised& run, const RunLimits& limits);

/// Ends this process as the signal would have, so that a shell sees what it knows: 130, 141, 143.
void endBy(int signal);

/// Does a command's work in a child process within the task's limits and returns its exit code. Errors, a
/// stop and a crash are told on stderr, each as what it is; what a child left half-written is removed. A
/// signal to this process ends it by that signal once all is tidy.
/// \throws Error(OutputUnwritable) when the folder cannot be had
int runInChild(const Task& task, const std::function<int(Workplace&)>& work);

/// Tells which edited files a writing replaced.
void tellReplacedEdits(const JobFolder& folder);

}  // namespace stepmill
