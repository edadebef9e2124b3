#pragma once

#include <string>
#include <vector>

#include "stepmill/catalog/tool.h"

namespace stepmill {

/// A file of an export.
struct CribFile {
    std::string name;
    std::string bytes;
};

/// The library as Fusion reads it (.json), in the library's unit. Reading it back gives the same tools but
/// for what Fusion has no place for: prices, tool life, plunge depths, slot feeds, ranges of stick-outs.
std::string fusionJson(const ToolLibrary& library);

/// A FreeCAD library: `<name>.fctl` and a .fctb a tool. FreeCAD has no place for holders and cutting data.
std::vector<CribFile> freeCadFiles(const ToolLibrary& library, const std::string& name);

/// A LinuxCNC tool table, in the library's unit: T, P, the gauge length as Z where a holder is known, D, and
/// type, name and description as the remark.
std::string linuxCncTable(const ToolLibrary& library);

}  // namespace stepmill
