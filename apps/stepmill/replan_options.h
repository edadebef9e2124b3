#pragma once

#include <filesystem>
#include <vector>

#include "options.h"
#include "stepmill/record/plan_files.h"

namespace stepmill {

/// `stepmill replan`, as typed.
struct ReplanOptions {
    std::string job;                       ///< folder
    PlanOptions plan;                      ///< what is given anew, and what is filled in from the job
    std::vector<std::string> cycle_times;  ///< as typed; none: those of the job
    bool diff = false;
    bool same_part = false;  ///< none is given anew
    bool same_shop = false;  ///< neither are tools, machine, fixtures, holes and material
};

/// Fills in what is not given anew as the job's plan says: the words of its command line, and its files where
/// they lie by the names they had, with the same contents.
/// \throws Error(Usage) naming the option to give for a file that is not found
void fillFromJob(ReplanOptions& options, const PlanRecord& before);

/// The library that is given anew or the job's, and the same of the machine and of what is known of the
/// material.
/// \pre fillFromJob()
Shop shopOf(const ReplanOptions& options, const PlanRecord& before);
PlanRequest requestOf(const ReplanOptions& options, const PlanRecord& before, const Shop& shop);

}  // namespace stepmill
