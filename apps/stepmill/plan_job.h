#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "options.h"
#include "run.h"
#include "stepmill/proven/proven_plan.h"
#include "stepmill/study/offers.h"

namespace stepmill {

/// Adds the options of the commands that plan a part and write its job: those of a part, the shop, what is
/// made least, what is printed.
void addJobOptions(CLI::App& command, PlanOptions& options, const std::string& folder_suffix);

/// Adds the options about finishing passes.
void addFinishOptions(CLI::App& command, PlanOptions& options);

/// Adds all options of `stepmill plan` that change a plan: none about files, threads, limits and printing.
void addPlanningOptions(CLI::App& command, PlanOptions& options);

/// Adds --buy: tools that could be bought are weighed beside the plan.
void addOfferOptions(CLI::App& command, PlanOptions& options);

/// What a caller hears while the parts of a file are planned.
struct PlanListener {
    /// The parts that were asked for, before any is planned.
    std::function<void(const std::vector<Part>& parts)> imported;
    /// Each plan, once it is written into its folder, and what --buy is worth to it.
    std::function<void(const ProvenPlan& proven, const std::filesystem::path& folder,
                       const std::vector<OfferWorth>& offers)>
        planned;
};

/// The exit code that a plan asks for. Books that do not close and proofs that fail are bugs of ours:
/// warnings and proofs say where.
int exitCodeOf(const ProvenPlan& proven, const PlanOptions& options, const Tolerances& tol);

/// Says which proofs failed, or that books do not close, so that no program is written.
void tellFailures(const ProvenPlan& proven);

/// Plans, proves and writes the parts of the file that were asked for into the workplace's folder; prints
/// what came of it. Returns the exit code.
/// \throws Error as the stages do
int planFile(const PlanOptions& options, Workplace& place, const PlanListener& listener = {});

/// The same in a child process.
int runPlan(const PlanOptions& options);

}  // namespace stepmill
