#pragma once

#include <string>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/part/face_graph.h"

namespace stepmill {

/// One bore, countersink or point of a hole.
struct HoleStep {
    enum class Kind {
        Bore,   ///< cylinder
        Cone,   ///< countersink, or taper between two bores
        Point,  ///< what a drill's point leaves
    };
    Kind kind = Kind::Bore;
    double diameter_mm = 0;      ///< of a cone its wider end
    double end_diameter_mm = 0;  ///< at the lower end
    double top_mm = 0;           ///< depth below the hole's entry
    double bottom_mm = 0;
    std::vector<int> faces;
};

enum class HoleKind { Plain, Counterbored, Countersunk };

/// Round hollows on one axis that open into each other, from the entry down.
struct Hole {
    std::string id;  ///< "H1", by least face index
    HoleKind kind = HoleKind::Plain;
    bool through = false;
    bool drill_point = false;   ///< blind and pointed
    Vec3 entry = Vec3::Zero();  ///< on the axis, where the hole begins; part coordinates
    Vec3 axis = Vec3::UnitZ();  ///< out of the hole; of a through hole at the wider end
    std::vector<HoleStep> steps;
    std::vector<int> faces;  ///< of all steps, ascending

    double depth_mm() const { return steps.empty() ? 0 : steps.back().bottom_mm; }
    /// The narrowest bore: what is drilled first.
    /// \pre steps not empty
    double diameter_mm() const;
};
/// "through hole", "counterbored blind hole", "countersunk through hole", ...
std::string holeName(const Hole& hole);

/// The part's holes: hollow cylinders that go all round, with the cones and wider or narrower cylinders on
/// the same axis that follow each other without a gap. Threads are not guessed.
///
/// A cone whose wider end is less than kCountersinkShare wider than its bore is a broken edge, not a
/// countersink; the hole is then plain.
std::vector<Hole> findHoles(const FaceGraph& graph, const Tolerances& tol);

/// From this ratio of a cone's ends on it is a countersink.
inline constexpr double kCountersinkShare = 1.25;

}  // namespace stepmill
