#pragma once

#include <string>
#include <vector>

#include "stepmill/catalog/filled_field.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/catalog/usual_values.h"
#include "stepmill/crib/foreign_library.h"

namespace stepmill {

/// What became of one tool of another program's file.
struct ImportedTool {
    std::string place;
    std::string name;                ///< its id here; its description where it was left out
    std::string left_out;            ///< why; empty: it is in the library
    std::vector<std::string> gaps;   ///< what the file does not say, with what that means and how to fill it
    std::vector<std::string> notes;  ///< what was taken in another way than it stands
    std::vector<FilledField> filled;
};

struct ImportedLibrary {
    ToolLibrary library;              ///< in inches where all its tools were, else in mm
    std::vector<ImportedTool> tools;  ///< one a tool of the file, in its order
    std::vector<std::string> notes;   ///< of the file as a whole

    FilledFields filled() const;  ///< of the library's tools
    bool complete() const;        ///< every tool that Stepmill could plan with is in it
};

/// Makes a library of ours from another program's. Every tool gets a name and a number that no other has;
/// what is missing is filled from `usual` where that is given and listed where it is not. A tool that lacks
/// what ours must have (flutes' length, stick-out) or that breaks a rule of docs/tool-library.md is left out
/// and says why.
/// \throws Error(InvalidCatalog) when no tool remains
ImportedLibrary importTools(const ForeignLibrary& foreign, const UsualValues* usual);

/// What importTools() did, for people: a line a tool and one under it for each gap, note and filled field.
std::string importText(const ImportedLibrary& imported);

}  // namespace stepmill
