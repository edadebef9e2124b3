#pragma once

#include <string>

#include "option_words.h"

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
    /// For tests: "NAME:hang", "NAME:memory" or "NAME:crash" has the part of that file name do so.
    std::vector<std::string> faults;
};

}  // namespace stepmill
