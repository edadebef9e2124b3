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
    double mm_per_unit = 0;  ///< of lengths in the file; 0: it names no unit
};

/// Reads the curves of a STEP file, screened as readStep() does.
/// \throws Error(NotStep); Error(StepDamaged), also where a curve cannot be built; Error(NoSolid) where the
///         file has solids or faces, or no curve
StepCurves stepCurvesFromText(std::string_view text, const std::string& file);

}  // namespace stepmill
