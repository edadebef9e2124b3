#pragma once

#include <string>
#include <vector>

#include "stepmill/catalog/tool.h"

namespace stepmill {

/// A tool as another program's file tells it, in mm. Zero, empty or no list: the file does not say.
struct ForeignTool {
    std::string place;     ///< in its file: "#/data/3", "line 4"
    ToolAssembly tool;     ///< holder cylinders begin at the stick-out, at 0 where that is not said
    std::string unfit;     ///< why it is no tool that Stepmill plans with; empty: it is one
    bool is_inch = false;  ///< its lengths were given in inches
    /// What was taken in another way than it stands, and what was left aside.
    std::vector<std::string> notes;
};

/// What a file of another program holds.
struct ForeignLibrary {
    std::string file;  ///< name without folder
    std::vector<ForeignTool> tools;
    std::vector<std::string> notes = {};  ///< what of the file as a whole was left aside
};

}  // namespace stepmill
