#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "stepmill/core/file.h"
#include "stepmill/part/part.h"

namespace stepmill {

/// What a drawing of profiles does not say of the part. Lengths are in the drawing's unit.
struct DrawingOptions {
    /// How deep below the part's top the profiles of a layer go: by the layer's name, or by colour as
    /// "colour:5" (DXF's index) or "colour:#ff0000". As deep as the part is thick, or deeper: through.
    std::map<std::string, double> depths;
    std::string outline;   ///< layer or colour of the part's outer profile and of what goes through it
    double thickness = 0;  ///< of the part
    std::string unit;      ///< "mm", "cm", "m" or "inch", whatever the file says; empty: as it says
    std::uintmax_t max_file_bytes = kMaxFileBytes;

    bool given() const { return !depths.empty() || !outline.empty() || thickness != 0; }
};

/// Is it a file of profiles by its name: .dxf or .svg? A STEP file may be one of curves alone: it is taken as
/// a drawing where DrawingOptions are given.
bool isDrawing(const std::filesystem::path& file);

/// Ends of lines and curves that are no farther apart are one corner: drawings round, and hands slip [mm].
inline constexpr double kHealedGapMm = 0.02;

/// The part that a drawing's closed profiles describe [Lim2000]: the outline as thick as told, its top at z
/// 0, less the profiles of each layer down to its depth. Of profiles in each other every second is left
/// standing: islands. Lines and arcs stay what they are; ellipses and splines become the kernel's own curves,
/// which slicing takes as those of any solid.
///
/// Remarks tell what was healed and which layers were left aside.
/// \throws Error(InvalidCatalog) naming file and place: no such format, a profile that is open, crosses
///         itself or another, or lies outside the outline, entities that are no profile on a layer with a
///         depth; Error(Usage) naming the option that is missing: unit, outline, depth or thickness;
///         Error(FileUnreadable, ImplausibleSize, InvalidSolid)
/// \note  O(n log n) for n lines and arcs, but for the kernel's Booleans.
/// \see docs/drawings.md
Part readDrawing(const std::filesystem::path& file, const DrawingOptions& options);

/// The same from text in memory; `name` is the file's.
Part drawingFromText(std::string_view text, const std::string& name, const DrawingOptions& options);

}  // namespace stepmill
