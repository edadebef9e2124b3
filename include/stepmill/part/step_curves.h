#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <TopoDS_Edge.hxx>

namespace stepmill {

/// A curve of a STEP file that bounds no face.
struct StepCurve {
    TopoDS_Edge edge;  ///< in mm
    /// The layer the file puts it on; without one the name of its set of curves, or of their product. May be
    /// empty.
    std::string layer;
};

/// The curves of a file without solids, in the order of the file.
struct StepCurves {
    std::vector<StepCurve> curves;
    std::string unit;        ///< of lengths in the file: "mm", "inch"; empty: it names none
    double mm_per_unit = 0;  ///< 0: it names none
    std::string schema;      ///< as Part::schema
};

/// Reads the curves of a STEP file, screened as readStep() does.
/// \throws Error(NotStep, StepDamaged); Error(NoSolid) where it has solids or faces, or no curve
StepCurves stepCurvesFromText(std::string_view text, const std::string& file);

}  // namespace stepmill
