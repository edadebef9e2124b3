#pragma once

#include <memory>
#include <vector>

#include "sequence/dag/job.h"
#include "sequence/surrogates/shelf.h"
#include "stepmill/access/access.h"

namespace stepmill {

/// A tool that can work in lumps.
struct Surrogate {
    const ToolAssembly* tool = nullptr;  ///< of the job's library
    CutterArea reach;                    ///< A'_x in the whole feature
};

/// All tools that may stand in for others in a feature: what is the same for all its lumps. Safe to share
/// between threads.
class SurrogateTools {
  public:
    /// The mills of `reaches` that take part, with what each does itself.
    SurrogateTools(std::shared_ptr<const SequenceJob> job, const std::vector<ToolReach>& reaches);

    const SequenceJob& job() const { return *job_; }
    /// By falling diameter.
    const std::vector<Surrogate>& all() const { return all_; }
    /// What the surrogate's cutter alone must keep off so that its shank and holder do too; made once.
    const SharedRegion& obstruction(int surrogate) const;

  private:
    std::shared_ptr<const SequenceJob> job_;
    std::vector<Surrogate> all_;
    Shelf<int, SharedRegion> obstructions_;
};

}  // namespace stepmill
