#pragma once

#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/feature/form_ground.h"
#include "stepmill/layers/layer_stack.h"

namespace stepmill {

/// The sharp edges of a part that a setup sees from above, between a level face and an upright wall below it,
/// and what goes where they are broken: of every edge a strip of its level face, as wide as the break on the
/// top and nothing as far below. All in setup coordinates.
class EdgeBreaks {
  public:
    EdgeBreaks(const LayerStack& layers, double width_mm, const Tolerances& tol);

    /// The stretches of edges of one level face; the face lies on their left.
    struct FaceEdges {
        double z_mm = 0;
        Region face;
        std::vector<Path> edges;
    };
    double widthMm() const { return width_mm_; }
    /// From below.
    const std::vector<FaceEdges>& faces() const { return faces_; }
    /// Edges over walls lower than the break: they stay as they are.
    const std::vector<SharpStretch>& lowWalls() const { return low_walls_; }

    /// What may go of the part at some height between the two, and no more; both sections share its walls.
    Region mayGo(double bottom_mm, double top_mm) const;
    /// What goes half-way up between the two.
    Region goesHalfWay(double bottom_mm, double top_mm) const;

  private:
    void addFace(const LayerStack& layers, const FaceTrace& floor);
    Region stripsAt(double z_mm, double bottom_mm, double top_mm) const;

    double width_mm_;
    Tolerances tol_;
    std::vector<FaceEdges> faces_;
    std::vector<SharpStretch> low_walls_;
};

/// The middle of a stretch of an edge at that height, with its length.
SharpStretch sharpStretch(const Path& edge, double z_mm, std::string why);

}  // namespace stepmill
