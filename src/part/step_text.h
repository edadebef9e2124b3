#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stepmill/core/error.h"

namespace stepmill {

/// What the text of a STEP file says before any geometry is read.
struct StepText {
    std::vector<std::string> schemas;  ///< FILE_SCHEMA, as written
    int entities = 0;
    int solid_bodies = 0;  ///< entities that claim to be solids
    bool has_length_unit = false;
    std::vector<std::string> external_files;  ///< names in DOCUMENT_FILE entities
    std::vector<std::string> remarks;
};

/// Reads the text of an ISO 10303-21 file token by token and refuses what the geometry reader cannot take
/// or would silently drop: other formats, truncation, numbers that are not finite or absurd in a geometric
/// entity, shape entities that refer to entities the file lacks, entities that contain themselves, ids
/// defined twice.
///
/// A dangling reference outside the shape (approvals, annotations) is a remark, since the shape is whole
/// without it.
/// \param file  what error messages name as their subject
/// \throws Error(NotStep, StepDamaged, NoSolid, ImplausibleSize); the message names the line
/// \note O(n log n) in the file's length
StepText screenStep(std::string_view text, const std::string& file);

/// Coordinates, radii and the like beyond this [file units] are damage: a kilometre in nanometres.
inline constexpr double kLargestGeometricNumber = 1e12;

/// Text without what may stand before the first token: byte order mark, blanks, comments.
std::string_view skipPreamble(std::string_view text);

/// What bytes that are no STEP file seem to be: "a gzip archive", "an ASCII STL mesh", "plain text", ...
std::string guessFormat(std::string_view bytes);

}  // namespace stepmill
