#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "options.h"
#include "stepmill/core/supervise.h"

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

  private:
    StageBoard& board_;
    bool terminal_;
};

/// Where a command writes: --output, or "<part><suffix>" in the current folder.
std::filesystem::path outputFolder(const PlanOptions& options, const std::string& suffix);

/// Does a command's work in a child process under --timeout and --jobs and returns its exit code. Errors,
/// a stop and a crash are told on stderr; what the child left half-written beside `folder` is removed.
int runInChild(const PlanOptions& options, const std::filesystem::path& folder,
               const std::function<int(ProgressLine&)>& work);

}  // namespace stepmill
