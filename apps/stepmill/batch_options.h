#pragma once

#include <string>

#include "option_words.h"
#include "slurm.h"

namespace stepmill {

/// The options of `stepmill batch`, as typed.
struct BatchOptions {
    std::string source;   ///< a folder, or a list of parts
    std::string out_dir;  ///< of the batch
    OptionWords plan;     ///< for all parts
    RunLimits limits;     ///< of each part; its memory 0: shared by those at once
    int at_once = 0;      ///< parts; 0: one per core
    bool resume = false;
    bool retry = false;
    bool on_slurm = false;
    SlurmOptions slurm;
    double task_s = 300;  ///< what a task on the cluster is to take
    /// For tests, what the part of a file name does wrong: "NAME:hang", "NAME:memory", "NAME:crash",
    /// "NAME:task" (kills the process above its own), "NAME:wait:FILE" (until there is such a file).
    std::vector<std::string> faults;
};

}  // namespace stepmill
