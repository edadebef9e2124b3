#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "batch_list.h"
#include "stepmill/batch/outcome.h"

namespace stepmill {

/// Tells how far a batch is: a bar with rate and time left on a terminal, a line a part on standard output
/// elsewhere.
class BatchProgress {
  public:
    /// \param to_do  jobs of the plan that this run does
    BatchProgress(const BatchPlan& plan, const std::vector<BatchJob>& to_do);

    /// A job of the plan is done, and with it all parts that it stands for.
    void done(const BatchJob& job);
    /// Takes the bar away.
    void end() const;

  private:
    void drawBar() const;
    void printLines(const BatchJob& job);

    bool terminal_;
    std::chrono::steady_clock::time_point start_;
    int to_do_ = 0;  ///< parts
    int done_ = 0;
    std::vector<Outcome> outcomes_;
    std::map<std::string, std::vector<std::string>> names_;  ///< of the parts, by key
};

}  // namespace stepmill
