#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/core/error.h"

namespace stepmill {

/// A solid as the file describes it.
struct StepBody {
    std::uint32_t id = 0;
    std::string name;  ///< "#15 MANIFOLD_SOLID_BREP"
    int shells = 0;
    int faces = 0;
    int edges = 0;  ///< each EDGE_CURVE once
};

/// What the text of a STEP file says before any geometry is read.
struct StepText {
    std::vector<std::string> schemas;  ///< FILE_SCHEMA, as written
    int entities = 0;
    int solid_bodies = 0;  ///< entities that claim to be solids
    int open_shells = 0;   ///< of surface models: what the file itself holds beside its solids
    bool has_length_unit = false;
    std::vector<std::string> external_files;  ///< names in DOCUMENT_FILE entities
    std::vector<std::string> remarks;
    std::vector<std::string> doubts;   ///< what the user must judge, with line and entity
    std::vector<StepBody> bodies;      ///< in file order; complex entities are left out
    std::map<std::string, int> kinds;  ///< entities of the shape by keyword
};

/// Reads the text of an ISO 10303-21 file token by token and refuses what the geometry reader cannot take
/// or would silently drop or re-make: other formats, truncation, numbers that are not finite or absurd in a
/// geometric entity, shape entities that refer to entities the file lacks or to the wrong kind, entities that
/// contain themselves or nest too deep, ids defined twice or beyond 31 bits, comments and strings too long,
/// directions and vectors of no length, radii of 0, knots that do not increase, torn loops, open shells.
///
/// What real exporters get wrong and a reader can mend is a doubt.
///
/// A dangling reference outside the shape (approvals, annotations) is a remark, since the shape is whole
/// without it.
/// \param file  what error messages name as their subject
/// \throws Error(NotStep, StepDamaged, NoSolid, OpenShell, ImplausibleSize); the message names the line
/// \note O(n log n) in the file's length
StepText screenStep(std::string_view text, const std::string& file);

/// Coordinates, radii and the like beyond this [file units] are damage: a kilometre in nanometres.
inline constexpr double kLargestGeometricNumber = 1e12;

/// Text without what may stand before the first token: byte order mark, blanks, comments.
std::string_view skipPreamble(std::string_view text);

/// What bytes that are no STEP file seem to be: "a gzip archive", "an ASCII STL mesh", "plain text", ...
std::string guessFormat(std::string_view bytes);

}  // namespace stepmill
