#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "stepmill/catalog/tool.h"
#include "stepmill/crib/foreign_library.h"
#include "stepmill/crib/read_foreign.h"

// What all readers do with what they read.

namespace stepmill::crib {

/// Sizes that a cutter can have, as docs/tool-library.md says [mm].
inline constexpr double kThinnestMm = 0.01;
inline constexpr double kWidestMm = 500;
/// More tools than any library has: beyond it a file is no library.
inline constexpr std::size_t kMostTools = 20000;

/// mm of "mm", "millimeters", "inch", "inches", "in"; nothing for other words.
std::optional<double> mmPerUnit(std::string_view word);

/// The unit that the options tell, in mm.
/// \throws Error(Usage) where they tell none
double toldUnitMm(const ForeignOptions& options, const std::string& file);

/// A number as people write it in a cell or remark, a decimal comma allowed; nothing for other words.
std::optional<double> numberOf(std::string_view text);

/// Fits a text of strangers into a field of ours: one line of at most `most` bytes, fit for a terminal.
std::string fieldText(std::string_view text, std::size_t most);

/// \throws Error(InvalidCatalog) naming file and place
[[noreturn]] void refuse(const std::string& file, const std::string& place, const std::string& message);

/// The material's name here. Other programs' presets name one by words of their own.
std::string materialName(const ForeignOptions& options, const std::string& preset,
                         const std::string& material);

/// Adds data unless the tool has some for that material already, or they lack speed or feed; then a note says
/// so.
void addCutting(ForeignTool& foreign, const std::string& preset, CuttingData data);

/// Checks and completes a tool that was read: a diameter, sizes that follow from its type, a tap's thread.
/// \param pitch_mm  of a tap; 0: not told
/// \throws Error(InvalidCatalog) for a diameter that is missing or absurd, unless such tools are left out
void finishTool(ForeignTool& foreign, double pitch_mm, const std::string& file,
                const ForeignOptions& options);

/// Puts a holder's cylinders on top of the stick-out, one after another.
/// \param heights of each [mm]
void stackHolder(ToolAssembly& tool);

}  // namespace stepmill::crib
