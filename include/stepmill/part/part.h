#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "stepmill/core/file.h"
#include "stepmill/part/import_report.h"

namespace stepmill {

using Vec3 = Eigen::Vector3d;
using Box3 = Eigen::AlignedBox3d;

/// The OCCT solid; defined in part/part_shape.h, which only the OCCT modules include.
struct PartShape;

struct PartFace {
    int index = 0;          ///< order of TopExp_Explorer, from 0
    std::string step_name;  ///< as in the file, may be empty
    std::string surface;    ///< "plane", "cylinder", "cone", "sphere", "torus", "bspline", ...
};

/// Something about a file or a solid that its reader should know. Codes are stable words for programs:
/// "unit-doubt" and "input-doubt" say that the part may not be what was meant, "part" is for the record.
struct Remark {
    std::string code;
    std::string text;
};
inline constexpr const char* kUnitDoubt = "unit-doubt";
inline constexpr const char* kInputDoubt = "input-doubt";
inline constexpr const char* kForTheRecord = "part";

/// One healed solid in millimetres and what the file held beside it. A value: copies share the immutable
/// OCCT shape.
struct Part {
    std::string file;          ///< name without folder
    std::string sha256;        ///< of the file
    std::string name;          ///< of the product; where the file tells none, the name of the file
    std::string schema;        ///< AP203, AP214, AP242 as the header names it
    std::string unit_in_file;  ///< "mm", "inch", "m", ... or "none" when the file has none
    int solid_index = 0;       ///< of the distinct solids in the file, from 0
    int count = 1;             ///< how often an assembly uses it
    Box3 bbox_mm;
    double volume_mm3 = 0;
    std::map<std::string, int> surfaces;  ///< surface kind -> number of faces
    std::vector<PartFace> faces;
    std::vector<Remark> remarks;  ///< ignored wires, points, shells; what healing changed; unit doubts
    std::shared_ptr<const PartShape> shape;
    std::shared_ptr<const ImportReport> import;  ///< null for a part not read from a file
};

struct ReadOptions {
    /// Which distinct solid, or -1 for all.
    int solid = -1;
    /// "mm", "inch", "m" to override what the file says; empty: trust the file.
    std::string unit;
    /// Longest and shortest overall dimension a part may have [mm].
    double largest_mm = 100000;
    double smallest_mm = 0.1;
    /// A larger file is not read.
    std::uintmax_t max_file_bytes = kMaxFileBytes;
};

/// Reads a STEP file (AP203, AP214, AP242): every distinct solid a part of its own, in mm, healed.
///
/// Screens the text first for what the reader cannot survive (non-finite or absurd numbers, truncation,
/// references to nothing, a file that is not STEP). Then accounts for every face, edge and shell of the file:
/// it refuses what the geometry reader dropped, split or could not close; what the reader or healing turned
/// or re-made is an input-doubt. May still take unbounded time inside OCCT on hostile input: run it under
/// runSupervised().
/// \return  at least one part
/// \throws Error(FileUnreadable, NotStep, StepDamaged, NoSolid, OpenShell, InvalidSolid, ImplausibleSize)
/// \see docs/import.md
std::vector<Part> readStep(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace stepmill
