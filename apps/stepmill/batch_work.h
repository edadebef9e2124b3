#pragma once

#include <filesystem>

#include "batch_list.h"
#include "stepmill/batch/run_jobs.h"

namespace stepmill {

/// Plans one job of a batch, in its own process: the work of JobWork::plan.
/// \param threads  it may use
int planBatchJob(const BatchOptions& options, const BatchPlan& plan, const BatchJob& job, int threads,
                 JobFolder& folder, StageBoard& board);

}  // namespace stepmill
