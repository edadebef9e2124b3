#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <NCollection_DataMap.hxx>
#include <TopoDS_Shape.hxx>
#include <TopTools_ShapeMapHasher.hxx>

#include "part/step/import_account.h"
#include "stepmill/part/step_curves.h"

namespace stepmill {

/// STEP names of faces or edges. Looked up by the shape itself wherever it is placed; survives edits that are
/// told to it.
class ShapeNames {
  public:
    void set(const TopoDS_Shape& shape, const std::string& name);
    /// Empty when the shape has none.
    std::string of(const TopoDS_Shape& shape) const;

  private:
    NCollection_DataMap<TopoDS_Shape, std::string, TopTools_ShapeMapHasher> names_;
};

/// A distinct solid of the file where its first use stands.
struct ImportedSolid {
    TopoDS_Shape shape;
    int count = 1;
    std::string name;  ///< of the product, else of the solid, may be empty
};

/// What lies beside the solids.
struct Strays {
    int shells = 0;  ///< not part of a solid
    int shell_free_edges = 0;
    int faces = 0;   ///< not part of a shell
    int edges = 0;   ///< not part of a face
    int points = 0;  ///< not part of an edge
    int shell_faces = 0;
};

struct StepImport {
    std::vector<ImportedSolid> solids;  ///< in file order
    Strays strays;
    ShapeNames face_names;
    std::vector<BodyAccount> bodies;  ///< solid entities of the file and what became of them
    std::vector<StepCurve> curves;    ///< edges of no face, where there are no solids
    std::vector<std::string> units;   ///< length units, each once, as the file names them
};

/// Runs OCCT's reader over the text, lengths in mm. Says nothing on the standard streams.
/// \pre screenStep() took the text
/// \throws Error(StepDamaged) when the reader gives up
StepImport importStep(std::string_view text, const std::string& file);

}  // namespace stepmill
